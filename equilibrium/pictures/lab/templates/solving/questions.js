// What the page asks, answered part by part in the order in which it is of use: the verdict with one
// equilibrium or its proof; the states that occur and the pieces of the map; all equilibria.
const known = { key: null, states: [], pieces: [], other: "", others: [] };

// A question has texts that tell its grasp, and its grasp and compared method, from others.
function* answersTo({ grasp, wrench, other, key, shown }) {
  const first = yield* treeOf(grasp, wrench);
  yield { found: { ...first, more: first.stable } };
  if (known.key !== key) {
    const [states, pieces] = [[], []];
    for (const one of statesOf(grasp)) { if (one) states.push(one); yield null; }
    for (const one of piecesOf(grasp, states)) { pieces.push(one); yield null; }
    Object.assign(known, { key, states, pieces, other: "", others: [] });
  }
  if (known.other !== other) {
    const others = [];
    if (other) for (const one of piecesBy(other, grasp)) { if (one) others.push(one); yield null; }
    Object.assign(known, { other, others });
  }
  const { states, pieces, others } = known;
  if (shown !== `${key}@${other}`) yield { map: { states, pieces, others } };
  if (first.stable) yield { found: { ...first, equilibria: yield* equilibriaOf(grasp, wrench, pieces), more: false } };
}

// What exercises ask, each one task: a question has its name, a grasp, a load and perhaps a method.
const TASKS = {
  *resists({ grasp, wrench }) { return (yield* treeOf(grasp, wrench)).stable; },
  *all({ grasp, wrench }) {
    const pieces = [];
    for (const one of piecesOf(grasp, statesOf(grasp))) { if (one) pieces.push(one); yield null; }
    return yield* equilibriaOf(grasp, wrench, pieces);
  },
  *multiples({ grasp, wrench }) { return yield* intervalsOf(grasp, wrench); },
  *said({ grasp, wrench, method }) { return yield* sayingOf(method, grasp, wrench); },
};

function* doing(question) {
  if (question) yield { value: yield* TASKS[question.task](question) };
}

const allOf = (grasp, wrench) => drained(TASKS.all({ grasp, wrench }));
