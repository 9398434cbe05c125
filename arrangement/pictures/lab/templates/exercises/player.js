// An algorithm step by step. A page defines: stepsOf(kind), the list of steps of the algorithm that
// is chosen; tellStep(box, step, number of steps), which writes; stepShown(step), after which views follow.
const player = { place: 0, step: null, timer: null };

function showStep() {
  const kind = at("algorithm").value;
  at("player").hidden = !kind;
  const list = kind ? stepsOf(kind) : [];
  const last = Math.max(0, list.length - 1);
  player.place = Math.min(Math.max(0, player.place), last);
  Object.assign(at("where"), { max: last, value: player.place });
  player.step = list[player.place] ?? null;
  at("told").replaceChildren();
  if (kind) tellStep(at("told"), player.step, list.length);
}

function advance(way) {
  player.place += way;
  showStep();
  stepShown(player.step);
}

function stopSteps() {
  clearTimeout(player.timer);
  player.timer = null;
  at("play").textContent = "play";
}

function playSteps() {
  if (player.timer) { stopSteps(); return; }
  if (player.place >= Number(at("where").max)) player.place = -1;
  at("play").textContent = "pause";
  const next = () => {
    advance(1);
    if (player.place >= Number(at("where").max)) stopSteps();
    else player.timer = setTimeout(next, Number(at("speed").value));
  };
  next();
}

function listenToPlayer() {
  at("algorithm").addEventListener("change", () => { stopSteps(); player.place = 0; advance(0); });
  at("back").addEventListener("click", () => advance(-1));
  at("step").addEventListener("click", () => advance(1));
  at("play").addEventListener("click", playSteps);
  at("where").addEventListener("input", () => advance(Number(at("where").value) - player.place));
}
