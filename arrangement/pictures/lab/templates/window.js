// A window on a plane, the picture `plane`: state.middle, state.half and SIDE, the half of its height there and
// on paper.
const scale = () => SIDE / state.half;
/** @type {(point: number[]) => number[]} */
const onPaper = ([x, y]) => [(x - state.middle[0]) * scale(), -(y - state.middle[1]) * scale()];

// The place of the plane under the pointer.
function worldAt(event) {
  const [x, y] = place(at("plane"), event);
  return [state.middle[0] + x / scale(), state.middle[1] + y / scale()];
}

function zoom(factor, about = state.middle) {
  const half = Math.min(1e9, Math.max(1e-6, state.half * factor));
  state.middle = state.middle.map((m, k) => about[k] + (m - about[k]) * (half / state.half));
  state.half = half;
  refresh();
}

function listenToWheel() {
  at("plane").addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * 0.18), worldAt(event));
  }, { passive: false });
}

const ZOOMS = { "+": () => zoom(0.8), "=": () => zoom(0.8), "-": () => zoom(1.25) };
