// Planes through the origin of R^3 as great circles: crossings, arcs and regions, all by the signs
// of integer determinants.

/** @typedef {{ ray: bigint[], signs: number[], on: number[] }} Crossing */
/** @typedef {{ circle: number, from: number, to: number, left: number, right: number }} Arc */
/** @typedef {{ key: string, id: number, opposite: number, darts: number[], corners: number[] }} Region */
/**
 * Crossings stand for two opposite points each; `curves` and `dual` are kept by the views.
 * @typedef {{ normals: bigint[][], crossings: Crossing[], arcs: Arc[], regions: Region[], rank: number,
 *   curves?: { shape: object, list: number[][][] }, dual?: any }} Circles
 */

/** @type {(a: bigint[], b: bigint[]) => bigint[]} */
const crossOf = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(x: bigint) => number} */ const signOf = (x) => (x > 0n ? 1 : x < 0n ? -1 : 0);
/** @type {(v: bigint[]) => bigint[]} */ const opposite = (v) => v.map((x) => -x);

// The primitive multiple whose first entry other than 0 is positive: equal for planes that coincide.
/** @type {(v: bigint[]) => bigint[]} */
function unoriented(v) {
  const p = primitive(v);
  return p.find((x) => x) > 0n ? p : opposite(p);
}

// Points of the sphere on two circles or more: a ray for each pair of opposite ones, with all
// circles through it, and its side of every circle.
/** @type {(normals: bigint[][]) => Crossing[]} */
function crossingsOf(normals) {
  const found = new Map();
  normals.forEach((n, i) => {
    for (let j = 0; j < i; j += 1) {
      const ray = unoriented(crossOf(normals[j], n));
      const key = ray.join();
      if (!found.has(key)) found.set(key, ray);
    }
  });
  return [...found.values()].map((ray) => {
    const signs = normals.map((n) => signOf(dotOf(n, ray)));
    return { ray, signs, on: [...signs.keys()].filter((i) => !signs[i]) };
  });
}

// The crossings on circle i, counter-clockwise about its normal: points of the first half circle,
// then their opposites. Point p is ray p, point p + number the ray opposite.
/** @type {(normal: bigint[], crossings: Crossing[], i: number) => number[]} */
function ringOf(normal, crossings, i) {
  const number = crossings.length;
  const [first, ...others] = [...crossings.keys()].filter((p) => !crossings[p].signs[i]);
  if (first === undefined) return [];
  const side = crossOf(normal, crossings[first].ray);
  const half = others.map((p) => (dotOf(side, crossings[p].ray) > 0n
    ? { p, ray: crossings[p].ray } : { p: p + number, ray: opposite(crossings[p].ray) }));
  half.sort((one, other) => -signOf(dotOf(normal, crossOf(one.ray, other.ray))));
  const ring = [first, ...half.map(({ p }) => p)];
  return [...ring, ...ring.map((p) => (p + number) % (2 * number))];
}

// All cells that circles make on the sphere. Arc e has darts 2e, along its circle with the region
// where the circle is positive on the left, and 2e + 1 back.
/** @type {(normals: bigint[][]) => Circles} */
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
      const quarter = ring.length === 2 ? crossOf(n, p < number ? crossings[p].ray : opposite(crossings[p - number].ray)) : null;
      const [a, b] = [signsAt(p), signsAt(q)];
      const signs = normals.map((m, j) => (quarter ? signOf(dotOf(m, quarter)) : Math.sign(a[j] + b[j])));
      const sides = [1, -1].map((s) => regionOf(signs.with(i, s)));
      sides.forEach((region, back) => region.darts.push(2 * arcs.length + back));
      arcs.push({ circle: i, from: p, to: q, left: sides[0].id, right: sides[1].id });
    });
  });
  if (!crossings.length) { // one circle without crossings, or none
    if (normals.length) for (const s of [1, -1]) regionOf([s]);
    else regionOf([]);
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
  region.corners = region.darts.map((d) => tail(arcs, d));
}

/** @typedef {{ normals: bigint[][], infinity: number | null, circles: Circles, members: number[][] }} Gathered */
// The circles of planes, those that coincide together; lines of the plane are half of what they and the line at
// infinity, which comes last, make on the sphere.
/** @type {(normals: bigint[][], atInfinity?: bigint[] | null) => Gathered} */
function gathered(normals, atInfinity = null) {
  const members = [...Map.groupBy(normals.keys(), (i) => unoriented(normals[i]).join()).values()];
  const distinct = members.map(([i]) => normals[i]);
  if (!atInfinity) return { normals, infinity: null, circles: circlesOf(distinct), members };
  return { normals, infinity: distinct.length, circles: circlesOf([...distinct, atInfinity]), members: [...members, []] };
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
function planeSigns({ normals, members, circles }, signs) {
  return normals.map((normal, k) => {
    const i = members.findIndex((list) => list.includes(k));
    return dotOf(normal, circles.normals[i]) < 0n ? -signs[i] || 0 : signs[i];
  });
}

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
