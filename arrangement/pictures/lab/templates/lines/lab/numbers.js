// The panel of numbers, and adding one plane after another.
function describe() {
  const { arrangement, counts, type } = shown();
  const flat = state.dimension === 2;
  const repeated = counts.planes > counts.distinct_planes ? ` (${counts.distinct_planes} distinct)` : "";
  const chi = zaslavsky(counts);
  const common = commonName(counts, type);
  const typeText = type ? `${type}${flat ? ", with the line at infinity" : common ? `, ${common}` : ""}`
    : common || (arrangement.circles.rank < 3 ? "of rank below 3" : "more than 6 planes, not simplicial: not named");
  facts(at("counts"), [
    [flat ? "lines" : "planes", `${counts.planes}${repeated}`],
    ["f-vector", tuple(counts.f_vector)],
    ["regions", flat ? `${counts.regions}, ${counts.bounded_regions} bounded` : `${counts.regions} on the ball, ${counts.rank ? counts.regions / 2 : 1} in the projective plane`],
    ["χ(t)", polynomialText(counts.characteristic_polynomial)],
    ["|χ(\u22121)|", `${chi} ${chi === counts.regions ? "✓ the regions, by Zaslavsky's theorem" : "✗"}`],
    ["crossings", tallyText(counts.t_vector, "t")],
    ["regions by sides", tallyText(flat ? counts.p_vector : halved(counts.p_vector), "p")],
    ["triangles", `${counts.triangles}${flat ? "" : " in the projective plane"}`],
    ["simple", counts.simple ? "yes" : "no"],
    ["simplicial", counts.simplicial ? "yes" : "no"],
    ["type", typeText],
  ]);
}

const halved = (vector) => Object.fromEntries(Object.entries(vector).map(([k, number]) => [k, number / 2]));

// One sentence for the live region.
function spoken() {
  const { counts, type } = shown();
  return `${count(counts.regions, "region", "regions")}, f-vector ${counts.f_vector.join(" ")}, ${counts.simple ? "simple" : "not simple"}, `
    + `${counts.simplicial ? "simplicial" : "not simplicial"}${type ? `, type ${type}` : ""}.`;
}

/** @type {(kind?: string) => number[]} */ const stepsOf = () => state.rows.map((_, k) => k + 1);
/** @type {(step?: number) => void} */ const stepShown = () => refresh();

// Deletion and restriction: what plane k adds to those before it.
function tellStep(box, k, all) {
  const name = state.dimension === 2 ? "line" : "plane";
  if (!k) { make("p", { class: "hint" }, box, `There is no ${name} yet: add one.`); return; }
  const [now, before] = [k, k - 1].map((number) => summary(state.rows.slice(0, number)));
  make("p", {}, box, `${name === "line" ? "Line" : "Plane"} ${k} of ${all}: ${equationText(state.rows[k - 1])}`);
  const here = now.counts.regions - before.counts.regions;
  const twin = now.counts.distinct_planes === before.counts.distinct_planes;
  if (twin) { make("p", { class: "hint" }, box, "It coincides with an earlier one, and changes nothing."); return; }
  const difference = before.counts.characteristic_polynomial.map((x, j) => x - now.counts.characteristic_polynomial[j]).slice(1);
  const table = make("table", {}, box);
  const line = (cells, tag = "td") => { const row = make("tr", {}, table); cells.forEach((text, j) => make(j ? tag : "th", { scope: j ? "col" : "row" }, row, text)); };
  line(["", "before", "on it", "now"], "th");
  line(["regions", String(before.counts.regions), `+ ${here}`, `= ${now.counts.regions}`]);
  line(["χ(t)", sumOf(before.counts.characteristic_polynomial), `\u2212 (${sumOf(difference)})`, `= ${sumOf(now.counts.characteristic_polynomial)}`]);
  make("p", { class: "hint" }, box, `The new ${name} is cut into ${here} regions by the earlier ones (the restriction); each halves one region (the deletion).`);
}

const sumOf = (coefficients) => sumText(coefficients.map((x, k) => [String(x), POWERS[coefficients.length - 1 - k]]));

const POWERS = ["", "t", "t²", "t³"];
function polynomialText(coefficients) {
  const degree = coefficients.length - 1;
  const whole = sumText(coefficients.map((x, k) => [String(x), POWERS[degree - k]]));
  const factors = factored(coefficients);
  return factors === whole ? whole : `${whole} = ${factors}`;
}

// Splits off integer roots, which lie between 0 and the number of planes.
function factored(coefficients) {
  const roots = [];
  let left = coefficients;
  for (let root = 0; root <= -coefficients[1]; root += 1) {
    while (left.length > 1) {
      const quotient = [];
      const rest = left.reduce((sum, x) => { quotient.push(sum * root + x); return sum * root + x; }, 0);
      if (rest) break;
      roots.push(root);
      left = quotient.slice(0, -1);
    }
  }
  const text = [...new Set(roots)].map((root) => {
    const power = roots.filter((x) => x === root).length;
    const factor = root ? `(t\u00a0\u2212\u00a0${root})` : "t";
    return power > 1 ? `${factor}${"  ²³"[power]}` : factor;
  }).join("");
  const rest = left.length > 1 ? sumText(left.map((x, k) => [String(x), POWERS[left.length - 1 - k]])) : "";
  return text && rest ? `${text}(${rest})` : text || rest;
}

// {2: 3, 3: 4} as "t₂ = 3, t₃ = 4".
const lowered = (number) => String(number).replace(/\d/g, (d) => "₀₁₂₃₄₅₆₇₈₉"[d]);
const tallyText = (counts, letter) => Object.entries(counts).map(([k, number]) => `${letter}${lowered(k)} = ${number}`).join(", ") || "none";
