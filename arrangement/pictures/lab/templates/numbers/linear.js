// Exact linear systems in integers: a dictionary of rows over free columns, and cones by generators.

// The system { equal rows = 0, atLeast rows >= 0 } in n free unknowns; a row has its constant last.
// Each row is a variable: basic ones are written over the columns, x_i = (sum t_ij x_j + t_in) / det,
// and a pivot exchanges two. All entries are integers (minors), so every division is exact.
class Dictionary {
  /**
   * @param {number} n
   * @param {Row[]} equal
   * @param {Row[]} atLeast
   * @param {Row[]} watched
   */
  constructor(n, equal, atLeast, watched = []) {
    const rows = [...equal, ...atLeast, ...watched].map(integers);
    this.n = n;
    this.t = rows.map(({ row }) => [...row]);
    this.scales = rows.map(({ scale }) => scale);
    this.basic = rows.map((_, i) => n + i);
    this.columns = Array.from({ length: n }, (_, j) => j);
    this.firstUnequal = n + equal.length;
    this.firstWatched = this.firstUnequal + atLeast.length;
    this.det = 1n;
  }

  isFree(label) { return label < this.n; }
  isFixed(label) { return label >= this.n && label < this.firstUnequal; }
  isSlack(label) { return label >= this.firstUnequal && label < this.firstWatched; }

  pivot(r, c) {
    const { t, n } = this;
    const own = t[r];
    const p = own[c];
    const sign = p < 0n ? -1n : 1n;
    for (let i = 0; i < t.length; i += 1) {
      if (i === r) continue;
      const row = t[i];
      const a = row[c];
      for (let j = 0; j <= n; j += 1) {
        if (j === c || !(row[j] || (a && own[j]))) continue;
        row[j] = (sign * (a ? p * row[j] - a * own[j] : p * row[j])) / this.det;
      }
      row[c] = sign * a;
    }
    for (let j = 0; j <= n; j += 1) own[j] = j === c ? sign * this.det : -sign * own[j];
    this.det = sign * p;
    [this.basic[r], this.columns[c]] = [this.columns[c], this.basic[r]];
  }

  // Makes the system feasible (Bland's rule, so it ends); else this.refuted holds the multipliers y
  // of the rows: their combination is a negative constant, with y >= 0 on inequalities.
  feasible() {
    const { t, n, basic } = this;
    for (let label = n; label < this.firstUnequal; label += 1) {
      const r = basic.indexOf(label);
      const c = this.columns.findIndex((column, j) => this.isFree(column) && t[r][j]);
      if (c >= 0) this.pivot(r, c);
      else if (t[r][n]) return this.refute(r, t[r][n] > 0n ? -1n : 1n);
    }
    for (let c = 0; c < n; c += 1) {
      if (!this.isFree(this.columns[c])) continue;
      const r = basic.findIndex((label, i) => this.isSlack(label) && t[i][c]);
      if (r >= 0) this.pivot(r, c);
    }
    for (;;) {
      const r = this.first(basic, (label, i) => this.isSlack(label) && t[i][n] < 0n);
      if (r < 0) return true;
      const c = this.first(this.columns, (label, j) => this.isSlack(label) && t[r][j] > 0n);
      if (c < 0) return this.refute(r, 1n);
      this.pivot(r, c);
    }
  }

  // The place of the smallest label that passes; -1 if none does.
  first(labels, passes) {
    let found = -1;
    labels.forEach((label, k) => { if (passes(label, k) && (found < 0 || label < labels[found])) found = k; });
    return found;
  }

  /** @type {(r: number, sign: bigint) => false} */
  refute(r, sign) {
    const y = this.scales.map(() => ZERO);
    const put = (label, value) => { if (label >= this.n) y[label - this.n] = times(value, ratio(this.scales[label - this.n])); };
    put(this.basic[r], ratio(sign));
    this.columns.forEach((label, j) => put(label, ratio(-sign * this.t[r][j], this.det)));
    this.refuted = y;
    return false;
  }

  // The value of each free unknown, where what can vary is 0.
  point() {
    const z = Array.from({ length: this.n }, () => ZERO);
    this.basic.forEach((label, i) => { if (this.isFree(label)) z[label] = ratio(this.t[i][this.n], this.det); });
    return z;
  }

  // Whether the equalities leave one point.
  get single() { return this.columns.every((label) => this.isFixed(label)); }

  // The largest (way 1n) or least (-1n) value of a watched row over the solutions; null: unbounded.
  /** @type {(k: number, way: bigint) => Rational | null} */
  extreme(k, way) {
    const { t, n, basic } = this;
    const goal = t[basic.indexOf(this.firstWatched + k)];
    for (;;) {
      if (this.columns.some((label, j) => this.isFree(label) && goal[j])) return null;
      const c = this.first(this.columns, (label, j) => this.isSlack(label) && way * goal[j] > 0n);
      if (c < 0) return ratio(goal[n], this.det * this.scales[this.firstWatched + k - n]);
      let r = -1;
      basic.forEach((label, i) => {
        if (!this.isSlack(label) || t[i][c] >= 0n) return;
        const gap = r < 0 ? -1n : t[r][n] * t[i][c] - t[i][n] * t[r][c];
        if (gap < 0n || (gap === 0n && label < basic[r])) r = i;
      });
      if (r < 0) return null;
      this.pivot(r, c);
    }
  }
}

// A cone by what generates it: lines, and rays with the cuts (bits) on which each is 0.
/** @typedef {{ lines: bigint[][], rays: { v: bigint[], zeros: bigint }[], bit: bigint }} Cone */
/** @type {(n: number) => Cone} */
const wholeCone = (n) => ({ lines: Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => BigInt(i === j))), rays: [], bit: 1n });

// What of a cone has row . x >= 0, or row . x = 0 (double description).
/** @type {(cone: Cone, row: bigint[], keep?: boolean) => Cone} */
function cutCone({ lines, rays, bit }, row, keep = true) {
  /** @type {(x: bigint[]) => bigint} */ const value = (x) => dotOf(row, x);
  const next = bit << 1n;
  const k = lines.findIndex((x) => Boolean(value(x)));
  if (k >= 0) {
    const line = value(lines[k]) > 0n ? lines[k] : lines[k].map((x) => -x);
    const step = value(line);
    const flat = (x) => primitive(x.map((v, i) => step * v - value(x) * line[i]));
    const level = rays.map((ray) => ({ v: flat(ray.v), zeros: ray.zeros | bit }));
    return { lines: lines.filter((_, i) => i !== k).map(flat), rays: keep ? [...level, { v: line, zeros: bit - 1n }] : level, bit: next };
  }
  const values = rays.map((ray) => value(ray.v));
  const side = (sign) => rays.map((ray, i) => ({ ray, h: values[i] })).filter(({ h }) => (sign ? h * sign > 0n : h === 0n));
  const [above, below] = [side(1n), side(-1n)];
  const found = side(0n).map(({ ray }) => ({ v: ray.v, zeros: ray.zeros | bit }));
  for (const one of above) {
    for (const other of below) {
      const zeros = one.ray.zeros & other.ray.zeros;
      const between = rays.some((ray) => ray !== one.ray && ray !== other.ray && (ray.zeros & zeros) === zeros);
      if (!between) found.push({ v: primitive(one.ray.v.map((x, i) => one.h * other.ray.v[i] - other.h * x)), zeros: zeros | bit });
    }
  }
  return { lines, rays: keep ? [...above.map(({ ray }) => ray), ...found] : found, bit: next };
}

// Lines and rays that generate { x : row . x >= 0, equal . x = 0 }.
/** @type {(n: number, atLeast: bigint[][], equal?: bigint[][]) => { lines: bigint[][], rays: bigint[][] }} */
function generators(n, atLeast, equal = []) {
  const level = equal.reduce((cone, row) => cutCone(cone, row, false), wholeCone(n));
  const { lines, rays } = atLeast.reduce((cone, row) => cutCone(cone, row), level);
  return { lines, rays: rays.map(({ v }) => v) };
}
