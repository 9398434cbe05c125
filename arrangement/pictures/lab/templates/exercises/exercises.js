// Exercises that check themselves. data.exercises lists { name, task, hints, start, goal, fixed }; a page
// defines judge(exercise), which returns { solved, words } about the present state, and
// beginExercise(exercise), which leads to its start.
const exercises = { at: null, hints: 0, solved: new Set() };

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
  Object.assign(exercises, { at: k, hints: 0 });
  at("exercise").value = k;
  at("exercise-said").textContent = "";
  beginExercise(data.exercises[k]);
  showExercise();
}

// Whether the present state solves the chosen exercise, and why not.
function checkExercise() {
  const found = judge(data.exercises[exercises.at]);
  if (found.solved) exercises.solved.add(exercises.at);
  const said = at("exercise-said");
  said.className = found.solved ? "ok" : "bad";
  said.textContent = `${found.solved ? "✓ Solved. " : "✗ Not yet. "}${found.words}`;
  showExercise();
  return found;
}

function listenToExercises() {
  const box = at("exercise");
  make("option", { value: "", disabled: "", selected: "" }, box, "choose an exercise …");
  data.exercises.forEach((_, k) => make("option", { value: k }, box));
  box.addEventListener("change", () => chooseExercise(Number(box.value)));
  at("exercise-check").addEventListener("click", checkExercise);
  at("exercise-again").addEventListener("click", () => chooseExercise(exercises.at));
  at("exercise-hint").addEventListener("click", () => { exercises.hints += 1; showExercise(); });
  at("exercises").hidden = !data.exercises.length;
  showExercise();
}
