// Numbers of Q(a), where a is a real root of a monic integer polynomial: sums of powers of a with integer
// coefficients, the constant term first. data.field has the polynomial and an interval with only this root.
const root = data.field ? { polynomial: data.field.minimal_polynomial.map(BigInt), ends: data.field.interval.map(readNumber), powers: new Map() } : null;

// Integers that differ by less than 2 from the powers of a times 2^bits.
/** @type {(bits: bigint) => bigint[]} */
function powersOf(bits) {
  if (root.powers.has(bits)) return root.powers.get(bits);
  const degree = root.polynomial.length - 1;
  const [size] = root.ends.map((x) => BigInt((x.n / x.d).toString(2).length)).sort((x, y) => (x > y ? -1 : 1));
  const more = bits + 8n + BigInt(degree) * (size + 2n);
  /** @type {(x: bigint) => bigint} */
  const value = (x) => root.polynomial.reduceRight((sum, c, k) => sum * x + (c << (more * BigInt(degree - k))), 0n);
  let [low, high] = root.ends.map((x) => (x.n << more) / x.d);
  const rising = value(high) > 0n;
  while (high - low > 1n) {
    const middle = (low + high) >> 1n;
    if ((value(middle) > 0n) === rising) high = middle;
    else low = middle;
  }
  const powers = [1n << more];
  while (powers.length < degree) powers.push((powers.at(-1) * low) >> more);
  root.powers.set(bits, powers.map((x) => x >> (more - bits)));
  return root.powers.get(bits);
}

// A number of a file, however long.
/** @type {(text: string) => Rational} */
function exactNumber(text) {
  const [n, d = "1"] = text.split("/");
  return ratio(BigInt(n), BigInt(d));
}

// A row of a file, in which an irrational number is the list of its coefficients; times what makes them integers.
/** @type {(entries: (string | string[])[]) => any[]} */
function algebraicRow(entries) {
  const degree = root.polynomial.length - 1;
  const listed = entries.map((entry) => [entry].flat());
  const { row } = integers(listed.flatMap((list) => Array.from({ length: degree }, (_, k) => exactNumber(list[k] ?? "0"))));
  return listed.map((_, i) => new Algebraic(row.slice(degree * i, degree * (i + 1))));
}

class Algebraic {
  /** @param {bigint[]} c */
  constructor(c) { this.c = c; }

  plus(other) { return new Algebraic(this.c.map((x, k) => x + other.c[k])); }
  minus() { return new Algebraic(this.c.map((x) => -x)); }

  times(other) {
    const degree = this.c.length;
    const sum = Array.from({ length: 2 * degree - 1 }, () => 0n);
    this.c.forEach((x, i) => { if (x) other.c.forEach((y, j) => { sum[i + j] += x * y; }); });
    for (let k = sum.length - 1; k >= degree; k -= 1) {
      for (let j = 0; j < degree; j += 1) sum[k - degree + j] -= sum[k] * root.polynomial[j];
    }
    return new Algebraic(sum.slice(0, degree));
  }

  // Integers in the ratios of a vector other than 0, nearer than floats can tell.
  rounded(vector) {
    const size = vector.flatMap(({ c }) => c).reduce((sum, x) => sum + (x < 0n ? -x : x), 0n) << 61n;
    for (let bits = 128n; ; bits *= 2n) {
      const powers = powersOf(bits);
      const found = vector.map(({ c }) => c.reduce((sum, x, k) => sum + x * powers[k], 0n));
      if (found.some((x) => x > size || x < -size)) return found;
    }
  }

  sign() { return this.c.some((x) => x) ? signOf(this.rounded([this])[0]) : 0; }

  // A vector without the common divisor of all coefficients.
  primitive(vector) {
    const common = vector.reduce((divisor, x) => x.c.reduce(gcdOf, divisor), 0n);
    return common > 1n ? vector.map((x) => new Algebraic(x.c.map((c) => c / common))) : vector;
  }

  toString() { return sumText(this.c.map((x, k) => [String(x), ["", "a"][k] ?? `a^${k}`]), (text) => text); }
}
