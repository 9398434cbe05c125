// The compared methods: each is a list of choices of states, and an answer is whether one of them has a
// solution. `printed` reads the equations of the paper as they stand.
const METHODS = {
  complete: { name: "the full model", choices: (grasp) => statesOf(grasp) },
  "wrench-space": { name: "the wrench space: any force in its cone", choices: (grasp) => [{ states: grasp.map(() => "free") }] },
  cones: { name: "springs and cones only, no dissipation", choices: (grasp) => statesOf(grasp, ["attached", "detached"]) },
  printed: { name: "the paper as printed", printed: true, choices: printedChoices },
};

// As printed no contact lets go, and d = 0 is not listed, unless the planes share a line.
function* printedChoices(grasp) {
  const thin = planeRank(grasp.map((contact) => wrenchesOf(contact).T)) < 3;
  for (const one of statesOf(grasp, ["slip+", "slip-", "stick"])) {
    if (!one) yield null;
    else if (thin || one.states.some((state) => state !== "stick")) yield { states: one.states };
  }
}

const planeRank = (rows) => {
  const { lines } = generators(3, [], rows.map((row) => integers(row).row));
  return 3 - lines.length;
};

// As printed Eq. 4 carries no preload.
const asked = (grasp, method) => (METHODS[method].printed ? grasp.map((contact) => ({ ...contact, preload: ZERO })) : grasp);

function piecesBy(method, grasp) {
  const posed = asked(grasp, method);
  return piecesOf(posed, METHODS[method].choices(posed), METHODS[method].printed);
}

// Whether a method says that a wrench is resisted; yields null.
function* sayingOf(method, grasp, wrench) {
  const posed = asked(grasp, method);
  for (const one of METHODS[method].choices(posed)) {
    if (one && solutionsOf(posed, one.states, wrench, { printed: METHODS[method].printed }).found.feasible()) return true;
    yield null;
  }
  return false;
}

const saidBy = (method, grasp, wrench) => drained(sayingOf(method, grasp, wrench));

// The multiples of a wrench that are resisted: closed intervals [low, high], null where unbounded, in order;
// yields null.
function* intervalsOf(grasp, wrench) {
  const found = [];
  for (const one of statesOf(grasp)) {
    yield null;
    if (!one) continue;
    const ends = [-1n, 1n].map((way) => {
      const { found: all } = solutionsOf(grasp, one.states, wrench, { load: wrench.map((x) => [x, ZERO]), watched: [3] });
      return all.feasible() ? all.extreme(0, way) : undefined;
    });
    if (ends[0] !== undefined) found.push(ends);
  }
  const before = (x, y) => (x === null ? -1 : y === null ? 1 : order(x, y));
  const sorted = found.toSorted((one, other) => before(one[0], other[0]));
  return sorted.reduce((joined, [low, high]) => {
    const last = joined.at(-1);
    if (!last || (last[1] !== null && low !== null && order(low, last[1]) > 0)) return [...joined, [low, high]];
    const end = last[1] === null || high === null ? null : order(high, last[1]) > 0 ? high : last[1];
    return [...joined.slice(0, -1), [last[0], end]];
  }, []);
}
