// The page of lines and great circles: how it begins, and how it is drawn anew.
const refresh = oncePerFrame(() => {
  const focus = /** @type {HTMLElement} */ (document.activeElement?.closest("svg [data-grip]"))?.dataset.grip;
  state.labels = [];
  paintPlane();
  paintBall();
  paintDual();
  describe();
  writeFields();
  showLegend();
  markAll();
  if (focus) /** @type {HTMLElement} */ (document.querySelector(`[data-grip="${CSS.escape(focus)}"]`))?.focus();
});

// The chart in which the fewest crossings lie at infinity, and no line does.
function chooseChart() {
  const { circles } = shown().arrangement;
  const far = (chart) => {
    const lines = circles.normals.filter((n) => !crossOf(n, chart.infinity).some((x) => x)).length;
    return 100 * lines + circles.crossings.filter(({ ray }) => !dotOf(ray, chart.infinity)).length;
  };
  const names1 = Object.keys(CHARTS);
  state.chart = names1.reduce((best, name) => (far(CHARTS[name]) < far(CHARTS[best]) ? name : best), names1[0]);
  at("chart").value = state.chart;
}

// The ball from in front of the chart, slightly turned.
function chooseAxes() {
  state.shape = shapeOf(at("shape").value === "even");
  const front = state.shape.even ? [0, 0, 1] : chartOf().infinity.map(Number);
  const up = state.shape.even ? [0, 1, 0] : chartOf().up.map(Number);
  const right = unit(cross(up, front));
  const z = unit(front.map((x, k) => x + Math.hypot(...front) * (0.22 * right[k] + 0.3 * (up[k] / Math.hypot(...up)))));
  state.axes = axesFor(z, up);
}

function load(arrangement) {
  edit(() => Object.assign(state, arrangement, { chosen: arrangement.rows.length ? 0 : null }));
  arranged();
}

function arranged() {
  const flat = state.dimension === 2;
  at("chart-row").hidden = flat;
  at("plane-title").textContent = flat ? "Lines of the plane" : "Lines of the projective plane";
  at("dual-title").textContent = flat ? "The dual: a tiling" : "The dual: a zonotope";
  chooseChart();
  chooseColour(suitedColour(shown().arrangement));
  fitPlane();
  at("shape").value = flat || isNarrow(shown().arrangement.circles.normals) ? "even" : "given";
  chooseAxes();
  refresh();
}

const commandOf = () => `echo '${JSON.stringify(documentOf(state))}' | arrangement count -`;

function keepButtons() {
  listenToKeep((text) => load(readArrangement(JSON.parse(text))), commandOf);
  at("save").addEventListener("click", () => downloadJson("arrangement.json", documentOf(state)));
}

function begin() {
  listenToHead(({ arrangement }) => load(readArrangement(arrangement)));
  for (const [name, chart] of Object.entries(CHARTS)) make("option", { value: name }, at("chart"), chart.name);
  at("chart").addEventListener("change", () => { state.chart = at("chart").value; fitPlane(); chooseAxes(); refresh(); });
  at("shape").addEventListener("change", () => { chooseAxes(); refresh(); });
  listenToColours();
  listen();
  linkViews(["mark"], markAll);
  listenToHistory();
  listenToPlayer();
  keepButtons();
  listenToExercises();
  Object.assign(state, readArrangement(data.arrangement));
  state.chosen = state.rows.length ? 0 : null;
  readHash();
  arranged();
  changed();
}

/** @type {any} */ (window).lab = {
  count: (document) => {
    const { rows, dimension } = readArrangement(document);
    const found = summary(rows, dimension);
    return { ...found.counts, type: found.type };
  },
};

begin();
