// The numbers of an arrangement.
function rankOfArrangement({ circles, infinity }) {
  if (infinity === null) return circles.rank;
  return circles.crossings.filter(({ signs }) => !signs[infinity]).length > 1 ? 2 : Math.min(1, circles.normals.length - 1);
}

/** @type {(lines: Lines) => any} */
function countsOf(arrangement) {
  const { circles, dimension, infinity, members } = arrangement;
  const { points, arcs, regions } = facesOf(arrangement);
  const distinct = members.length - (infinity === null ? 0 : 1);
  const rank = rankOfArrangement(arrangement);
  const flats = infinity === null ? circles.crossings : points;
  const mu = flats.reduce((sum, { on }) => sum + on.length - 1, 0);
  const walls = regions.map(({ darts }) => darts.map((dart) => circles.arcs[dart >> 1].circle).filter((i) => i !== infinity));
  const bounded = infinity === null ? [] : regions.filter((region) => isBounded(arrangement, region));
  const triangles = infinity === null ? regions.filter((region) => circles.rank === 3 && region.darts.length === 3).length / 2
    : bounded.filter((region) => region.darts.length === 3).length;
  return {
    planes: arrangement.normals.length, distinct_planes: distinct, dimension, rank,
    f_vector: dimension === 3 ? spatial(circles) : [points.length, arcs.length, regions.length],
    regions: regions.length, bounded_regions: bounded.length,
    characteristic_polynomial: dimension === 2 ? [1, -distinct, mu] : polynomial(circles, mu),
    t_vector: tally(flats.map(({ on }) => on.length)),
    p_vector: tally(walls.map((list) => list.length)),
    simple: isSimple(arrangement, distinct, flats),
    simplicial: walls.every((list) => isIndependent(list.map((i) => circles.normals[i]), dimension, rank)),
    triangles,
  };
}

function spatial({ rank, crossings, arcs, regions }) {
  if (rank === 3) return [1, 2 * crossings.length, arcs.length, regions.length];
  return [0, rank === 2 ? 1 : 0, arcs.length, regions.length];
}

// Coefficients of the characteristic polynomial from the Moebius function of the flats.
function polynomial({ rank, normals }, mu) {
  const m = normals.length;
  return [[1, 0, 0, 0], [1, -1, 0, 0], [1, -m, m - 1, 0], [1, -m, mu, m - 1 - mu]][rank];
}

// How often each number occurs.
/** @type {(numbers: number[]) => Record<string, number>} */
function tally(numbers) {
  const found = {};
  for (const x of numbers) found[x] = (found[x] ?? 0) + 1;
  return found;
}

// As the command line says it: any min(d, m) normals are independent; and off the origin no d + 1
// planes meet.
function isSimple({ dimension, normals, circles, infinity }, distinct, flats) {
  if (dimension === 3) return distinct < 3 || flats.every(({ on }) => on.length === 2);
  const parallel = circles.crossings.some(({ signs, on }) => !signs[infinity] && on.length > 2);
  const central = normals.every(([, , c]) => !c);
  return !parallel && (central || flats.every(({ on }) => on.length === 2));
}

/** @type {(normals: bigint[][], dimension: number, rank: number) => boolean} */
function isIndependent(normals, dimension, rank) {
  if (normals.length > rank) return false;
  const [a, b, c] = normals.map((n) => (dimension === 2 ? [n[0], n[1], 0n] : n));
  if (c) return dotOf(a, crossOf(b, c)) !== 0n;
  return !b || crossOf(a, b).some((x) => x);
}

// |chi(-1)|: Zaslavsky's number of regions, from flats alone.
const zaslavsky = ({ characteristic_polynomial: chi }) => Math.abs(chi.reduce((sum, x, k) => sum + (k % 2 ? -x : x), 0));
