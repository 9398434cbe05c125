// What every page needs. All numbers that are shown come from exact texts; floats only draw.
const data = JSON.parse(document.getElementById("data").textContent);
/** @type {(id: string) => any} */ const at = (id) => document.getElementById(id);

const make = (name, attributes = {}, parent = null, text = null) => finish(document.createElement(name), attributes, parent, text);
const draw = (name, attributes = {}, parent = null, text = null) =>
  finish(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, parent, text);

function finish(element, attributes, parent, text) {
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== null) typeset(element, text);
  if (parent) parent.append(element);
  return element;
}

// Give an element a text, in which the index of f_x stands lower.
function typeset(element, text) {
  const parts = String(text).split(/(?<=\b[a-z])_([a-z]\d*|\d+)\b/);
  element.replaceChildren(parts[0]);
  for (let k = 1; k < parts.length; k += 2) {
    if (element instanceof SVGElement) {
      draw("tspan", { dy: "0.3em", "font-size": "75%" }, element, parts[k]);
      if (parts[k + 1]) draw("tspan", { dy: "-0.225em" }, element, parts[k + 1]);
    } else {
      make("sub", {}, element, parts[k]);
      element.append(parts[k + 1]);
    }
  }
}

// The place of a pointer in the coordinates of an SVG element, y upwards. A drag finds the matrix once,
// as that costs a layout.
const matrixOf = (view) => view.getScreenCTM().inverse();
function place(view, event, matrix = matrixOf(view)) {
  const inside = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  return [inside.x, -inside.y];
}

// At most one drawing for each frame of the screen.
function oncePerFrame(action) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; action(); });
  };
}

function facts(list, pairs) {
  list.replaceChildren();
  for (const [name, value, exact] of pairs) {
    make("dt", {}, list, name);
    make("dd", exact ? { class: "exact" } : {}, list, value);
  }
}

function themeButton(button) {
  const themes = ["auto", "light", "dark"];
  let chosen = 0;
  button.addEventListener("click", () => {
    chosen = (chosen + 1) % 3;
    document.documentElement.dataset.theme = themes[chosen];
    button.textContent = `colours: ${themes[chosen]}`;
  });
}

// The head of a page.
function showHead() {
  at("title").textContent = data.title;
  typeset(at("summary"), data.summary);
  themeButton(at("theme"));
  at("print")?.addEventListener("click", () => window.print());
}

// Steps to the right and up.
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {(action: (x: number, y: number) => void) => Record<string, () => void>} */
const arrowKeys = (action) => Object.fromEntries(Object.entries(ARROWS).map(([key, [x, y]]) => [key, () => action(x, y)]));

// What keys stand for, where neither Ctrl nor Alt nor Meta is held; `first(event)` may return an action that goes first.
/** @type {(view: Element, keys: Record<string, () => void>, first?: (event: KeyboardEvent) => (() => void) | null) => void} */
function onKeys(view, keys, first = () => null) {
  view.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const action = first(event) ?? keys[event.key];
    if (action) { event.preventDefault(); action(); }
  });
}

// Drags and clicks on a view, by one pointer: a second finger is left alone. `hold(event)` returns what is held, an
// object, or null; `drag(held, event)` gets it with dx and dy, the pixels since the last time; then come
// `click(event)`, if it was none, and `end(held)`.
/** @type {(view: Element, does: { hold?: (event: any) => object | null, drag: (held: any, event: any) => void, click?: (event: any) => void, end?: (held: any) => void }) => void} */
function onDrag(view, { hold: begin = () => ({}), drag, click = () => {}, end = () => {} }) {
  let held = null;
  view.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => {
    if (!event.isPrimary || event.button) return;
    const what = begin(event);
    if (!what) return;
    held = { ...what, x: event.clientX, y: event.clientY, moved: false };
    view.setPointerCapture(event.pointerId);
    view.classList.add("held");
  });
  view.addEventListener("pointermove", (/** @type {PointerEvent} */ event) => {
    if (!held || !event.isPrimary) return;
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    held.moved ||= Math.hypot(dx, dy) > 3;
    if (!held.moved) return;
    Object.assign(held, { dx, dy, x: event.clientX, y: event.clientY });
    drag(held, event);
  });
  const done = (event) => {
    if (!held || !event.isPrimary) return;
    const last = held;
    held = null;
    view.classList.remove("held");
    if (!last.moved && event.type === "pointerup") click(event);
    end(last);
  };
  view.addEventListener("pointerup", done);
  view.addEventListener("pointercancel", done);
}

/** @type {(x: number) => string} */ const fixed = (x) => (Math.round(x * 100) / 100).toString();
/** @type {(text: string) => string} */ const minusSign = (text) => text.replaceAll("-", "\u2212");
const tuple = (values) => `(${values.join(", ")})`;
const count = (number, one, many) => `${number} ${number === 1 ? one : many}`;
