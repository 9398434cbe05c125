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

// Drags a grip, or what is behind the grips. A second finger is left alone.
function dragged(view, toPlace, behind) {
  let held = null;
  const follow = () => {
    if (!held?.event) return;
    const { event, grip } = held;
    held.event = null;
    const normal = movedTo(grip, toPlace(event));
    if (normal) setNormal(grip.k, normal);
  };
  const followSoon = oncePerFrame(follow);
  view.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button) return;
    const name = player.step ? null : gripUnder(event);
    held = { grip: name ? gripOf(name) : null, x: event.clientX, y: event.clientY, moved: false };
    if (held.grip) {
      choose(held.grip.k);
      hold();
    }
    view.setPointerCapture(event.pointerId);
  });
  view.addEventListener("pointermove", (event) => {
    if (!held || !event.isPrimary) return;
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    held.moved ||= Math.hypot(dx, dy) > 3;
    if (!held.moved) return;
    if (held.grip) {
      held.event = event;
      followSoon();
    } else {
      const { a } = view.getScreenCTM();
      behind(dx / a, dy / a);
      Object.assign(held, { x: event.clientX, y: event.clientY });
    }
  });
  const end = () => {
    follow();
    held = null;
    release();
  };
  view.addEventListener("pointerup", end);
  view.addEventListener("pointercancel", end);
}

function pan(dx, dy) {
  state.middle = [state.middle[0] - dx / scale(), state.middle[1] + dy / scale()];
  refresh();
}

function turnBall(dx, dy) {
  state.axes = turnedAxes(state.axes, dx / RADIUS, dy / RADIUS);
  refresh();
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const TURNS = { "[": 1, "]": -1 };

function keysOn(view, own) {
  view.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const name = player.step ? null : event.target.dataset.grip;
    const { key } = event;
    if (name && (key in ARROWS || key in TURNS)) {
      const grip = gripOf(name);
      choose(grip.k);
      const normal = stepped(grip, ARROWS[key] ?? [0, 0], TURNS[key] ?? 0);
      if (normal) setNormal(grip.k, normal);
    } else if (name && (key === "Delete" || key === "Backspace")) removePlane(gripOf(name).k);
    else if (own[key]) own[key]();
    else return;
    event.preventDefault();
  });
}

// From region to region, or from crossing to crossing.
function markNext(kind) {
  const { arrangement } = shown();
  const list = kind === "point" ? arrangement.circles.crossings.map((_, p) => `point-${p}`)
    : [...new Set(facesOf(arrangement).regions.map((region) => regionName(arrangement, region)))];
  if (!list.length) return;
  lit.mark = list[(list.indexOf(lit.mark) + 1) % list.length];
  markAll();
  say(litText());
}

function markAll() {
  highlight();
  at("lit-words").textContent = litText();
}

function listen() {
  dragged(at("plane"), worldAt, pan);
  dragged(at("ball"), ballPlace, turnBall);
  dragged(at("dual"), ballPlace, turnBall);
  listenToWheel();
  const marks = { n: () => markNext("region"), v: () => markNext("point") };
  const turns = Object.fromEntries(Object.entries(ARROWS).map(([key, [x, y]]) => [key, () => turnBall(9 * x, -9 * y)]));
  const pans = Object.fromEntries(Object.entries(ARROWS).map(([key, [x, y]]) => [key, () => pan(-12 * x, 12 * y)]));
  keysOn(at("plane"), { ...marks, ...pans, ...ZOOMS, Home: () => { fitPlane(); chooseAxes(); refresh(); } });
  keysOn(at("ball"), { ...marks, ...turns });
  keysOn(at("dual"), { ...marks, ...turns });
}
