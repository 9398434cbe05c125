// The grasp; for the chosen states also marks, forces and motion.
function paintGrasp() {
  const view = at("grasp");
  view.replaceChildren();
  const piece = state.found[state.choice];
  const floats = (list) => list.map((x) => x && near(x));
  const motion = state.fixed?.motion.every(Boolean) ? floats(state.fixed.motion) : null;
  const forces = state.fixed?.forces.map(floats) ?? null;
  if (data.outline) {
    paintBody(view);
    if (motion) paintMotion(view, motion);
  }
  const longest = Math.max(1e-12, ...data.contacts.map((c) => c.preload));
  data.contacts.forEach((contact, i) => {
    const { place, normal: n } = contact;
    const t = [-n[1], n[0]];
    paintContact(view, contact);
    const preload = state.kind === "own" ? contact.preload / longest : 1;
    if (state.factor.n > 0n && preload > 0) {
      arrow(view, along(place, n, -0.22 - 0.2 * preload), along(place, n, -0.19), "preload", 1.6);
    }
    if (piece) paintState(view, piece.states[i], along(place, n, -0.085), t);
  });
  paintLoads(view, forces);
  paintNames(view);
}

// The displaced outline to first order, with a motion that is made large enough to be seen.
function paintMotion(view, [x, y, r]) {
  const moved = data.outline.map((p) => {
    const [u, v] = [0, 1].map((k) => p[k] * data.size + data.centre[k]);
    return [(x - r * v) / data.size, (y + r * u) / data.size];
  });
  const most = Math.max(...moved.map((p) => Math.hypot(...p)));
  if (most < 1e-12) return;
  const places = data.outline.map((p, i) => along(p, moved[i], 0.22 / most));
  draw("path", { class: "moved", d: `M${places.map(spot).join("L")}Z` }, view);
}

function paintLoads(view, forces) {
  const force = shownForce();
  const load = force ? force.map(near) : [0, 0];
  const sizes = [Math.hypot(...load), ...(forces ?? []).map(([c, s]) => (s === null || c === null ? 0 : Math.hypot(c, s)))];
  const factor = 0.85 / Math.max(1e-12, ...sizes);
  if (forces) {
    data.contacts.forEach(({ place, normal: n }, i) => {
      const [c, s] = forces[i];
      if (c === null || s === null) return;
      arrow(view, place, along(along(place, n, c * factor), [-n[1], n[0]], s * factor), "force");
    });
  }
  const origin = data.origin;
  arrow(view, origin, along(origin, load, factor), "load", 1.4);
  paintOrigin(view);
  if (force && state.torque.n) paintTwist(view, origin, state.torque.n > 0n ? 1 : -1);
}
