// What is shown.
const state = {
  dimension: 3, rows: [], chosen: null, projective: true, equal: true,
  chart: "z", colour: "sides", axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], middle: [0, 0], half: 2, shape: null,
  ends: new Map(), labels: [],
};

const kept = new Map();
// Counts and cells of rows; those of a few arrangements are kept.
function summary(rows, dimension = state.dimension) {
  const key = hashOf({ dimension, rows });
  if (!kept.has(key)) {
    const arrangement = arrangementOf({ dimension, rows });
    kept.set(key, { arrangement, counts: countsOf(arrangement), get type() { delete this.type; return (this.type = typeOf(arrangement)); } });
    if (kept.size > 60) kept.delete(kept.keys().next().value);
  }
  return kept.get(key);
}

// What the views show: all planes, or the first few of them.
const shown = () => summary(player.step ? state.rows.slice(0, player.step) : state.rows);

const whole = () => summary(state.rows).arrangement;

// The whole state as a text: the address, and what undo keeps.
const snapshot = () => hashOf(state);

function reinstate(text) {
  const read = readState(text);
  const other = read.dimension !== state.dimension;
  Object.assign(state, read, { chosen: state.chosen !== null && state.chosen < read.rows.length ? state.chosen : null });
  if (other) arranged();
}

function changed() {
  showStep();
  refresh();
  if (dragging()) return;
  writeHash();
  say(spoken());
}

function lineStyle(members) {
  const chosen = members.includes(state.chosen) ? " chosen" : "";
  return player.step && members.includes(player.step - 1) ? `${chosen} fresh` : chosen;
}
