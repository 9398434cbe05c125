// Exercises that check themselves. data.exercises lists { name, task, hints, start, goal, fixed }; a page
// defines judge(exercise), which returns { solved, words } about the present state, or a promise of it, and
// beginExercise(exercise), which leads to its start.
const exercises = { at: null, hints: 0, solved: new Set(), checks: 0 };

function showExercise() {
  const exercise = data.exercises[exercises.at];
  at("exercise-box").hidden = !exercise;
  at("exercise-done").textContent = `${exercises.solved.size} of ${data.exercises.length} solved`;
  [...at("exercise").options].forEach((option) => {
    const k = option.value === "" ? -1 : Number(option.value);
    if (k >= 0) option.textContent = `${exercises.solved.has(k) ? "✓ " : ""}${k + 1}. ${data.exercises[k].name}`;
  });
  if (!exercise) return;
  at("exercise-task").textContent = exercise.task;
  const list = at("exercise-hints");
  list.replaceChildren();
  for (const hint of exercise.hints.slice(0, exercises.hints)) make("li", {}, list, hint);
  at("exercise-hint").disabled = exercises.hints >= exercise.hints.length;
}

function chooseExercise(k) {
  Object.assign(exercises, { at: k, hints: 0, checks: exercises.checks + 1 });
  at("exercise").value = k;
  Object.assign(at("exercise-said"), { textContent: "", ariaBusy: "false" });
  beginExercise(data.exercises[k]);
  showExercise();
}

// Whether the present state solves the chosen exercise, and why not. What is asked later ends a check.
async function checkExercise() {
  const [{ at: k }, number, said] = [exercises, (exercises.checks += 1), at("exercise-said")];
  Object.assign(said, { className: "", textContent: "Checking …", ariaBusy: "true" });
  const found = await (async () => judge(data.exercises[k]))().catch((error) => ({ solved: null, words: error.message }));
  if (number !== exercises.checks) return;
  if (found.solved) exercises.solved.add(k);
  const start = found.solved ? "✓ Solved. " : found.solved === null ? "" : "✗ Not yet. ";
  Object.assign(said, { className: found.solved ? "ok" : "bad", textContent: start + found.words, ariaBusy: "false" });
  showExercise();
}

function listExercises() {
  const box = at("exercise");
  box.replaceChildren();
  make("option", { value: "", disabled: "", selected: "" }, box, "choose an exercise …");
  data.exercises.forEach((_, k) => make("option", { value: k }, box));
  if (exercises.at !== null) box.value = exercises.at;
  showExercise();
}

function listenToExercises() {
  const box = at("exercise");
  box.addEventListener("change", () => chooseExercise(Number(box.value)));
  at("exercise-check").addEventListener("click", checkExercise);
  at("exercise-again").addEventListener("click", () => chooseExercise(exercises.at));
  at("exercise-hint").addEventListener("click", () => { exercises.hints += 1; showExercise(); });
  at("exercises").open = data.own;
  listExercises();
  listenToEditor();
}
