// Exact vectors: of integers, or of numbers of a field, which have methods (`algebraic.js`).
/** @typedef {any} Entry */

// Rationals as integers over one positive scale: row = integers / scale.
/** @type {(row: Row) => { scale: bigint, row: bigint[] }} */
function integers(row) {
  let scale = 1n;
  for (const x of row) scale *= x.d / gcdOf(scale, x.d);
  return { scale, row: row.map((x) => x.n * (scale / x.d)) };
}

// An integer vector without its common divisor.
/** @type {(vector: Entry[]) => Entry[]} */
function primitive(vector) {
  if (typeof vector[0] === "object") return vector[0].primitive(vector);
  const common = vector.reduce(gcdOf, 0n);
  return common > 1n ? vector.map((x) => x / common) : vector;
}

/** @type {(a: Entry[], b: Entry[]) => Entry} */
const dotOf = (a, b) => (typeof a[0] === "object" ? a.map((x, i) => x.times(b[i])).reduce((sum, x) => sum.plus(x))
  : a.reduce((sum, x, i) => sum + x * b[i], 0n));

/** @type {(vectors: Entry[][]) => Entry[]} */
const totalOf = (vectors) => vectors.reduce((sum, v) => sum.map((x, k) => (typeof x === "object" ? x.plus(v[k]) : x + v[k])));

// A direction that floats hold, however long the integers are; the same for the same array.
/** @type {WeakMap<Entry[], number[]>} */ const floated = new WeakMap();
/** @type {(v: Entry[]) => number[]} */
function floats(v) {
  const known = floated.get(v);
  if (known) return known;
  const whole = typeof v[0] === "object" ? v[0].rounded(v) : v;
  const most = whole.reduce((m, x) => (x < 0n ? (-x > m ? -x : m) : x > m ? x : m), 1n);
  const found = whole.map((x) => near(ratio(x, most)));
  floated.set(v, found);
  return found;
}
