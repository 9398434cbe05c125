// Pointer, touch and keys on the three pictures.

// The direction of the ball that is under the pointer; beside the ball, its nearest rim.
function ballPlace(event) {
  const [x, y] = place(at("ball"), event).map((c) => c / RADIUS);
  const r = Math.hypot(x, y);
  const [u, v] = r > 0.999 ? [(0.999 * x) / r, (0.999 * y) / r] : [x, y];
  return directionAt(state.axes, u, v);
}

// The grip under the pointer, also below the mark of a crossing: an end, else the chosen line.
function gripUnder(event) {
  const under = document.elementsFromPoint(event.clientX, event.clientY).map((e) => /** @type {HTMLElement} */ (e.closest("[data-grip]"))).filter(Boolean);
  const first = under.find((e) => e.matches(".end")) ?? under.find((e) => e.matches(".chosen")) ?? under[0];
  return first?.dataset.grip ?? null;
}

// Drags a grip, or what is behind the grips.
function listenToGrips(view, toPlace, behind) {
  let latest = null;
  const follow = () => {
    if (!latest) return;
    const { grip, event } = latest;
    latest = null;
    const normal = movedTo(grip, toPlace(event));
    if (normal) setNormal(grip.k, normal);
  };
  const followSoon = oncePerFrame(follow);
  onDrag(view, {
    hold(event) {
      const name = player.step ? null : gripUnder(event);
      const grip = name ? gripOf(name) : null;
      if (grip) {
        choose(grip.k);
        hold();
      }
      return { grip };
    },
    drag({ grip, dx, dy }, event) {
      const { a } = view.getScreenCTM();
      latest = grip && { grip, event };
      if (grip) followSoon();
      else behind(dx / a, dy / a);
    },
    end() {
      follow();
      release();
    },
  });
}

function pan(dx, dy) {
  state.middle = [state.middle[0] - dx / scale(), state.middle[1] + dy / scale()];
  refresh();
}

function turnBall(dx, dy) {
  state.axes = turnedAxes(state.axes, dx / RADIUS, dy / RADIUS);
  refresh();
}

const TURNS = { "[": 1, "]": -1 };

// What a key does to the grip that has the focus.
function gripKey({ key, target }) {
  const name = player.step ? null : target.dataset.grip;
  if (!name) return null;
  if (key === "Delete" || key === "Backspace") return () => removePlane(gripOf(name).k);
  if (!(key in ARROWS) && !(key in TURNS)) return null;
  return () => {
    const grip = gripOf(name);
    choose(grip.k);
    setNormal(grip.k, stepped(grip, ARROWS[key] ?? [0, 0], TURNS[key] ?? 0));
  };
}

// From region to region, or from crossing to crossing.
function markNext(kind) {
  const { arrangement } = shown();
  const list = kind === "point" ? arrangement.circles.crossings.map((_, p) => `point-${p}`)
    : [...new Set(facesOf(arrangement).regions.map((region) => regionName(arrangement, region)))];
  if (!list.length) return;
  lit.mark = list[(list.indexOf(lit.mark) + 1) % list.length];
  markAll();
  say(toldInLine(lit.mark));
}

function markAll() {
  highlight();
  at("lit-words").textContent = toldInLine(lit.mark);
}

function listen() {
  const marks = { n: () => markNext("region"), v: () => markNext("point") };
  listenToGrips(at("plane"), worldAt, pan);
  onKeys(at("plane"), { ...marks, ...arrowKeys((x, y) => pan(-12 * x, 12 * y)), ...ZOOMS, Home: () => { fitPlane(); chooseAxes(); refresh(); } }, gripKey);
  for (const view of [at("ball"), at("dual")]) {
    listenToGrips(view, ballPlace, turnBall);
    onKeys(view, { ...marks, ...arrowKeys((x, y) => turnBall(9 * x, -9 * y)) }, gripKey);
  }
  listenToWheel();
}
