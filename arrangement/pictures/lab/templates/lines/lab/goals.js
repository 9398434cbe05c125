// Goals of exercises, by kind: { counts: values of lab.count }, { meet: lists of lines that go through
// one point each }, { closes: { meet, then } }, where `then` is a list of lines that meet as well. A goal
// without values has those of the state.
const plainName = (name) => name.replace(/_/g, " ");
const COUNTS = ["distinct_planes", "f_vector", "regions", "bounded_regions", "characteristic_polynomial", "t_vector", "p_vector",
  "simple", "simplicial", "triangles", "type"];
const ASKED = [...COUNTS.map((name) => [plainName(name), { counts: { [name]: undefined } }]), ["lines that meet", { meet: undefined }]];
const ASKED_TOGETHER = true;
const fixable = () => state.rows.map((_, k) => [String(k + 1), `line ${k + 1}`]);
const startOf = (text) => readState(text);

function judge({ start, fixed, goal }, /** @type {Rows} */ { rows, dimension } = state) {
  const first = startOf(start).rows;
  const moved = fixed.map(Number).find((k) => !sameRow(rows[k - 1], first[k - 1]));
  if (moved) return { solved: false, words: `Line ${moved} must stay as it starts.` };
  const [[kind, value]] = Object.entries(goal);
  return GOALS[kind](value, summary(rows, dimension));
}

const sameRow = (one, other) => Boolean(one) && one.every((x, j) => same(x, other[j]));

const GOALS = {
  counts(wanted, shape) {
    const found = { ...shape.counts, type: shape.type };
    const value = Object.fromEntries(Object.keys(wanted).map((name) => [name, found[name]]));
    const text = (one) => JSON.stringify(one).replace(/"/g, "").replace(/,/g, ", ");
    const wrong = Object.keys(wanted).find((name) => wanted[name] !== undefined && text(found[name]) !== text(wanted[name]));
    if (wrong) return { solved: false, words: `${plainName(wrong)}: ${text(found[wrong])}, not ${text(wanted[wrong])}.` };
    const nameless = Object.keys(wanted).find((name) => wanted[name] === undefined && found[name] === null);
    return { value, solved: !nameless, words: nameless ? `The ${nameless} has no name.` : spoken() };
  },
  meet(wanted, shape) {
    const lists = wanted ?? meetingLists(shape.arrangement);
    const problem = lists.length ? meetingProblem(lists, shape.arrangement) : "no three lines meet.";
    return { value: lists, solved: !problem, words: problem || "All of them meet." };
  },
  closes({ meet, then }, { arrangement }) {
    const problem = meetingProblem(meet, arrangement);
    if (problem) return { solved: false, words: `No attempt yet: ${problem}` };
    return { solved: true, words: `The attempt is valid, and lines ${then.join(", ")} ${meetingProblem([then], arrangement) ? "do not meet" : "meet in a point again: the theorem closes. Try another one"}.` };
  },
};

// Three lines or more through a point, for each such point; of lines that coincide the first.
const meetingLists = ({ circles, infinity, members }) => circles.crossings
  .map(({ on }) => on.filter((i) => i !== infinity).map((i) => members[i][0] + 1)).filter((list) => list.length > 2);

// Why lists of lines do not meet in one point each, different points for different lists.
function meetingProblem(lists, { normals }) {
  const used = [...new Set(lists.flat())];
  const missing = used.find((k) => !normals[k - 1]);
  if (missing) return `there is not a line ${missing}.`;
  const places = new Map(used.map((k) => [unoriented(normals[k - 1]).join(), k]));
  if (places.size < used.length) return "two lines coincide.";
  const points = new Set();
  for (const [a, b, ...others] of lists) {
    const point = unoriented(crossOf(normals[a - 1], normals[b - 1]));
    if (others.some((k) => dotOf(normals[k - 1], point))) return `lines ${[a, b, ...others].join(", ")} do not go through one point.`;
    points.add(point.join());
  }
  return points.size < lists.length ? "two of the points coincide." : "";
}

const beginExercise = ({ start }) => load(startOf(start));
