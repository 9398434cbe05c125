// Planes through the origin of R^3 as great circles: crossings, arcs and regions, all by the signs
// of exact determinants.

/** @typedef {{ ray: Entry[], signs: number[], on: number[] }} Crossing */
/** @typedef {{ circle: number, from: number, to: number, left: number, right: number }} Arc */
/** @typedef {{ key: string, id: number, opposite: number, darts: number[], corners: number[] }} Region */
/**
 * Crossings stand for two opposite points each; `curves` and `dual` are kept by the views.
 * @typedef {{ normals: Entry[][], crossings: Crossing[], arcs: Arc[], regions: Region[], rank: number,
 *   curves?: { shape: object, list: number[][][] }, dual?: any }} Circles
 */

/** @type {(x: Entry, y: Entry, z: Entry, w: Entry) => Entry} */
const minor = (x, y, z, w) => (typeof x === "object" ? x.times(w).plus(y.times(z).minus()) : x * w - y * z);
/** @type {(a: Entry[], b: Entry[]) => Entry[]} */
const crossOf = (a, b) => [minor(a[1], a[2], b[1], b[2]), minor(a[2], a[0], b[2], b[0]), minor(a[0], a[1], b[0], b[1])];
/** @type {(x: Entry) => number} */ const signOf = (x) => (typeof x === "object" ? x.sign() : x > 0n ? 1 : x < 0n ? -1 : 0);
/** @type {(v: Entry[]) => Entry[]} */ const opposite = (v) => v.map((x) => (typeof x === "object" ? x.minus() : -x));
/** @type {(a: Entry[], b: Entry[]) => boolean} */ const areParallel = (a, b) => !crossOf(a, b).some(signOf);

// The primitive multiple whose first entry other than 0 is positive: of integers, equal for planes that coincide.
/** @type {(v: Entry[]) => Entry[]} */
function unoriented(v) {
  const p = primitive(v);
  return p.map(signOf).find((sign) => sign) > 0 ? p : opposite(p);
}

// Points of the sphere on two circles or more: a ray for each pair of opposite ones, with all
// circles through it, and its side of every circle.
/** @type {(normals: Entry[][]) => Crossing[]} */
function crossingsOf(normals) {
  const found = [];
  const known = normals.map(() => new Set());
  normals.forEach((n, i) => {
    for (let j = 0; j < i; j += 1) {
      if (known[i].has(j)) continue;
      const ray = unoriented(crossOf(normals[j], n));
      const signs = normals.map((m) => signOf(dotOf(m, ray)));
      const on = [...signs.keys()].filter((k) => !signs[k]);
      for (const k of on) for (const other of on) known[k].add(other);
      found.push({ ray, signs, on });
    }
  });
  return found;
}

// Of a point of the sphere, for an odd map of rays; null for the ends of a circle without crossings.
/** @type {(circles: { crossings: Crossing[] }, p: number, map: (ray: Entry[]) => any[]) => any[] | null} */
function pointOf({ crossings }, p, map) {
  if (p < 0) return null;
  const found = map(crossings[p % crossings.length].ray);
  return p < crossings.length ? found : opposite(found);
}

// The crossings on circle i, counter-clockwise about its normal: points of the first half circle,
// then their opposites. Point p is ray p, point p + number the ray opposite.
/** @type {(normal: Entry[], crossings: Crossing[], i: number) => number[]} */
function ringOf(normal, crossings, i) {
  const number = crossings.length;
  const [first, ...others] = [...crossings.keys()].filter((p) => !crossings[p].signs[i]);
  if (first === undefined) return [];
  const side = crossOf(normal, crossings[first].ray);
  const half = others.map((p) => (signOf(dotOf(side, crossings[p].ray)) > 0
    ? { p, ray: crossings[p].ray } : { p: p + number, ray: opposite(crossings[p].ray) }));
  half.sort((one, other) => -signOf(dotOf(normal, crossOf(one.ray, other.ray))));
  const ring = [first, ...half.map(({ p }) => p)];
  return [...ring, ...ring.map((p) => (p + number) % (2 * number))];
}

// All cells that circles make on the sphere. Arc e has darts 2e, along its circle with the region
// where the circle is positive on the left, and 2e + 1 back. A circle without crossings is one arc, whose ends are -1.
/** @type {(normals: Entry[][]) => Circles} */
function circlesOf(normals) {
  const crossings = crossingsOf(normals);
  const number = crossings.length;
  const signsAt = (p) => (p < number ? crossings[p].signs : crossings[p - number].signs.map((s) => -s || 0));
  /** @type {Arc[]} */ const arcs = [];
  /** @type {Map<string, Region>} */ const regions = new Map();
  const regionOf = (signs) => {
    const key = signs.map((s) => (s > 0 ? "+" : "-")).join("");
    if (!regions.has(key)) regions.set(key, { key, darts: [], id: regions.size, opposite: 0, corners: [] });
    return regions.get(key);
  };
  normals.forEach((n, i) => {
    const ring = ringOf(n, crossings, i);
    ring.forEach((p, k) => {
      const q = ring[(k + 1) % ring.length];
      // Between opposite points there is no other crossing: a quarter turn from p lies between.
      const quarter = ring.length === 2 ? crossOf(n, pointOf({ crossings }, p, (ray) => ray)) : null;
      const [a, b] = [signsAt(p), signsAt(q)];
      const signs = normals.map((m, j) => (quarter ? signOf(dotOf(m, quarter)) : Math.sign(a[j] + b[j])));
      const sides = [1, -1].map((s) => regionOf(signs.with(i, s)));
      sides.forEach((region, back) => region.darts.push(2 * arcs.length + back));
      arcs.push({ circle: i, from: p, to: q, left: sides[0].id, right: sides[1].id });
    });
  });
  if (!normals.length) regionOf([]);
  else if (!crossings.length) {
    const [left, right] = [1, -1].map((s) => regionOf([s]));
    [left, right].forEach((region, dart) => region.darts.push(dart));
    arcs.push({ circle: 0, from: -1, to: -1, left: left.id, right: right.id });
  }
  const all = { normals, crossings, arcs, regions: [...regions.values()], rank: rankOf(normals, crossings) };
  for (const region of all.regions) orderDarts(all, region);
  const mirror = new Map(all.regions.map(({ key, id }) => [key, id]));
  for (const region of all.regions) region.opposite = mirror.get(region.key.replace(/[+-]/g, (s) => (s === "+" ? "-" : "+")));
  return all;
}

const rankOf = (normals, crossings) => (crossings.length > 1 ? 3 : crossings.length ? 2 : normals.length ? 1 : 0);
const tail = (arcs, dart) => (dart & 1 ? arcs[dart >> 1].to : arcs[dart >> 1].from);
const head = (arcs, dart) => tail(arcs, dart ^ 1);

// Sorts the darts of a region into its boundary, counter-clockwise.
function orderDarts({ arcs }, region) {
  const leaving = new Map(region.darts.map((dart) => [tail(arcs, dart), dart]));
  let dart = region.darts[0];
  region.darts = region.darts.map(() => {
    const here = dart;
    dart = leaving.get(head(arcs, dart));
    return here;
  });
  region.corners = region.darts.map((d) => tail(arcs, d)).filter((p) => p >= 0);
}

/**
 * `members` are the planes of each circle, `sides` the circle of each plane, and 1 or -1: whether its positive side is that of the circle.
 * @typedef {{ normals: Entry[][], infinity: number | null, circles: Circles, members: number[][], sides: number[][] }} Gathered
 */
// The circles of planes, those that coincide together; lines of the plane are half of what they and the line at
// infinity, which comes last, make on the sphere.
/** @type {(normals: Entry[][], atInfinity?: bigint[] | null) => Gathered} */
function gathered(normals, atInfinity = null) {
  const members = [];
  const sides = normals.map((n, k) => {
    const known = members.findIndex(([first]) => areParallel(normals[first], n));
    const i = known < 0 ? members.push([]) - 1 : known;
    members[i].push(k);
    return [i, signOf(dotOf(normals[members[i][0]], n))];
  });
  const distinct = members.map(([i]) => normals[i]);
  if (!atInfinity) return { normals, infinity: null, circles: circlesOf(distinct), members, sides };
  return { normals, infinity: distinct.length, circles: circlesOf([...distinct, atInfinity]), members: [...members, []], sides };
}

// What lies in the plane, of what lies on the sphere: all, or what is positive at infinity.
/** @type {(all: Gathered) => { points: Crossing[], arcs: Arc[], regions: Region[] }} */
function facesOf({ circles, infinity }) {
  const { crossings, arcs, regions } = circles;
  if (infinity === null) {
    return { points: crossings.flatMap((point) => [point, point]), arcs, regions };
  }
  const finite = (region) => region.key[infinity] === "+";
  return {
    points: crossings.filter(({ signs }) => signs[infinity]),
    arcs: arcs.filter(({ circle, left, right }) => circle !== infinity && finite(regions[left]) && finite(regions[right])),
    regions: regions.filter(finite),
  };
}

// Signs of the planes as given, from those of the circles.
/** @type {(all: Gathered, signs: number[]) => number[]} */
const planeSigns = ({ sides }, signs) => sides.map(([i, way]) => way * signs[i] || 0);

/** @typedef {{ dimension: number, rows: Row[], numbers?: number[] }} Rows */
/** @typedef {Gathered & { dimension: number, numbers: number[], tints?: string[], styles?: any }} Lines */
// An arrangement: dimension 3, rows (a, b, c) of central planes a x + b y + c z = 0, or dimension 2, rows (a, b, c)
// of lines a x + b y = c; `numbers` are those of the planes, where some are left out.
/** @type {(rows: Rows) => Lines} */
function arrangementOf({ dimension, rows, numbers = [...rows.keys()] }) {
  const normals = rows.map((row) => {
    const [a, b, c] = "d" in row[0] ? integers(row).row : row;
    return primitive(dimension === 2 ? [a, b, -c] : [a, b, c]);
  });
  return { dimension, numbers, ...gathered(normals, dimension === 2 ? [0n, 0n, 1n] : null) };
}

// Whether a region of the affine plane has no point at infinity.
/** @type {(lines: Gathered, region: Region) => boolean} */
const isBounded = ({ circles, infinity }, { corners }) => circles.rank === 3
  && corners.every((p) => circles.crossings[p % circles.crossings.length].signs[infinity] !== 0);

// A text that is equal exactly for circles of one isomorphism class, up to the order of planes,
// their sides and a mirror: of all ways to number the darts by walking over the map, the least.
/** @type {(circles: Circles) => string} */
function canonicalMap({ arcs, regions }) {
  const next = [];
  const before = [];
  for (const { darts } of regions) {
    darts.forEach((dart, k) => {
      const after = darts[(k + 1) % darts.length];
      next[dart] = after;
      before[after] = dart;
    });
  }
  let best = null;
  for (const turn of [next, before]) {
    for (let start = 0; start < 2 * arcs.length; start += 1) {
      const word = walk(turn, start, best);
      if (word) best = word;
    }
  }
  return best ? String.fromCharCode(...best) : "";
}

// The numbers of the darts that a walk meets; null as soon as they exceed the best.
/** @type {(turn: number[], start: number, best: number[] | null) => number[] | null} */
function walk(turn, start, best) {
  const names = new Int16Array(turn.length).fill(-1);
  const order = [start];
  names[start] = 0;
  const word = [];
  let smaller = !best;
  for (let k = 0; k < order.length; k += 1) {
    for (const dart of [order[k] ^ 1, turn[order[k]]]) {
      if (names[dart] < 0) names[dart] = order.push(dart) - 1;
      if (!smaller) {
        if (names[dart] > best[word.length]) return null;
        smaller = names[dart] < best[word.length];
      }
      word.push(names[dart]);
    }
  }
  return smaller ? word : null;
}
