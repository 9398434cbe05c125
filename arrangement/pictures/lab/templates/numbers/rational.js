// Exact rational numbers: BigInt numerator over a positive BigInt denominator, in lowest terms.
/** @typedef {{ n: bigint, d: bigint }} Rational */
/** @typedef {Rational[]} Row */

/** @type {(a: bigint, b: bigint) => bigint} */ const gcdOf = (a, b) => { while (b) [a, b] = [b, a % b]; return a < 0n ? -a : a; };

/** @type {(n: bigint, d?: bigint) => Rational} */
function ratio(n, d = 1n) {
  if (d < 0n) return ratio(-n, -d);
  const common = gcdOf(n, d);
  return common > 1n ? { n: n / common, d: d / common } : { n, d };
}

// Reads "3", "-7/3", "0.25" and "-1e-3"; anything else is null.
/** @type {(text: string) => Rational | null} */
function readNumber(text) {
  const match = /^\s*([+-]?)(\d{0,1000})(?:\.(\d{0,1000}))?(?:[eE]([+-]?\d{1,3})|\/(\d{1,1000}))?\s*$/.exec(text.replace("\u2212", "-"));
  if (!match) return null;
  const [, sign, whole, decimals = "", power = "0", below = "1"] = match;
  if (!whole && !decimals) return null;
  if ((decimals && match[5] !== undefined) || BigInt(below) === 0n) return null;
  const shift = Number(power) - decimals.length;
  const n = BigInt(`${sign === "-" ? "-" : ""}${whole}${decimals}`) * 10n ** BigInt(Math.max(0, shift));
  return ratio(n, BigInt(below) * 10n ** BigInt(Math.max(0, -shift)));
}

// A number that was typed: a comma before digits is a decimal point.
/** @type {(text: string) => Rational | null} */
const readTyped = (text) => readNumber(text.replace(/,(?=\d)/, "."));

const NUMBER_RULE = "a number such as 3/4, 0.75 or -1e-3";
const ZERO = ratio(0n);
const ONE = ratio(1n);
/** @type {(x: Rational, y: Rational) => Rational} */ const plus = (x, y) => ratio(x.n * y.d + y.n * x.d, x.d * y.d);
/** @type {(x: Rational, y: Rational) => Rational} */ const times = (x, y) => ratio(x.n * y.n, x.d * y.d);
/** @type {(x: Rational) => Rational} */ const minus = (x) => ({ n: -x.n, d: x.d });
/** @type {(x: Rational, y: Rational) => Rational} */ const less = (x, y) => plus(x, minus(y));
/** @type {(x: Rational, y: Rational) => Rational} */ const over = (x, y) => times(x, ratio(y.d, y.n));
/** @type {(x: Rational, y: Rational) => boolean} */ const same = (x, y) => x.n === y.n && x.d === y.d;
/** @type {(x: Rational, y: Rational) => -1 | 0 | 1} */
const order = (x, y) => { const v = x.n * y.d - y.n * x.d; return v < 0n ? -1 : v > 0n ? 1 : 0; };
/** @type {(x: Rational) => Rational} */ const size = (x) => (x.n < 0n ? minus(x) : x);
/** @type {(x: Rational) => string} */ const textOf = (x) => (x.d === 1n ? String(x.n) : `${x.n}/${x.d}`);

// A place on the grid of 1 / steps.
/** @type {(value: number, steps: number) => Rational} */
const onGrid = (value, steps) => ratio(BigInt(Math.round(value * steps)), BigInt(steps));

// The nearest float, or nearly.
/** @type {(x: Rational) => number} */
function near(x) {
  const small = (v) => v > -(2n ** 53n) && v < 2n ** 53n;
  if (small(x.n) && small(x.d)) return Number(x.n) / Number(x.d);
  const shift = BigInt(Math.max(0, x.d.toString(2).length + 60 - x.n.toString(2).length));
  const digits = (x.n << shift) / x.d;
  return Number(digits) / 2 ** Number(shift);
}

// Short for a table: a long number is rounded, and its sign says so.
/** @type {(x: Rational) => string} */
function shortText(x) {
  const text = textOf(x);
  if (text.length <= 14) return text;
  const whole = ratio((2n * x.n + x.d) / (2n * x.d) - (2n * x.n + x.d < 0n ? 1n : 0n));
  const rest = near(less(x, whole));
  if (whole.n && Math.abs(rest) < 1e-5) return `≈ ${textOf(whole)} ${rest < 0 ? "−" : "+"} ${Math.abs(rest).toPrecision(2)}`;
  return `≈ ${near(x).toPrecision(6)}`;
}

// Rows of rationals.
/** @type {(row: Row, x: Rational) => Row} */ const scaledBy = (row, x) => row.map((y) => times(x, y));
/** @type {(a: Row, b: Row) => Row} */ const added = (a, b) => a.map((x, i) => plus(x, b[i]));
/** @type {(a: Row, b: Row) => Rational} */ const dotted = (a, b) => a.reduce((sum, x, i) => plus(sum, times(x, b[i])), ZERO);
/** @type {(row: Row) => Row} */ const minusRow = (row) => row.map(minus);
/** @type {(v: Row) => string} */ const vectorText = (v) => `(${v.map(shortText).join(", ")})`;

// The text of a number, its middle left out where it is long.
/** @type {(text: string) => string} */
const shortNumber = (text) => (text.length > 14 ? `${text.slice(0, 6)}…${text.slice(-4)}` : text);

// A sum with signs between its terms: pairs of a coefficient's text and a name.
/** @type {(terms: string[][], show?: (text: string) => string) => string} */
function sumText(terms, show = shortNumber) {
  const parts = terms.filter(([value]) => value !== "0").map(([value, name]) => {
    const whole = value.replace("-", "");
    return `${value.startsWith("-") ? "\u2212" : "+"} ${name && whole === "1" ? name.trim() : show(whole) + name}`;
  });
  return parts.join(" ").replace(/^\+ /, "").replace(/^\u2212 /, "\u2212") || "0";
}
