// What cells are called, and how they are coloured. A page defines: state, with dimension, rows, colour, and whether
// opposite cells are one (projective); shown(), with the arrangement that the views show; whole(), that of all rows.

// The name of a plane, or its number from 1 on; and those of the planes of a circle.
const planeName = (k) => data.names?.[k] || String(k + 1);
const names = ({ members, numbers }, i) => members[i].map((k) => planeName(numbers[k])).join(",");

// Colours stay when planes go.
function lineColour(arrangement, i) {
  arrangement.tints ??= arrangement.members.map(([first]) => {
    if (first === undefined) return "var(--soft)"; // the line at infinity
    const k = whole().members.findIndex((list) => list.includes(arrangement.numbers[first]));
    return data.tints?.[whole().members[k][0]] ?? `oklch(calc(var(--line-l) + ${[0, 0.08, -0.08][k % 3]}) 0.16 ${(40 + k * 137.508) % 360})`;
  });
  return arrangement.tints[i];
}

// Marks, by which views show the same. In the projective plane a line is marked as a whole.
const regionName = ({ infinity }, { id, opposite: other }) => `region-${state.projective && infinity === null ? Math.min(id, other) : id}`;
const arcName = (e, circle) => (state.projective ? `line-${circle}` : `arc-${e}`);
const pointName = ({ crossings }, corner) => `point-${state.projective ? corner % crossings.length : corner}`;

/** @type {(key: string) => number[]} */ const keySigns = (key) => [...key].map((s) => (s === "+" ? 1 : -1));

// The signs of all planes, as text; a plane that is not shown has a dot.
function signsText(arrangement, signs) {
  const texts = state.rows.map(() => "·");
  planeSigns(arrangement, signs).forEach((s, k) => { texts[arrangement.numbers[k]] = s > 0 ? "+" : s < 0 ? "\u2212" : "0"; });
  return texts.join("");
}

// Circles that bound a region.
const sidesOf = ({ circles, infinity }, { darts }) => darts.filter((dart) => circles.arcs[dart >> 1].circle !== infinity).length;

// Ways to colour regions: what is measured, the class for it, and words for the legend.
const COLOURINGS = {
  sides: { name: "number of sides", measure: sidesOf, style: (n) => `c${Math.min(Math.max(n - 2, 0), 5)}`,
    words: (n) => (n < 7 ? count(n, "side", "sides") : "7 or more sides") },
  signs: { name: "number of minus signs", measure: (all, { key }) => planeSigns(all, keySigns(key)).filter((s) => s < 0).length,
    style: (n, all) => `c${Math.round((5 * n) / Math.max(1, all.normals.length))}`, words: (n) => `${n} minus` },
  parity: { name: "two colours", measure: crossed, style: (n) => (n ? "two" : "c0"), words: (n) => `at ${n ? "odd" : "even"} distance` },
  none: { name: "none", measure: () => 0, style: () => "c0", words: () => "every region" },
};

// How many distinct planes lie between a region and the first one, modulo 2.
function crossed({ circles, infinity }, { key }) {
  return [...circles.regions[0].key].filter((sign, i) => i !== infinity && sign !== key[i]).length % 2;
}

// The class of a region.
function styleOf(arrangement, { id }) {
  if (arrangement.styles?.colour !== state.colour) {
    const { measure, style } = COLOURINGS[state.colour];
    arrangement.styles = { colour: state.colour, list: arrangement.circles.regions.map((region) => style(measure(arrangement, region), arrangement)) };
  }
  return arrangement.styles.list[id];
}

function showLegend() {
  const { arrangement } = shown();
  const { measure, words } = COLOURINGS[state.colour];
  const measured = facesOf(arrangement).regions.map((region) => ({ region, n: measure(arrangement, region) })).sort((a, b) => a.n - b.n);
  at("legend").replaceChildren();
  for (const [text, list] of Map.groupBy(measured, ({ n }) => words(n))) {
    const line = make("li", {}, at("legend"));
    const box = draw("svg", { viewBox: "0 0 10 10", "aria-hidden": "true" }, line);
    draw("rect", { width: 9, height: 9, x: 0.5, y: 0.5, class: styleOf(arrangement, list[0].region) }, box);
    line.append(state.projective ? text : `${text} (${list.length})`); // opposite regions may differ
  }
}

function chooseColour(name) {
  state.colour = at("colour").value = name;
}

// By sides where they differ.
const suitedColour = (arrangement) => (new Set(facesOf(arrangement).regions.map((region) => sidesOf(arrangement, region))).size > 1 ? "sides" : "parity");

function listenToColours() {
  for (const [value, { name }] of Object.entries(COLOURINGS)) make("option", { value }, at("colour"), name);
  at("colour").addEventListener("change", () => { chooseColour(at("colour").value); showLegend(); refresh(); });
  at("labels").addEventListener("change", refresh);
}
