// The page: what is kept and shared, and how it begins.
const commandOf = () => `echo '${JSON.stringify(documentOf(state.grasp, state.outline))}' | equilibrium solve - --wrench ${state.wrench.map(textOf).join(" ")}`;

function keepButtons() {
  listenToKeep(openText, commandOf);
  at("save-grasp").addEventListener("click", () => downloadJson("grasp.json", documentOf(state.grasp, state.outline)));
  at("save-certificate").addEventListener("click", () => {
    downloadJson("certificate.json", certificateOf(state.grasp, state.wrench, firstOf(state.grasp, state.wrench)));
  });
}

function openText(text) {
  const document = JSON.parse(text);
  const grasp = readGrasp(document);
  if (grasp.length > data.most) throw new Error(`${grasp.length} contacts; this page takes ${data.most}`);
  load({ grasp, wrench: state.wrench, outline: readOutline(document.outline) });
}

function turns() {
  const setTurn = (value) => {
    if (!value.n) return "angle r: give a number that is not 0.";
    Object.assign(state, { turn: value, turnChosen: true, motion: null });
    refresh();
    return "";
  };
  field(null, "turn", "angle r", setTurn);
  field(null, "motion", "motion", (motion) => { chooseMotion(motion); return ""; }, { read: readMotion, rule: "three numbers x, y, r, such as 1, 0, -1/2" });
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
  listenToHead(({ grasp, wrench }) => load({ grasp: readGrasp(grasp), wrench: readWrench(wrench), outline: readOutline(grasp.outline) }));
  document.querySelector("main").dataset.first = data.first;
  const setLoad = (k, value) => edit(() => { state.wrench = state.wrench.with(k, value); });
  const loads = ["force f_x", "force f_y", "torque τ"];
  const [, , torque] = ["w-x", "w-y", "w-t"].map((id, k) => field(at("load"), id, loads[k], (value) => { setLoad(k, value); return ""; }));
  slider(torque, "s-t", loads[2], [-4, 4], (value) => setLoad(2, value));
  turns();
  keepButtons();
  dragGrasp();
  dragPlane();
  linkViews(["contact", "states"], markAll);
  listenToHistory();
  listenToPlayer();
  listenToExercises();
  listenToMethods();
  at("discs").addEventListener("click", (event) => { const motion = motionUnder(event); if (motion) chooseMotion(motion); });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") { state.motion = state.leaf = null; refresh(); }
  });
  const first = { grasp: readGrasp(data.grasp), wrench: readWrench(data.wrench), outline: readOutline(data.grasp.outline) };
  Object.assign(state, first, { chosen: first.grasp.length ? 0 : null });
  readHash();
  frameGrasp();
  changed();
  fitPlane();
  new ResizeObserver(fit).observe(at("plane"));
}

// For lecturers and tests: questions as documents of the command line.

Object.assign(window, { lab: {
  async solve(grasp, wrench) {
    const [contacts, applied] = [readGrasp(grasp), readWrench(wrench)];
    const found = firstOf(contacts, applied);
    const certificate = certificateOf(contacts, applied, found);
    /** @type {any} */ const { motion = null, forces = null, tree: proof = null } = certificate;
    return { stable: found.stable, motion, forces, proof, certificate };
  },
  async equilibria(grasp, wrench) {
    return allOf(readGrasp(grasp), readWrench(wrench))
      .map(({ states, motion, forces, ranges }) => ({ states, motion: texts(motion), forces: forces.map(texts), unique: !ranges }));
  },
  check: checkDocument,
  says: (method, grasp, wrench) => saidBy(method, readGrasp(grasp), readWrench(wrench)),
  outline: (grasp) => outlineOf(readGrasp(grasp)),
  states: (grasp) => [...statesOf(readGrasp(grasp))].filter(Boolean).map(({ states }) => states),
  pieces(grasp) {
    const contacts = readGrasp(grasp);
    const rows = (list) => list.map(({ exact }) => texts(exact));
    return drained(maximal([...piecesOf(contacts, statesOf(contacts))].filter(Boolean)))
      .map(({ states, atLeast, equal }) => ({ states, inequalities: rows(atLeast), equalities: rows(equal) }));
  },
} });

begin();
