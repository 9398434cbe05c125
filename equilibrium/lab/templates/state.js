// What is chosen, and how a change leads to new answers. Long searches run in slices of a few
// milliseconds, so that dragging never stutters; until they end, older answers are shown pale.
const state = {
  grasp: [], wrench: [ZERO, ZERO, ZERO], outline: null, chosen: null, turn: ONE, turnChosen: false,
  found: null, choice: 0, leaf: null, motion: null, open: new Map(), searching: null,
  states: [], pieces: [], mapped: "", mapping: null, other: "", others: [], turnOf: 0, focus: null,
  // The plane of forces, as `plane.js` reads it.
  middle: [0, 0], half: 2, torque: ZERO, factor: ONE, slices: [], overlay: null,
  turnSize() { return this.turn.n ? size(this.turn) : ONE; },
  // Older answers are of use while contacts are as many.
  get fits() { return this.found?.grasp.length === this.grasp.length; },
  shownPiece() { return this.fits && this.found.stable ? this.found.equilibria[this.choice] : null; },
  shownMotion() {
    const told = (motion, words, virtual = false) => ({ motion, virtual, words,
      states: this.grasp.map((contact) => contactAt(contact, motion).state) });
    if (this.motion) return told(this.motion, `Blue: the chosen motion, ${motionWords(this.motion)} (enlarged).`);
    const leaf = this.fits && !this.found.stable && !proofHidden() ? this.leaf ?? leavesOf(this.found.tree)[0] : null;
    if (leaf) return told(leaf.motion, `Blue: the virtual motion of the proof, ${motionWords(leaf.motion)} (enlarged).`, true);
    const piece = this.shownPiece();
    return piece?.motion.some((x) => x.n) ? told(piece.motion, `Blue: the motion of this equilibrium (enlarged). Black or white arrows: forces on the object.`) : null;
  },
};
const pieces = () => state.pieces;
const shownForce = () => state.wrench.slice(0, 2);
const graspKey = () => hashOf(state.grasp, state.wrench).split("|")[1];

// While something is dragged, each frame paints the grasp and one of the other views.
const VIEWS = [() => paintDiscs(), () => paintMap(), () => { describe(); writeFields(); }];
const refresh = oncePerFrame(() => {
  paintGrasp();
  if (dragging()) {
    state.turnOf = (state.turnOf + 1) % VIEWS.length;
    VIEWS[state.turnOf]();
  } else {
    for (const paint of VIEWS) paint();
    markAll();
  }
});

// After the grasp or the wrench has changed.
function changed() {
  Object.assign(state, { torque: state.wrench[2], leaf: null, motion: null, turnChosen: false });
  state.searching?.();
  const { grasp, wrench } = state;
  let ended = false;
  let first = null;
  const show = (found) => {
    const choice = first ? found.equilibria.findIndex((piece) => holds(grasp, piece, first.motion, first.forces)) : 0;
    Object.assign(state, { found: { ...found, grasp, wrench }, choice: Math.max(0, choice), leaf: null, open: new Map() });
    refresh();
    if (first) return;
    first = found.equilibria[0];
    chooseTurn();
    findPieces();
    if (!dragging()) say(sayVerdict());
  };
  // The first equilibrium is shown as soon as it is found; the others are listed after it.
  const stop = inSlices(treeOf(grasp, wrench), (found) => {
    ended = true;
    state.searching = null;
    show(found);
  }, dragging() ? 6 : 80, show);
  state.searching = ended ? null : stop;
  if (!ended) refresh();
  if (!dragging()) writeHash();
}

// Unless an angle was chosen: that of the equilibrium, else one at which springs begin to let go.
function chooseTurn() {
  const r = state.shownPiece()?.motion[2];
  if (state.turnChosen) return;
  if (r?.n) { state.turn = r; return; }
  const reach = state.grasp.map((c) => near(c.preload) / near(c.stiffness)).filter((x) => x > 0);
  state.turn = reach.length ? ratio(BigInt(Math.max(1, Math.round((64 * Math.min(...reach)) / (data.size || 1) / 2))), 64n) : ONE;
}

const mapKey = () => `${graspKey()}@${textOf(state.torque)}@${state.other}`;

// The states that occur, then the pieces of the plane of forces, also by the compared method: when
// nothing has moved for a while.
function findPieces() {
  const key = mapKey();
  if (state.mapped === key) return;
  const sameGrasp = state.mapped.split("@")[0] === graspKey();
  state.mapping?.();
  const wait = setTimeout(() => {
    const search = (function* all() {
      if (!sameGrasp) {
        const list = [];
        for (const one of statesOf(state.grasp)) { if (one) list.push(one); yield null; }
        state.states = list;
      }
      const [found, others] = [[], []];
      for (const piece of piecesOf(state.grasp, state.torque, state.states.map(({ states }) => states))) { found.push(piece); yield null; }
      if (state.other) for (const piece of piecesBy(state.other, state.grasp, state.torque)) { if (piece) others.push(piece); yield null; }
      return { pieces: found, others };
    })();
    state.mapping = inSlices(search, (found) => {
      Object.assign(state, { ...found, mapped: key, mapping: null });
      if (!sameGrasp && !dragging()) fitPlane();
      showStep();
      refresh();
    });
  }, dragging() ? 90 : 0);
  state.mapping = () => clearTimeout(wait);
}

// The whole state as a text: the address, and what undo keeps.
const snapshot = () => hashOf(state.grasp, state.wrench, state.outline);

function reinstate(text) {
  const read = readState(text);
  const chosen = state.chosen !== null && state.chosen < read.grasp.length ? state.chosen : null;
  Object.assign(state, read, { chosen });
}

function load({ grasp, wrench, outline }) {
  edit(() => Object.assign(state, { grasp, wrench, outline, chosen: grasp.length ? 0 : null }));
  fitPlane();
}

