// Exact fields of the chosen plane; planes that come and go.

function choose(k) {
  state.chosen = k;
  refresh();
}

function writeFields() {
  const flat = state.dimension === 2;
  at("editor-title").textContent = flat ? "Lines a x + b y = c" : "Planes a x + b y + c z = 0, lines of the projective plane";
  const build = (box) => ["a", "b", "c"].forEach((name, j) => field(box, `row-${name}`, name, (value) => setEntry(j, value)));
  writeTabs("plane", state.rows.length, state.chosen, { choose, add: addPlane, remove: removePlane, build });
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
  addTo("rows", row.map((x) => ratio(x)));
}

const removePlane = (k) => removeFrom("rows", k);
