// Arrangements in words.

function equationText(row) {
  const texts = row.map(textOf);
  const names1 = state.dimension === 2 ? ["x", "y"] : ["x", "y", "z"];
  return `${sumText(names1.map((name, k) => [texts[k], name]))} = ${state.dimension === 2 ? minusSign(shortNumber(texts[2])) : "0"}`;
}

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

const signsText = (signs) => signs.map((s) => (s > 0 ? "+" : s < 0 ? "\u2212" : "0")).join("");

// What is said of the thing that is marked.
function litText() {
  const { arrangement } = shown();
  const { circles, infinity, members } = arrangement;
  const [kind, id] = (lit.mark ?? "").split("-");
  const k = Number(id);
  if (kind === "line" && circles.normals[k]) {
    const points = circles.crossings.filter(({ signs }) => !signs[k]);
    const number = count(points.length, "crossing", "crossings");
    if (k === infinity) return `The line at infinity: ${number}, the directions of the lines.`;
    return `${members[k].length > 1 ? "Lines" : "Line"} ${names(members[k])}: ${equationText(state.rows[members[k][0]])}; ${number}.`;
  }
  if (kind === "region" && circles.regions[k]) {
    const region = circles.regions[k];
    const side = (key) => signsText(planeSigns(arrangement, [...key].map((s) => (s === "+" ? 1 : -1))));
    const sides = region.darts.filter((dart) => circles.arcs[dart >> 1].circle !== infinity).length || circles.normals.length;
    const bounded1 = infinity === null ? "" : isBounded(arrangement, region) ? ", bounded" : ", unbounded";
    const opposite1 = infinity === null ? `, and opposite ${side(circles.regions[region.opposite].key)}` : "";
    return `Region ${side(region.key)}${opposite1}: ${count(sides, "side", "sides")}${bounded1}.`;
  }
  if (kind === "point" && circles.crossings[k]) {
    const { ray, on, signs } = circles.crossings[k];
    const lines = names(on.filter((i) => i !== infinity).flatMap((i) => members[i]));
    return `Crossing ${pointText(ray)} of lines ${lines}: ${signsText(planeSigns(arrangement, signs))}.`;
  }
  return "Point at a line, a region or a crossing: it is marked in all views.";
}

function pointText(ray) {
  if (state.dimension === 3) return `(${ray.map((x) => minusSign(shortNumber(String(x)))).join(" : ")})`;
  if (!ray[2]) return "at infinity";
  return `(${[0, 1].map((k) => minusSign(shortNumber(textOf(ratio(ray[k], ray[2]))))).join(", ")})`;
}
