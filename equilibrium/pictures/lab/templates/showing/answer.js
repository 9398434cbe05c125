// What the page says: the verdict, the equilibria or the proof, and the chosen motion in words.
const SIGNS = { detached: "○ detached", "slip+": "+ slips", "slip-": "− slips", stick: "● sticks", attached: "in touch" };
// A cell with an exact number: long ones are rounded, say so, and have the exact one as a title.
const cellOf = (row, x) => make("td", { class: "exact", title: textOf(x) }, row, shortText(x));

function describe() {
  const { found } = state;
  at("question").textContent = `Does the grasp resist the load ${vectorText(state.wrench)}?`;
  if (!state.fits) return;
  const verdict = at("verdict");
  verdict.className = found.stable ? "yes" : "no";
  verdict.textContent = found.stable ? "Resisted " : "Not resisted ";
  make("small", {}, verdict, found.stable ? `${equilibriaWords(found.equilibria)}${found.more ? " so far" : ""}, exact`
    : `${count(leavesOf(found.tree).length, "virtual motion proves it", "virtual motions prove it")}`);
  verdict.classList.toggle("stale", state.searching && (found.grasp !== state.grasp || found.wrench !== state.wrench));
  verdict.setAttribute("aria-busy", String(state.searching));
  at("choices").replaceChildren();
  const box = at("answer");
  const kept = box.querySelector(".proof")?.scrollTop ?? 0;
  box.replaceChildren();
  if (found.stable) describeEquilibrium(box);
  else describeProof(box);
  const proof = box.querySelector(".proof");
  if (proof) proof.scrollTop = kept;
  describeMotion();
}

// How many equilibria there are, as `equilibrium solve` says it: a family holds infinitely many.
function equilibriaWords(equilibria) {
  const n = equilibria.length, families = equilibria.filter(({ ranges }) => ranges);
  if (!families.length) return count(n, "equilibrium", "equilibria");
  const unique = families.every(({ ranges }) => ranges.slice(3).every(isPoint)) ? ` (contact forces unique${n > 1 ? " in each" : ""})` : "";
  return count(n, "family of equilibria", "families of equilibria") + unique;
}

// Whether the linear model is meant for an equilibrium: no contact point moves along its normal or
// tangent by more than a tenth of the longest side of the box around the contacts.
function isSmall({ motion }) {
  const { grasp } = state.found;
  const [wide, high] = [0, 1].map((k) => {
    const along = grasp.map(({ point }) => point[k]).sort(order);
    return along.length ? less(along[along.length - 1], along[0]) : ZERO;
  });
  const limit = times(ratio(1n, 10n), order(wide, high) > 0 ? wide : high);
  const moved = grasp.flatMap((contact) => Object.values(wrenchesOf(contact)).map((row) => size(dotted(row, motion))));
  return !limit.n || moved.every((x) => order(x, limit) <= 0);
}

function describeEquilibrium(box) {
  const { equilibria } = state.found;
  if (equilibria.length > 1) {
    equilibria.forEach((piece, k) => {
      const button = make("button", { "aria-pressed": String(k === state.choice), "data-states": String(piece.states) }, at("choices"), codeOf(piece.states));
      button.setAttribute("aria-label", `equilibrium ${k + 1}: ${piece.states.join(", ")}`);
      button.addEventListener("click", () => { state.choice = k; state.leaf = null; state.motion = null; refresh(); });
    });
  }
  const piece = equilibria[state.choice];
  const table = make("table", {}, box);
  const head = make("tr", {}, table);
  for (const text of ["", "state", "normal", "tangential"]) make("th", { scope: "col" }, head, text);
  piece.states.forEach((what, i) => {
    const row = make("tr", { "data-contact": i }, table);
    make("td", {}, row, String(i + 1));
    make("td", {}, row, SIGNS[what]);
    for (const k of [0, 1]) {
      const range = piece.ranges?.[3 + 2 * i + k];
      if (range && !isPoint(range)) make("td", { class: "exact" }, row, rangeText(range));
      else cellOf(row, piece.forces[i][k]);
    }
  });
  make("p", {}, box, piece.motion.some((x) => x.n) ? `Motion d = ${vectorText(piece.motion)}: ${motionWords(piece.motion)}.`
    : "Motion d = 0: the object rests where it is.");
  if (data.units && !isSmall(piece)) make("p", { class: "hint" }, box, "Beyond small motions: it moves a contact point by more than 1/10 of the spread of the contacts, too far for the linear model.");
  const loose = (piece.ranges ?? []).slice(0, 3).flatMap((range, k) => (isPoint(range) ? [] : [`${"xyr"[k]} in ${rangeText(range)}`]));
  if (loose.length) make("p", {}, box, `All of them: ${loose.join(", ")}.`);
  make("p", { class: "hint" }, box, piece.ranges
    ? "These states allow many solutions: a bracket gives the exact least and largest value, and the pictures show one of them."
    : "Forces on the object at each contact; with these states there is no other solution.");
}

const rangeText = ([low, high]) => `${low ? `[${shortText(low)}` : "(−∞"}, ${high ? `${shortText(high)}]` : "∞)"}`;

function motionWords([x, y, r]) {
  if (!r.n) return x.n || y.n ? `a translation along ${vectorText([x, y])}` : "no motion";
  const centre = [over(minus(y), r), over(x, r)];
  return `a ${r.n > 0n ? "counter-clockwise" : "clockwise"} rotation about ${vectorText(centre)}`;
}

// The proof: a folded tree; each leaf is a virtual motion.
function describeProof(box) {
  if (proofHidden()) {
    make("p", { class: "hint" }, box, "The proof is not shown while the exercise asks for it.");
    return;
  }
  const leaves = leavesOf(state.found.tree);
  make("p", {}, box, leaves.length === 1
    ? "On one virtual motion the load does more work than the contacts can absorb in any state."
    : "Contacts are told apart by their states; in each case a virtual motion shows that no forces balance the load.");
  const tree = make("div", { class: "proof" }, box);
  if (leaves.length > 1) branch(tree, state.found.tree, leaves, 0);
  const leaf = state.leaf ?? leaves[0];
  const panel = make("div", { class: "work" }, box);
  describeLeaf(panel, leaf, leaves.indexOf(leaf));
}

function branch(parent, node, leaves, depth) {
  if (node.motion) {
    const number = leaves.indexOf(node);
    const button = make("button", { class: "leaf", "aria-pressed": String(state.leaf === node) }, parent, `${number + 1}. ${motionWords(node.motion)}`);
    button.addEventListener("click", () => { state.leaf = node; state.motion = null; refresh(); });
    return;
  }
  for (const [name, child] of Object.entries(node.attachment ?? node.slip)) {
    const fold = make("details", { "data-contact": node.contact }, parent);
    const key = `${depth}.${node.contact}.${name}.${leaves.indexOf(leavesOf(child)[0])}`;
    fold.open = state.open.get(key) ?? (depth < 1 || leavesOf(child).length === 1);
    fold.addEventListener("toggle", () => state.open.set(key, fold.open));
    make("summary", {}, fold, `contact ${node.contact + 1} ${SIGNS[name]}`);
    branch(fold, child, leaves, depth + 1);
  }
}

function describeLeaf(panel, leaf, number) {
  const decided = leaf.states.flatMap((s, i) => (s === "undecided" ? [] : [`contact ${i + 1} ${SIGNS[s]}`]));
  make("p", {}, panel, `${number + 1}. ${decided.length ? `If ${decided.join(", ")}:` : "In every state:"}`);
  make("p", {}, panel, `Virtual motion λ = ${vectorText(leaf.motion)}, ${motionWords(leaf.motion)}.`);
  const table = make("table", {}, panel);
  const line = (name, text, value, i) => {
    const row = make("tr", i === undefined ? {} : { "data-contact": i }, table);
    make("th", { scope: "row" }, row, name);
    make("td", {}, row, text);
    cellOf(row, value);
  };
  const head = make("tr", {}, table);
  for (const text of ["", "work on λ is at least", "at d = 0"]) make("th", { scope: "col" }, head, text);
  line("load", "λ · w", leaf.work);
  state.found.grasp.forEach((contact, i) => {
    const [alpha, h] = leaf.multipliers[i];
    if (!alpha.n && !h.n) return;
    const rule = [alpha.n ? `${shortText(alpha)} e` : "", h.n ? `${shortText(h)} s` : ""].filter(Boolean).join(" + ").replace("+ -", "− ");
    line(`contact ${i + 1}`, rule, times(alpha, contact.preload), i);
  });
  line("together", "above 0, whatever d is", leaf.room);
  make("p", { class: "hint" }, panel, "e = q − k N·d: what the spring of a contact gives, s = T·d: its slip. In the sum d cancels. Contacts that are not listed work at least 0. Balance would make the sum 0.");
}

// The chosen motion: what each contact does there, and what is left of the load.
function describeMotion() {
  const line = at("motion-words");
  line.textContent = state.motion ? `d = ${vectorText(state.motion)}, ${motionWords(state.motion)}: ${state.grasp
    .map((contact, i) => `${i + 1} ${contactAt(contact, state.motion).state}`).join(", ")}.`
    : "Click a motion: the grasp shows it.";
}

// For the live region, in one sentence.
function sayVerdict() {
  const { found } = state;
  return found.stable ? `Resisted: ${found.equilibria[0].states.map((s, i) => `contact ${i + 1} ${s}`).join(", ")}.`
    : `Not resisted: ${count(leavesOf(found.tree).length, "virtual motion proves it", "virtual motions prove it")}.`;
}
