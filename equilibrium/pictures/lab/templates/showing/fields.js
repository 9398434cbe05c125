// Exact fields and sliders for the chosen contact and the load. What is no number is marked, and
// changes nothing.
const LIMITS = { friction: [0, 2], stiffness: [0.1, 4], preload: [0, 4] };
const NAMES = { friction: "friction μ", stiffness: "stiffness k", preload: "preload q" };

function writeFields() {
  const tabs = at("tabs");
  at("along-row").hidden = !state.outline;
  const list = [...state.grasp.keys()];
  const wanted = `${list.length}/${state.chosen}`;
  if (tabs.dataset.shown !== wanted) {
    const held = /** @type {HTMLElement} */ (document.activeElement)?.dataset?.tab;
    tabs.dataset.shown = wanted;
    tabs.replaceChildren();
    for (const i of list) {
      const button = make("button", { "aria-pressed": String(i === state.chosen), "data-contact": i, "data-tab": i, "aria-label": `contact ${i + 1}` }, tabs, String(i + 1));
      button.addEventListener("click", () => { state.chosen = i; refresh(); });
    }
    const add = make("button", { id: "add" }, tabs, "add contact");
    add.disabled = list.length >= data.most;
    add.addEventListener("click", addContact);
    const remove = make("button", { id: "remove" }, tabs, "remove");
    remove.disabled = state.chosen === null;
    remove.addEventListener("click", () => removeContact(state.chosen));
    buildFields();
    if (held !== undefined) tabs.querySelector(`[data-tab="${held}"]`)?.focus();
  }
  const contact = state.grasp[state.chosen];
  if (contact) {
    write("c-x", contact.point[0]);
    write("c-y", contact.point[1]);
    writeText("c-n", contact.normal.map(textOf).join(", "));
    for (const name of FIELDS) {
      write(`c-${name}`, contact[name]);
      at(`s-${name}`).value = near(contact[name]);
    }
  }
  ["w-x", "w-y", "w-t"].forEach((id, k) => write(id, state.wrench[k]));
  write("turn", state.turn);
  writeText("motion", state.motion ? state.motion.map(textOf).join(", ") : "");
}

function setContact(values) {
  const next = { ...state.grasp[state.chosen], ...values };
  const problem = contactProblem(next);
  if (problem) return `Contact ${state.chosen + 1}: ${problem}.`;
  edit(() => {
    state.grasp = state.grasp.map((contact, i) => {
      if (i === state.chosen) return next;
      const shared = Object.fromEntries(Object.entries(values).filter(([name]) => FIELDS.includes(name)));
      return at("alike").checked ? { ...contact, ...shared } : contact;
    });
  });
  return "";
}

function buildFields() {
  const box = at("fields");
  box.replaceChildren();
  box.className = "fields";
  if (state.chosen === null) {
    make("p", { class: "hint" }, box, "Choose a contact, here or in the picture.");
    return;
  }
  const own = () => state.grasp[state.chosen];
  field(box, "c-x", "x", (value) => setContact({ point: [value, own().point[1]] }));
  field(box, "c-y", "y", (value) => setContact({ point: [own().point[0], value] }));
  field(box, "c-n", "normal, into the object", (normal) => setContact({ normal }), {
    read: readNormal, rule: "a direction of rational length, such as 3/5, 4/5 or 3, 4", style: "wide" });
  for (const name of FIELDS) {
    const holder = field(box, `c-${name}`, NAMES[name], (value) => setContact({ [name]: value }));
    const [min, max] = LIMITS[name];
    const slider = make("input", { type: "range", id: `s-${name}`, min, max, step: 0.05, "aria-label": `${NAMES[name]}, slider` }, holder);
    slider.addEventListener("input", () => setContact({ [name]: onGrid(Number(slider.value), 20) }));
  }
}

function addContact() {
  if (state.grasp.length >= data.most) return;
  const angle = 2.4 * state.grasp.length + 0.6;
  const normal = nearestDirection(-Math.cos(angle), -Math.sin(angle));
  const steps = Number(at("grid").value);
  const point = [Math.cos(angle), Math.sin(angle)].map((x, k) => onGrid(data.centre[k] + x * data.size, steps));
  const shared = state.grasp[state.chosen ?? 0];
  edit(() => {
    state.grasp = [...state.grasp, { point, normal, friction: shared?.friction ?? ratio(1n, 2n), stiffness: shared?.stiffness ?? ONE, preload: shared?.preload ?? ZERO }];
    state.chosen = state.grasp.length - 1;
  });
}

function removeContact(i) {
  if (i === null || !state.grasp[i]) return;
  edit(() => {
    state.grasp = state.grasp.filter((_, k) => k !== i);
    state.chosen = state.grasp.length ? Math.min(i, state.grasp.length - 1) : null;
  });
}
