// An editor of exercises. The page computes what is asked from the state that it shows, which has to solve the
// exercise, as its start must not. A page defines: ASKED, pairs of words and a goal without values; judge, which
// returns that goal's `value` as well; startOf(text), the state of a start; fixable(), pairs of names of what may
// have to stay and words; ASKED_TOGETHER, whether several pairs of one kind may be asked.
const editor = { start: "", own: data.own ? [...data.exercises] : [] };

const chosenOf = (name) => [...at(name).querySelectorAll("input:checked")].map((/** @type {HTMLInputElement} */ box) => box.value);

function boxes(name, type, pairs) {
  at(name).querySelectorAll("label").forEach((label) => label.remove());
  for (const [value, words] of pairs) {
    const label = make("label", {}, at(name));
    make("input", { type, name, value }, label);
    label.append(` ${words}`);
  }
}

function keepStart() {
  editor.start = snapshot();
  at("own-start-text").textContent = editor.start;
  boxes("own-fixed", "checkbox", fixable());
}

// The goal of what is chosen, still without values; throws an error where there is none.
function goalAsked() {
  const goal = {};
  for (const k of chosenOf("own-asked")) {
    const [[kind, value]] = Object.entries(ASKED[k][1]);
    goal[kind] = value && { ...goal[kind], ...value };
  }
  const kinds = Object.keys(goal);
  if (kinds.length !== 1) throw new Error(kinds.length ? `ask for ${kinds.join(" or ")}, not for both` : "choose what is asked");
  return goal;
}

// Throws an error that says why there is no such exercise.
async function exerciseWritten() {
  const text = (id) => at(id).value.trim();
  const [name, task] = [text("own-name"), text("own-task")];
  const hints = text("own-hints").split("\n").map((hint) => hint.trim()).filter(Boolean);
  if (!name || !task) throw new Error("give it a name and a task");
  const found = { name, task, hints, start: editor.start, fixed: chosenOf("own-fixed"), goal: goalAsked() };
  const here = await judge(found);
  if (!here.solved) throw new Error(`what the page shows is not a solution: ${here.words}`);
  for (const kind of Object.keys(found.goal)) found.goal[kind] = here.value;
  if ((await judge(found, startOf(found.start))).solved) throw new Error("the start solves it already");
  return found;
}

async function putExercise() {
  const said = at("own-said");
  Object.assign(said, { className: "", textContent: "Computing …" });
  try {
    const found = await exerciseWritten();
    removeOwn(found.name);
    editor.own.push(found);
    data.exercises.push(found);
    listExercises();
    Object.assign(said, { className: "ok", textContent: `✓ In the list as ${data.exercises.length}. Asked: ${JSON.stringify(found.goal)}` });
  } catch (error) {
    Object.assign(said, { className: "bad", textContent: `✗ Not taken: ${error.message}` });
  }
}

function removeOwn(name) {
  const known = editor.own.find((one) => one.name === name);
  if (!known) return false;
  editor.own.splice(editor.own.indexOf(known), 1);
  data.exercises.splice(data.exercises.indexOf(known), 1);
  Object.assign(exercises, { at: null, solved: new Set(), checks: exercises.checks + 1 });
  listExercises();
  return true;
}

function listenToEditor() {
  boxes("own-asked", ASKED_TOGETHER ? "checkbox" : "radio", ASKED.map(([words], k) => [k, words]));
  at("own-start").addEventListener("click", keepStart);
  at("editor-box").addEventListener("toggle", () => { if (!editor.start) keepStart(); });
  at("own-put").addEventListener("click", putExercise);
  at("own-remove").addEventListener("click", () => {
    const removed = removeOwn(data.exercises[exercises.at]?.name);
    Object.assign(at("own-said"), { className: "", textContent: removed ? "Removed." : "Choose one of your own in the list above." });
  });
  at("own-save").addEventListener("click", () => downloadJson("exercises.json", { schema_version: 1, exercises: editor.own }));
}
