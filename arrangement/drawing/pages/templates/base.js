// What every page needs. All numbers that are shown come from exact texts; floats only draw.
const data = JSON.parse(document.getElementById("data").textContent);
/** @type {(id: string) => any} */ const at = (id) => document.getElementById(id);

const make = (name, attributes = {}, parent = null, text = null) => finish(document.createElement(name), attributes, parent, text);
const draw = (name, attributes = {}, parent = null, text = null) =>
  finish(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, parent, text);

function finish(element, attributes, parent, text) {
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== null) element.textContent = text;
  if (parent) parent.append(element);
  return element;
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
  at("summary").textContent = data.summary;
  themeButton(at("theme"));
  at("print")?.addEventListener("click", () => window.print());
}

// What keys stand for, where neither Ctrl nor Alt nor Meta is held.
function onKeys(view, keys) {
  view.addEventListener("keydown", (event) => {
    const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
    if (action) { event.preventDefault(); action(); }
  });
}

/** @type {(x: number) => string} */ const fixed = (x) => (Math.round(x * 100) / 100).toString();
const tuple = (values) => `(${values.join(", ")})`;
const count = (number, one, many) => `${number} ${number === 1 ? one : many}`;
