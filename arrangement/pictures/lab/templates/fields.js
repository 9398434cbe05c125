// Fields of exact numbers. What is no number is marked, is told, and changes nothing.

// A labelled field; `accept` takes the value, and returns what is wrong with it, if anything. Without
// a parent the field with this id is meant. After typing, writeFields() shows what the state has.
function field(parent, id, label, accept, { read = readNumber, rule = NUMBER_RULE, style = "" } = {}) {
  const holder = parent ? make("label", { class: style }, parent, label) : null;
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
