// The arrangement of the planes that are switched on, made from the cells of all planes:
// regions with the same signs on the remaining planes are one region. No float decides anything.
function modelOf(on) {
  const classOn = data.classes.map((members) => members.some((k) => on[k]));
  const kept = on.flatMap((yes, k) => (yes ? [k] : []));
  const regions = [];
  const byKey = new Map();
  const merged = data.regions.map((region, piece) => {
    const key = kept.map((k) => region.signs[k]).join("");
    if (!byKey.has(key)) {
      byKey.set(key, regions.length);
      regions.push({ id: regions.length, key, pieces: [], arcs: [], points: [], signs: shownSigns(region.signs, on) });
    }
    const id = byKey.get(key);
    regions[id].pieces.push(piece);
    return id;
  });
  const arcs = [];
  const byPair = new Map();
  data.arcs.forEach((arc, piece) => {
    if (!classOn[arc.circle]) return;
    const [left, right] = arc.sides.map((region) => merged[region]);
    const pair = `${left} ${right}`;
    if (!byPair.has(pair)) {
      byPair.set(pair, arcs.length);
      arcs.push({ circle: arc.circle, left, right, pieces: [], signs: zeroed(regions[left], arc.circle) });
      for (const region of [left, right]) regions[region].arcs.push(arcs.length - 1);
    }
    arcs[byPair.get(pair)].pieces.push(piece);
  });
  const points = [];
  data.points.forEach((point, piece) => {
    const through = point.circles.filter((circle) => classOn[circle]);
    if (through.length < 2) return;
    const around = point.around.map((region) => merged[region]);
    const cycle = around.filter((id, i) => id !== around[(i + 1) % around.length]);
    let signs = regions[cycle[0]].signs;
    for (const circle of through) signs = zeroed({ signs }, circle);
    for (const region of cycle) regions[region].points.push(points.length);
    points.push({ piece, cycle, signs, circles: through });
  });
  return { on, kept, classOn, regions, byKey, arcs, points };
}

// The signs of a cell over all planes; a plane that was taken away has a dot.
function shownSigns(signs, on) {
  return [...signs].map((sign, k) => (on[k] ? sign : "·")).join("");
}

function zeroed(cell, circle) {
  const inside = new Set(data.classes[circle]);
  return [...cell.signs].map((s, k) => (inside.has(k) && s !== "·" ? "0" : s)).join("");
}

// The exact dual vertex of a region: the sum of the normals, each with the sign of its plane.
function dualVertex(model, region) {
  const sum = [0n, 0n, 0n];
  for (const k of model.kept) {
    const sign = region.signs[k] === "+" ? 1n : -1n;
    data.planes[k].normal.forEach((x, i) => { sum[i] += sign * BigInt(x); });
  }
  return sum.map(String);
}

// Where dual vertices are drawn, in a ball of radius 1.
function dualPlaces(model, equalEdges) {
  const sides = model.kept.map((k) => {
    const plane = data.planes[k];
    const partners = data.classes[plane.circle].filter((other) => model.on[other]).length;
    return plane.unit.map((x) => x * (equalEdges ? 1 / partners : plane.length));
  });
  return [...zonotopePlaces(model.regions, sides).values()];
}

// The ways to colour regions: what is measured, its class, and words for the legend.
const COLOURINGS = {
  sides: { measure: (_, region) => region.arcs.length, style: (n) => `c${Math.min(Math.max(n - 2, 0), 5)}`,
    words: (n) => (n < 7 ? count(n, "side", "sides") : "7 or more sides") },
  signs: { measure: (_, { key }) => [...key].filter((s) => s === "-").length, style: (n, { key }) => `c${Math.round((5 * n) / Math.max(1, key.length))}`,
    words: (n) => `${n} minus` },
  parity: { measure: (model, region) => crossed(model, region) % 2, style: (n) => (n ? "two" : "c0"),
    words: (n) => `at ${n ? "odd" : "even"} distance` },
  none: { measure: () => 0, style: () => "c0", words: () => "every region" },
};

// The class for the colour of each region.
function colourOf(model, by) {
  const { measure, style } = COLOURINGS[by];
  return (region) => style(measure(model, region), region);
}

// How many distinct planes lie between a region and the first one.
function crossed(model, region) {
  const first = model.regions[0].signs;
  return data.classes.filter((members) => {
    const k = members.find((member) => model.on[member]);
    return k !== undefined && region.signs[k] !== first[k];
  }).length;
}

function legendOf(model, by) {
  const { measure, style, words } = COLOURINGS[by];
  const entries = new Map();
  for (const [n, region] of model.regions.map((one) => [measure(model, one), one]).sort((a, b) => a[0] - b[0])) {
    const entry = entries.get(words(n)) ?? { text: words(n), colour: style(n, region), number: 0 };
    entry.number += 1;
    entries.set(entry.text, entry);
  }
  return [...entries.values()];
}
