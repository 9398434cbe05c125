// What is said of planes and of what is marked.

// The equation of a row; numbers that are long are shortened, if `show` does.
function equationText(row, show = shortNumber) {
  const variables = state.dimension === 2 ? ["x", "y"] : ["x", "y", "z"];
  const right = state.dimension === 2 ? minusSign(show(textOf(row[2]))) : "0";
  return `${sumText(variables.map((name, k) => ("d" in row[k] ? [textOf(row[k]), name] : coefficient(row[k], name))), show)} = ${right}`;
}

// A term of a sum whose coefficient is a number of a field.
function coefficient(x, name) {
  const text = String(x.sign() < 0 ? x.minus() : x);
  const joined = /^\d+$/.test(text) ? name : ` ${name}`;
  return [`${x.sign() < 0 ? "-" : ""}${text.includes(" ") ? `(${text})` : text}`, joined];
}

const exactText = (vector) => tuple(vector.map((x) => minusSign(String(x))));

// An exact point inside an arc.
function insideArc({ circles }, { circle, from, to }) {
  const n = circles.normals[circle];
  const [p, q] = [from, to].map((end) => pointOf(circles, end, (ray) => ray));
  if (!p) return [crossOf(n, [n[1], n[2], n[0]]), crossOf(n, [n[0], n[1], ...opposite([n[2]])])].find((v) => v.some(signOf));
  return primitive(Math.abs(from - to) === circles.crossings.length ? crossOf(n, p) : totalOf([p, q]));
}

function insideRegion(arrangement, { key, darts }) {
  const { circles } = arrangement;
  if (circles.rank === 0) return [0n, 0n, 1n];
  if (circles.rank === 1) return key === "+" ? circles.normals[0] : opposite(circles.normals[0]);
  return primitive(totalOf(darts.map((dart) => insideArc(arrangement, circles.arcs[dart >> 1]))));
}

// The sum of the normals, as given, with the signs of a region.
function dualVertex({ normals, sides }, { key }) {
  return normals.length ? totalOf(normals.map((n, k) => ((key[sides[k][0]] === "+") === (sides[k][1] > 0) ? n : opposite(n)))) : [0n, 0n, 0n];
}

const planesThrough = ({ members, numbers, infinity }, on) =>
  on.filter((i) => i !== infinity).map((i) => members[i].map((k) => planeName(numbers[k])).join(" = ")).join(", ");

// What is said of a mark: a title, and names and texts of facts, which may be exact numbers; null if there is nothing.
function told(mark) {
  const { arrangement } = shown();
  const { circles } = arrangement;
  const [kind, id] = (mark ?? "").split("-");
  const k = Number(id);
  const things = { line: circles.normals, arc: circles.arcs, region: circles.regions, point: [...circles.crossings, ...circles.crossings] }[kind];
  return things?.[k] ? TELLS[kind](arrangement, things[k], k) : null;
}

const TELLS = {
  line({ circles, members, infinity, numbers }, _, k) {
    const crossings = ["crossings", String(circles.crossings.filter(({ signs }) => !signs[k]).length)];
    if (k === infinity) return { title: "The line at infinity", facts: [crossings] };
    const title = `${members[k].length > 1 ? "Lines" : "Line"} ${names({ members, numbers }, k)}`;
    return { title, facts: [["equation", equationText(state.rows[numbers[members[k][0]]])], crossings] };
  },
  arc(arrangement, arc) {
    const { circles } = arrangement;
    const sides = [arc.left, arc.right].map((id) => keySigns(circles.regions[id].key));
    return { title: "An arc, an edge of the dual", facts: [
      ["signs", signsText(arrangement, sides[0].with(arc.circle, 0)), true],
      ["a point inside", exactText(insideArc(arrangement, arc)), true],
      ["on plane", planesThrough(arrangement, [arc.circle])],
      ["between", sides.map((signs) => signsText(arrangement, signs)).join(" and "), true],
    ] };
  },
  region(arrangement, region) {
    const { circles, infinity } = arrangement;
    const signs = (key) => signsText(arrangement, keySigns(key)) || "(no plane)";
    const bounded = infinity === null ? "" : isBounded(arrangement, region) ? ", bounded" : ", unbounded";
    const facts = [["signs", signs(region.key), true], ["sides", `${sidesOf(arrangement, region)}${bounded}`],
      ["a point inside", pointText(insideRegion(arrangement, region)), true]];
    if (infinity === null && state.projective) facts.splice(1, 0, ["opposite", signs(circles.regions[region.opposite].key), true]);
    if (infinity === null) facts.push(["dual vertex, normals as given", exactText(dualVertex(arrangement, region)), true]);
    return { title: "A region, a vertex of the dual", facts };
  },
  point(arrangement, { on, signs }, corner) {
    const { circles } = arrangement;
    const way = corner < circles.crossings.length ? signs : opposite(signs);
    return { title: "A crossing, a face of the dual", facts: [
      ["signs", signsText(arrangement, way), true],
      [state.dimension === 2 ? "point" : "direction", pointText(pointOf(circles, corner, (ray) => ray)), true],
      [`${state.projective ? "lines" : "planes"} through it`, planesThrough(arrangement, on)],
      ["regions around it", String(2 * on.length)],
    ] };
  },
};

// The same in one line, where long numbers are shortened.
function toldInLine(mark) {
  const found = told(mark);
  if (!found) return "Point at a line, a region or a crossing: it is marked in all views.";
  return `${found.title}: ${found.facts.map(([name, text]) => `${name} ${text.replace(/\d{15,}/g, shortNumber)}`).join("; ")}.`;
}

function pointText(ray) {
  if (state.projective && state.dimension === 3) return exactText(ray).replaceAll(",", " :");
  if (state.dimension === 3) return exactText(ray);
  if (!signOf(ray[2])) return "at infinity";
  return tuple([0, 1].map((k) => minusSign(textOf(ratio(ray[k], ray[2])))));
}
