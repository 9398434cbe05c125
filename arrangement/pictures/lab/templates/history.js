// Undo, redo and the address. A page defines: snapshot(), its state as a short text; reinstate(text),
// which takes such a text, or throws an Error that says why not; changed(), after which views follow.
const edits = { past: [], future: [], held: null };
const dragging = () => edits.held !== null;

// Changes the state; while something is dragged all changes are one.
function edit(action) {
  const before = snapshot();
  action();
  if (snapshot() === before) return;
  if (!dragging()) remember(before);
  changed();
}

function remember(before) {
  edits.past.push(before);
  edits.future = [];
  showEdits();
}

function hold() {
  edits.held = snapshot();
}

// The end of a drag: the answer is given anew, without haste.
function release() {
  if (!dragging()) return;
  const before = edits.held;
  edits.held = null;
  if (before === snapshot()) return;
  remember(before);
  changed();
}

function restore(from, to) {
  if (!from.length || dragging()) return;
  to.push(snapshot());
  reinstate(from.pop());
  showEdits();
  changed();
}

const undo = () => restore(edits.past, edits.future);
const redo = () => restore(edits.future, edits.past);

function showEdits() {
  at("undo").disabled = !edits.past.length;
  at("redo").disabled = !edits.future.length;
}

function writeHash() {
  try { history.replaceState(null, "", `#${snapshot()}`); } catch { /* a frame may have no address */ }
  if (parent !== window) parent.postMessage({ lab: snapshot() }, "*"); // a notebook reads it
}

// Takes the state of the address, if it has one; else the last valid state stays.
const readHash = () => attempt(() => {
  if (location.hash.length > 1 && location.hash !== `#${snapshot()}`) reinstate(decodeURIComponent(location.hash.slice(1)));
});

function listenToHistory() {
  at("undo").addEventListener("click", undo);
  at("redo").addEventListener("click", redo);
  showEdits();
  document.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || /** @type {Element} */ (event.target).matches?.("input[type=text], textarea") || !"zy".includes(key)) return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) redo();
    else undo();
  });
  window.addEventListener("hashchange", () => { readHash(); changed(); });
}
