// Exact fields and sliders for the chosen contact and the load. What is not a number is marked, and
// changes nothing.
const LIMITS = { friction: [0, 2], stiffness: [0.1, 4], preload: [0, 4] };
const NAMES = { friction: "friction μ", stiffness: "stiffness k", preload: "preload q" };

function writeFields() {
  at("along-row").hidden = !state.outline;
  writeTabs("contact", state.grasp.length, state.chosen, { choose: (i) => { state.chosen = i; refresh(); },
    add: addContact, remove: removeContact, build: buildFields, addText: "add contact" });
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
  at("s-t").value = near(state.wrench[2]);
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

function buildFields(box) {
  const own = () => state.grasp[state.chosen];
  field(box, "c-x", "x", (value) => setContact({ point: [value, own().point[1]] }));
  field(box, "c-y", "y", (value) => setContact({ point: [own().point[0], value] }));
  field(box, "c-n", "normal, into the object", (normal) => setContact({ normal }), {
    read: readNormal, rule: "a direction of rational length, such as 3/5, 4/5 or 3, 4", style: "wide" });
  for (const name of FIELDS) {
    const holder = field(box, `c-${name}`, NAMES[name], (value) => setContact({ [name]: value }));
    slider(holder, `s-${name}`, NAMES[name], LIMITS[name], (value) => setContact({ [name]: value }));
  }
}

function slider(holder, id, name, [min, max], accept) {
  const box = make("input", { type: "range", id, min, max, step: 0.05, "aria-label": `${name}, slider` }, holder);
  box.addEventListener("input", () => accept(onGrid(Number(box.value), 20)));
}

function addContact() {
  if (state.grasp.length >= data.most) return;
  const angle = 2.4 * state.grasp.length + 0.6;
  const normal = nearestDirection(-Math.cos(angle), -Math.sin(angle));
  const point = [Math.cos(angle), Math.sin(angle)].map((x, k) => onGrid(data.centre[k] + x * data.size, steps()));
  const shared = state.grasp[state.chosen ?? 0];
  addTo("grasp", { point, normal, friction: shared?.friction ?? ratio(1n, 2n), stiffness: shared?.stiffness ?? ONE, preload: shared?.preload ?? ZERO });
}

const removeContact = (i) => removeFrom("grasp", i);
