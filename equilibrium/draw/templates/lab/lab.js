// The page: what is kept and shared, and how it begins.
function download(name, type, text) {
  const anchor = make("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
  at("kept").textContent = `saved: ${name}`;
}

// Copies where the browser allows it; the text is shown in any case.
function copy(text) {
  at("kept").textContent = text;
  navigator.clipboard?.writeText(text).then(() => say("copied"), () => getSelection().selectAllChildren(at("kept")));
}

const commandOf = () => `echo '${JSON.stringify(documentOf(state.grasp, state.outline))}' | equilibrium solve - --wrench ${state.wrench.map(textOf).join(" ")}`;

// A picture with its colours written into it, so that it needs no style sheet.
function svgText(id) {
  const view = at(id);
  const whole = view.cloneNode(true);
  const kept = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap",
    "opacity", "font-size", "font-weight", "font-family", "text-anchor", "dominant-baseline", "paint-order"];
  const copies = [...whole.querySelectorAll("*")];
  [...view.querySelectorAll("*")].forEach((element, k) => {
    const style = getComputedStyle(element);
    for (const name of kept) copies[k].setAttribute(name, style.getPropertyValue(name).replace(/"/g, "'"));
    copies[k].removeAttribute("class");
    copies[k].removeAttribute("style");
  });
  whole.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  whole.querySelectorAll("[data-grip] .target").forEach((element) => element.remove());
  return new XMLSerializer().serializeToString(whole);
}

function keepButtons() {
  at("copy-link").addEventListener("click", () => copy(`${location.href.split("#")[0]}#${snapshot()}`));
  at("copy-command").addEventListener("click", () => copy(commandOf()));
  at("save-grasp").addEventListener("click", () => download("grasp.json", "application/json", `${JSON.stringify(documentOf(state.grasp, state.outline), null, 2)}\n`));
  at("save-certificate").addEventListener("click", () => download("certificate.json", "application/json",
    `${JSON.stringify(certificateOf(state.grasp, state.wrench, solve(state.grasp, state.wrench)))}\n`));
  document.querySelectorAll("[data-svg]").forEach((button) => button.addEventListener("click", () => {
    download(`${{ discs: "motions", plane: "forces" }[button.dataset.svg] ?? "grasp"}.svg`, "image/svg+xml", svgText(button.dataset.svg));
  }));
  at("open-grasp").addEventListener("click", () => at("file").click());
  at("file").addEventListener("change", async () => {
    const [file] = at("file").files;
    at("file").value = "";
    if (file) attempt(async () => openText(await file.text()));
  });
}

function openText(text) {
  const document = JSON.parse(text);
  const grasp = readGrasp(document);
  if (grasp.length > data.most) throw new Error(`${grasp.length} contacts; this page takes ${data.most}`);
  load({ grasp, wrench: state.wrench, outline: readOutline(document.outline) });
}

// Runs what may fail on input from outside: then the last valid state stays.
async function attempt(action) {
  try {
    await action();
    at("problem").textContent = "";
  } catch (error) {
    at("problem").textContent = `Not taken: ${error.message}.`;
  }
}

function examples() {
  const box = at("example");
  make("option", { value: "", disabled: "", selected: "" }, box, "examples …");
  data.examples.forEach(({ name }, k) => make("option", { value: k }, box, name));
  box.addEventListener("change", () => {
    const { grasp, wrench } = data.examples[Number(box.value)];
    load({ grasp: readGrasp(grasp), wrench: readWrench(wrench), outline: readOutline(grasp.outline) });
  });
}

function turns() {
  const setTurn = (value) => {
    if (!value.n) return "angle r: give a number that is not 0.";
    Object.assign(state, { turn: value, turnChosen: true, motion: null });
    refresh();
    return "";
  };
  field(null, "turn", "angle r", setTurn);
  const slider = at("turn-slider");
  let base = ONE;
  slider.addEventListener("pointerdown", () => { base = state.turnSize(); });
  slider.addEventListener("input", () => {
    if (!state.turnChosen) base = state.turnSize();
    const way = Number(slider.value) || 1;
    setTurn(times(base, ratio(BigInt(way), 20n)));
  });
  at("regions").addEventListener("change", refresh);
}

function begin() {
  at("title").textContent = data.title;
  examples();
  ["w-x", "w-y", "w-t"].forEach((id, k) => field(at("load"), id, ["force f_x", "force f_y", "torque τ"][k], (value) => {
    edit(() => { state.wrench = state.wrench.with(k, value); });
    return "";
  }));
  turns();
  keepButtons();
  dragGrasp();
  dragPlane();
  link();
  at("discs").addEventListener("click", (event) => { const motion = motionUnder(event); if (motion) chooseMotion(motion); });
  at("undo").addEventListener("click", () => restore(state.past, state.future));
  at("redo").addEventListener("click", () => restore(state.future, state.past));
  at("undo").disabled = at("redo").disabled = true;
  document.addEventListener("keydown", (event) => {
    const typing = event.target.matches?.("input[type=text]");
    if ((event.ctrlKey || event.metaKey) && !typing && "zy".includes(event.key.toLowerCase())) {
      event.preventDefault();
      if (event.key.toLowerCase() === "y" || event.shiftKey) restore(state.future, state.past);
      else restore(state.past, state.future);
    }
    if (event.key === "Escape") { state.motion = state.leaf = null; refresh(); }
  });
  themeButton(at("theme"));
  at("algorithm").addEventListener("change", () => { state.place = 0; showStep(); refresh(); });
  at("back").addEventListener("click", () => advance(-1));
  at("step").addEventListener("click", () => advance(1));
  at("play").addEventListener("click", playSteps);
  at("where").addEventListener("input", () => advance(Number(at("where").value) - state.place));
  const first = { grasp: readGrasp(data.grasp), wrench: readWrench(data.wrench), outline: readOutline(data.grasp.outline) };
  Object.assign(state, first, { chosen: first.grasp.length ? 0 : null });
  const fromHash = () => attempt(() => { if (location.hash.length > 1 && location.hash !== `#${snapshot()}`) Object.assign(state, readHash(location.hash.slice(1)), { chosen: null }); });
  fromHash();
  window.addEventListener("hashchange", () => { fromHash(); changed(); });
  frameGrasp();
  changed();
  fitPlane();
  new ResizeObserver(fit).observe(at("plane"));
}

// For lecturers and tests: questions as documents of the command line.
window.lab = {
  solve(grasp, wrench) {
    const [contacts, applied] = [readGrasp(grasp), readWrench(wrench)];
    const found = solve(contacts, applied);
    const texts = (row) => row.map(textOf);
    return {
      stable: found.stable, certificate: certificateOf(contacts, applied, found),
      equilibria: found.equilibria.map(({ states, motion, forces, ranges }) => ({ states, motion: texts(motion), forces: forces.map(texts), unique: !ranges })),
    };
  },
  states: (grasp) => [...statesOf(readGrasp(grasp))].filter(Boolean).map(({ states }) => states),
  resists(grasp, torque, forces) {
    const contacts = readGrasp(grasp);
    const turn = readNumber(torque);
    const found = [...piecesOf(contacts, turn, [...statesOf(contacts)].filter(Boolean).map(({ states }) => states))];
    return forces.map((force) => piecesAt(found, [...force.map(readNumber), turn, ONE]).length > 0);
  },
};

begin();
