// Exact fields of the chosen plane; planes that come and go.

function choose(k) {
  state.chosen = k;
  refresh();
}

function writeFields() {
  const tabs = at("tabs");
  const flat = state.dimension === 2;
  at("editor-title").textContent = flat ? "Lines a x + b y = c" : "Planes a x + b y + c z = 0, lines of the projective plane";
  const wanted = `${state.rows.length}/${state.chosen}`;
  if (tabs.dataset.shown !== wanted) {
    const held = /** @type {HTMLElement} */ (document.activeElement)?.dataset?.tab;
    tabs.dataset.shown = wanted;
    tabs.replaceChildren();
    state.rows.forEach((_, k) => {
      const button = make("button", { "aria-pressed": String(k === state.chosen), "data-tab": k, "aria-label": `plane ${k + 1}` }, tabs, String(k + 1));
      button.addEventListener("click", () => choose(k));
    });
    const add = make("button", { id: "add" }, tabs, "add");
    add.disabled = state.rows.length >= data.most;
    add.addEventListener("click", addPlane);
    const remove = make("button", { id: "remove" }, tabs, "remove");
    remove.disabled = state.chosen === null;
    remove.addEventListener("click", () => removePlane(state.chosen));
    at("fields").replaceChildren();
    if (state.chosen === null) make("p", { class: "hint" }, at("fields"), "Choose a line, here or in a picture.");
    else ["a", "b", "c"].forEach((name, j) => field(at("fields"), `row-${name}`, name, (value) => setEntry(j, value)));
    if (held !== undefined) tabs.querySelector(`[data-tab="${held}"]`)?.focus();
  }
  if (state.chosen !== null) ["a", "b", "c"].forEach((name, j) => write(`row-${name}`, state.rows[state.chosen][j]));
}

// Returns what is wrong with an entry, if anything.
function setEntry(j, value) {
  const row = state.rows[state.chosen].with(j, value);
  const problem = problemOf({ dimension: state.dimension, rows: state.rows.with(state.chosen, row) });
  if (problem) return `${problem}.`;
  edit(() => { state.rows = state.rows.with(state.chosen, row); });
  return "";
}

// The first of a list of small normals that makes the most regions.
function addPlane() {
  if (state.rows.length >= data.most) return;
  const candidates = [];
  for (let a = -3n; a <= 3n; a += 1n) for (let b = -3n; b <= 3n; b += 1n) for (let c = 0n; c <= 3n; c += 1n) candidates.push([a, b, c]);
  const length = (v) => v.reduce((sum, x) => sum + x * x, 0n);
  const usable = candidates.filter(([a, b, c]) => (a || b) && (state.dimension === 2 || c)).sort((v, w) => Number(length(v) - length(w)));
  const { circles } = shown().arrangement;
  const met = (v) => {
    const n = state.dimension === 2 ? [v[0], v[1], -v[2]] : v;
    const through1 = circles.crossings.filter(({ ray }) => !dotOf(n, ray)).length;
    return circles.normals.some((m) => !crossOf(m, n).some((x) => x)) ? 1000 : through1;
  };
  const row = usable.map((v) => [met(v), v]).reduce((best, one) => (one[0] < best[0] ? one : best))[1];
  edit(() => {
    state.rows = [...state.rows, row.map((x) => ratio(x))];
    state.chosen = state.rows.length - 1;
  });
}

function removePlane(k) {
  if (k === null || !state.rows[k]) return;
  edit(() => {
    state.rows = state.rows.filter((_, i) => i !== k);
    state.chosen = state.rows.length ? Math.min(k, state.rows.length - 1) : null;
  });
}
