// Fields of exact numbers. What is not a number is marked, is told, and changes nothing.

// A labelled field; `accept` takes the value, and returns what is wrong with it, if anything. Without
// a parent the field with this id is meant. After typing, writeFields() shows what the state has.
function field(parent, id, label, accept, { read = readTyped, rule = NUMBER_RULE, style = "" } = {}) {
  const holder = parent ? make("label", { class: style }, parent) : null;
  if (holder) make("span", {}, holder, label);
  const box = holder ? make("input", { type: "text", id, autocomplete: "off", spellcheck: "false" }, holder) : at(id);
  box.setAttribute("aria-describedby", "problem");
  box.addEventListener("input", () => {
    box.dataset.typing = "1";
    const value = read(box.value);
    const problem = value === null ? `${label}: give ${rule}.` : accept(value);
    if (problem) box.setAttribute("aria-invalid", "true");
    else box.removeAttribute("aria-invalid");
    at("problem").textContent = problem || "";
  });
  box.addEventListener("blur", () => { delete box.dataset.typing; writeFields(); });
  return holder;
}

const write = (id, value) => writeText(id, textOf(value));

function writeText(id, text) {
  const box = at(id);
  if (!box || (box === document.activeElement && box.dataset.typing)) return;
  box.value = text;
  if (box.getAttribute("aria-invalid") !== "true") return;
  box.removeAttribute("aria-invalid");
  at("problem").textContent = "";
}

// Numbered buttons, `name` and a number each, of which one is chosen; one more adds, one removes.
// `build` makes the fields of the chosen one. Made anew when their number or the choice changes.
function writeTabs(name, total, chosen, { choose, add, remove, build, addText = "add", most = data.most }) {
  const tabs = at("tabs");
  const wanted = `${total}/${chosen}`;
  if (tabs.dataset.shown === wanted) return;
  const held = /** @type {HTMLElement} */ (document.activeElement)?.dataset?.tab;
  tabs.dataset.shown = wanted;
  tabs.replaceChildren();
  const button = (text, attributes, action) => {
    const made = make("button", attributes, tabs, text);
    made.addEventListener("click", action);
    return made;
  };
  for (let k = 0; k < total; k += 1) {
    button(String(k + 1), { "aria-pressed": String(k === chosen), "data-tab": k, [`data-${name}`]: k, "aria-label": `${name} ${k + 1}` }, () => choose(k));
  }
  button(addText, { id: "add" }, add).disabled = total >= most;
  button("remove", { id: "remove" }, () => remove(chosen)).disabled = chosen === null;
  at("fields").replaceChildren();
  if (chosen === null) make("p", { class: "hint" }, at("fields"), `Choose a ${name}, here or in a picture.`);
  else build(at("fields"));
  if (held !== undefined) tabs.querySelector(`[data-tab="${held}"]`)?.focus();
}

// Adds to state[list], or takes one away; the choice follows.
function addTo(list, one) {
  edit(() => Object.assign(state, { [list]: [...state[list], one], chosen: state[list].length }));
}

function removeFrom(list, k) {
  if (k === null || !state[list][k]) return;
  const left = state[list].filter((_, i) => i !== k);
  edit(() => Object.assign(state, { [list]: left, chosen: left.length ? Math.min(k, left.length - 1) : null }));
}
