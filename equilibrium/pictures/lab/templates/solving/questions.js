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
