// What is chosen, and how a change leads to new answers. A worker looks for them, so that dragging never
// stutters; until they come, older ones are shown pale.
const state = {
  grasp: [], wrench: [ZERO, ZERO, ZERO], outline: null, chosen: null, turn: ONE, turnChosen: false,
  found: null, choice: 0, leaf: null, motion: null, open: new Map(), searching: false,
  states: [], pieces: [], mapped: "", other: "", others: [], turnOf: 0, focus: null,
  // The plane of forces, as `plane.js` reads it.
  middle: [0, 0], half: 2,
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
  Object.assign(state, { leaf: null, motion: null, turnChosen: false });
  work.stop();
  search();
  if (!dragging()) writeHash();
}

function search() {
  state.searching = true;
  at("verdict").setAttribute("aria-busy", "true");
  const { grasp, wrench, other } = state;
  ask({ grasp, wrench, other, key: graspKey(), shown: state.mapped });
  refresh();
}

// Parts of an answer; while something is dragged, to a question a little earlier.
const ask = asking(answersTo, ({ found, map }, { grasp, wrench, key, other }) => {
  if (map) {
    const fresh = state.mapped.split("@")[0] !== key;
    Object.assign(state, { ...map, mapped: `${key}@${other}` });
    if (fresh && !dragging()) fitPlane();
    showStep();
  }
  if (found) {
    const shown = state.found;
    const before = shown?.more && shown.grasp === grasp && shown.wrench === wrench ? shown.equilibria[state.choice] : null;
    const choice = before ? found.equilibria.findIndex((piece) => holds(grasp, piece, before.motion, before.forces)) : 0;
    Object.assign(state, { found: { ...found, grasp, wrench }, choice: Math.max(0, choice) });
    if (!before) {
      Object.assign(state, { leaf: null, open: new Map() });
      chooseTurn();
      if (!dragging()) say(sayVerdict());
    }
  }
  refresh();
}, () => { state.searching = false; refresh(); });

// Unless an angle was chosen: that of the equilibrium, else one at which springs begin to let go.
function chooseTurn() {
  const r = state.shownPiece()?.motion[2];
  if (state.turnChosen) return;
  if (r?.n) { state.turn = r; return; }
  const reach = state.grasp.map((c) => near(c.preload) / near(c.stiffness)).filter((x) => x > 0);
  state.turn = reach.length ? ratio(BigInt(Math.max(1, Math.round((64 * Math.min(...reach)) / (data.size || 1) / 2))), 64n) : ONE;
}

const mapKey = () => `${graspKey()}@${state.other}`;

// The whole state as a text: the address, and what undo keeps.
const snapshot = () => hashOf(state.grasp, state.wrench, state.outline);

function reinstate(text) {
  const read = readState(text, data.most);
  const chosen = state.chosen !== null && state.chosen < read.grasp.length ? state.chosen : null;
  Object.assign(state, read, { chosen });
}

function load({ grasp, wrench, outline }) {
  edit(() => Object.assign(state, { grasp, wrench, outline, chosen: grasp.length ? 0 : null }));
  fitPlane();
}

