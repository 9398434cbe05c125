// A window on a plane, the picture `plane`: state.middle and state.half, half of its height there; half its
// sides on paper, of which the smaller one is always SIDE.
let [WIDE, HIGH] = [0, 0];
function readSides() {
  const { width, height } = at("plane").viewBox.baseVal;
  [WIDE, HIGH] = [width / 2, height / 2];
}
readSides();
const SIDE = HIGH;
const scale = () => SIDE / state.half;
/** @type {(point: number[]) => number[]} */
const onPaper = ([x, y]) => [(x - state.middle[0]) * scale(), -(y - state.middle[1]) * scale()];

// The lower left and the upper right corner of what is seen, or of a share of it about the middle.
function frame(share = 1) {
  const [w, h] = [(share * WIDE) / scale(), (share * HIGH) / scale()];
  return { low: [state.middle[0] - w, state.middle[1] - h], high: [state.middle[0] + w, state.middle[1] + h] };
}

/** @type {(frame: { low: number[], high: number[] }) => number[][]} */
const cornersOf = ({ low, high }) => [low, [high[0], low[1]], high, [low[0], high[1]]];

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
