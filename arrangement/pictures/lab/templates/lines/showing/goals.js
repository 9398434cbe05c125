// Goals of exercises, by kind: { counts: values of lab.count }, { meet: lists of lines that go through
// one point each }, { closes: { meet, then } }, where `then` is a list of lines that meet as well.

function judge({ start, fixed, goal }) {
  const first = readState(start).rows;
  const moved = fixed.map(Number).find((k) => !sameRow(state.rows[k - 1], first[k - 1]));
  if (moved) return { solved: false, words: `Line ${moved} must stay as it starts.` };
  const [[kind, value]] = Object.entries(goal);
  return GOALS[kind](value);
}

const sameRow = (one, other) => Boolean(one) && one.every((x, j) => same(x, other[j]));

const GOALS = {
  counts(wanted) {
    const { counts, type } = summary(state.rows);
    const found = { ...counts, type };
    const text = (value) => JSON.stringify(value).replace(/"/g, "").replace(/,/g, ", ");
    const wrong = Object.keys(wanted).find((name) => text(found[name]) !== text(wanted[name]));
    return wrong ? { solved: false, words: `${wrong.replace(/_/g, " ")}: ${text(found[wrong])}, not ${text(wanted[wrong])}.` }
      : { solved: true, words: spoken() };
  },
  meet(lists) {
    const problem = meetingProblem(lists);
    return { solved: !problem, words: problem || "All of them meet." };
  },
  closes({ meet, then }) {
    const problem = meetingProblem(meet);
    if (problem) return { solved: false, words: `No attempt yet: ${problem}` };
    return { solved: true, words: `The attempt is valid, and lines ${then.join(", ")} ${meetingProblem([then]) ? "do not meet" : "meet in a point again: the theorem closes. Try another one"}.` };
  },
};

// Why lists of lines do not meet in one point each, different points for different lists.
function meetingProblem(lists) {
  const { normals } = summary(state.rows).arrangement;
  const used = [...new Set(lists.flat())];
  const missing = used.find((k) => !normals[k - 1]);
  if (missing) return `there is no line ${missing}.`;
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

const beginExercise = ({ start }) => load(readState(start));
