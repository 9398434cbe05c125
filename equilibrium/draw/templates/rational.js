// Exact rational numbers: BigInt numerator over a positive BigInt denominator.
function ratio(n, d = 1n) {
  if (d < 0n) return ratio(-n, -d);
  let [a, b] = [n < 0n ? -n : n, d];
  while (b) [a, b] = [b, a % b];
  return a > 1n ? { n: n / a, d: d / a } : { n, d };
}

// Reads "3", "-7/3" and "0.25"; anything else is null.
function readRatio(text) {
  const match = /^\s*([+-]?)(\d{1,40})(?:\.(\d{1,40})|\/(\d{1,40}))?\s*$/.exec(text.replace("\u2212", "-"));
  if (!match) return null;
  const [, sign, whole, decimals, below] = match;
  if (below !== undefined && BigInt(below) === 0n) return null;
  const scale = below !== undefined ? BigInt(below) : 10n ** BigInt(decimals?.length ?? 0);
  const n = BigInt(whole + (decimals ?? ""));
  return ratio(sign === "-" ? -n : n, scale);
}

const plus = (x, y) => ratio(x.n * y.d + y.n * x.d, x.d * y.d);
const times = (x, y) => ratio(x.n * y.n, x.d * y.d);
const textOf = (x) => (x.d === 1n ? String(x.n) : `${x.n}/${x.d}`);
const same = (x, y) => x.n === y.n && x.d === y.d;

function near(x) {
  const small = (v) => v > -(2n ** 53n) && v < 2n ** 53n;
  if (small(x.n) && small(x.d)) return Number(x.n) / Number(x.d);
  const shift = BigInt(Math.max(0, x.d.toString(2).length + 60 - x.n.toString(2).length));
  const digits = (x.n << shift) / x.d;
  return Number(digits) / 2 ** Number(shift);
}

// As a decimal where that is short and exact, else as a fraction.
function decimal(x) {
  for (let places = 0n; places <= 6n; places += 1n) {
    const scale = 10n ** places;
    if ((x.n * scale) % x.d) continue;
    const digits = String(x.n < 0n ? (-x.n * scale) / x.d : (x.n * scale) / x.d).padStart(Number(places) + 1, "0");
    const cut = digits.length - Number(places);
    return `${x.n < 0n ? "-" : ""}${digits.slice(0, cut)}${places ? `.${digits.slice(cut)}` : ""}`;
  }
  return textOf(x);
}

// The value of a linear form with BigInt or rational coefficients.
function valueOf(row, point) {
  return row.reduce((sum, x, i) => plus(sum, times(x, point[i])), ratio(0n));
}
