// Floats that lead the search, and exact leaves from what they point at. Nothing rests on a float: a node
// that floats cannot refute is split further, and a leaf counts once the checker accepts it exactly.
const FREE = 0, FIXED = 1, SLACK = 2, WATCHED = 3;
const TINY = 1e-9;
// The rows of a contact, and what a state asks of them: 0 fixed, 1 at least 0, -1 at most 0.
const ROWS = ["least", "normal", "cone-", "cone+", "spring", "slip"];
const ASKS = {
  undecided: { least: 1, normal: 1, "cone-": 1, "cone+": 1 },
  detached: { normal: 0, "cone-": 0, spring: -1 }, attached: { least: 0 },
  stick: { slip: 0 }, "slip+": { "cone+": 0, slip: 1 }, "slip-": { "cone-": 0, slip: -1 },
};

// A dictionary as `Dictionary`, in floats: unknowns are the motion and two forces of each contact, rows are
// the balance and ROWS. A child goes on from the dictionary of its parent.
class Guide {
  m = 0;
  n = 0;
  /** @type {Float64Array[]} */
  t = [];
  /** @type {number[]} */
  basic = [];
  /** @type {number[]} */
  columns = [];
  kinds = new Uint8Array(0);
  places = new Int32Array(0);
  /** @type {Set<number> | null} */
  blamed = null;
  root = true;

  static root(grasp, wrench) {
    const [far, force, stiff] = [grasp.flatMap((c) => c.point), [...wrench, ...grasp.map((c) => c.preload)], grasp.map((c) => c.stiffness)]
      .map((list) => list.map(size).reduce((most, x) => (order(x, most) > 0 ? x : most), ZERO)).map((x) => (x.n ? x : ONE));
    const shares = (v, unit) => v.map((x) => near(over(x, unit)));
    const m = grasp.length;
    const n = 3 + 2 * m;
    const rows = [0, 1, 2].map(() => new Float64Array(n + 1));
    wrench.forEach((x, j) => { [rows[j][n]] = shares([x], j < 2 ? force : times(force, far)); });
    grasp.forEach((contact, i) => {
      const { N, T } = wrenchesOf(contact);
      const [[a, b, nr], [c, e, tr]] = [N, T].map((v) => [...shares(v.slice(0, 2), ONE), ...shares(v.slice(2), far)]);
      const [[k], [q], mu] = [shares([contact.stiffness], stiff), shares([contact.preload], force), near(contact.friction)];
      const [at, rub] = [3 + 2 * i, Math.max(1, mu)];
      [a, b, nr].forEach((x, j) => { rows[j][at] = x; });
      [c, e, tr].forEach((x, j) => { rows[j][at + 1] = x; });
      const row = (d, normal, tangential, constant) => {
        const found = new Float64Array(n + 1);
        found.set(d);
        [found[at], found[at + 1], found[n]] = [normal, tangential, constant];
        rows.push(found);
      };
      const [pressed, none] = [[k * a, k * b, k * nr], [0, 0, 0]];
      row(pressed, 1, 0, -q);
      row(none, 1, 0, 0);
      row(none, mu / rub, -1 / rub, 0);
      row(none, mu / rub, 1 / rub, 0);
      row(pressed.map((x) => -x), 0, 0, q);
      row([c, e, tr], 0, 0, 0);
    });
    const found = new Guide();
    const labels = n + rows.length;
    Object.assign(found, { m, n, t: rows, basic: rows.map((_, i) => n + i), columns: Array.from({ length: n }, (_, j) => j),
      kinds: new Uint8Array(labels).fill(WATCHED, n).fill(FREE, 0, n).fill(FIXED, n, n + 3), places: new Int32Array(labels), blamed: null });
    found.columns.forEach((label, j) => { found.places[label] = -1 - j; });
    found.basic.forEach((label, r) => { found.places[label] = r; });
    for (let i = 0; i < m; i += 1) found.ask(i, "undecided");
    return found;
  }

  label(i, name) { return this.n + 3 + 6 * i + ROWS.indexOf(name); }

  // What holds in a further state of a contact.
  child(i, state) {
    const found = new Guide();
    Object.assign(found, this, { t: this.t.map((row) => row.slice()), basic: [...this.basic], columns: [...this.columns], kinds: this.kinds.slice(), places: this.places.slice(), blamed: null, root: false });
    found.ask(i, state);
    return found;
  }

  ask(i, state) {
    for (const [name, way] of Object.entries(ASKS[state])) {
      const label = this.label(i, name);
      this.kinds[label] = way ? SLACK : FIXED;
      if (way < 0) this.t[this.places[label]].forEach((x, j, row) => { row[j] = -x; });
    }
  }

  pivot(r, c) {
    const { t, basic, columns, places } = this;
    const own = t[r];
    const p = own[c];
    for (let i = 0; i < t.length; i += 1) {
      const row = t[i];
      if (i === r || !row[c]) continue;
      const share = row[c] / p;
      for (let j = 0; j < row.length; j += 1) row[j] -= share * own[j];
      row[c] = share;
    }
    for (let j = 0; j < own.length; j += 1) own[j] /= -p;
    own[c] = 1 / p;
    [basic[r], columns[c]] = [columns[c], basic[r]];
    [places[basic[r]], places[columns[c]]] = [r, -1 - c];
  }

  // False where floats see that nothing holds; `blamed` has the labels of the rows that contradict.
  feasible() {
    const { t, n, basic, columns, kinds } = this;
    const largest = (length, value) => {
      let [found, most] = [-1, TINY];
      for (let k = 0; k < length; k += 1) if (value(k) > most) [found, most] = [k, value(k)];
      return found;
    };
    for (let r = 0; r < basic.length; r += 1) {
      if (kinds[basic[r]] !== FIXED) continue;
      const c = largest(n, (j) => (kinds[columns[j]] === FIXED ? 0 : Math.abs(t[r][j])));
      if (c >= 0) this.pivot(r, c);
      else if (Math.abs(t[r][n]) > TINY) return this.blame(r);
    }
    for (let c = 0; c < n; c += 1) {
      if (kinds[columns[c]] !== FREE) continue;
      const r = largest(t.length, (i) => (kinds[basic[i]] === SLACK ? Math.abs(t[i][c]) : 0));
      if (r >= 0) this.pivot(r, c);
    }
    const least = (labels, passes) => labels.reduce((found, label, k) => (kinds[label] === SLACK && passes(k)
      && (found < 0 || label < labels[found]) ? k : found), -1);
    for (let steps = 0; steps < 400; steps += 1) {
      const r = least(basic, (i) => t[i][n] < -TINY);
      if (r < 0) break;
      const c = least(columns, (j) => t[r][j] > TINY);
      if (c < 0) return this.blame(r);
      this.pivot(r, c);
    }
    return true;
  }

  blame(r) {
    this.blamed = new Set([this.basic[r], ...this.columns.filter((_, j) => Math.abs(this.t[r][j]) > TINY)]);
    return false;
  }

  value(label) { return this.places[label] < 0 ? 0 : this.t[this.places[label]][this.n]; }

  // Of each contact: spring, slip, forces, and how far they are from its law.
  contacts(grasp, states) {
    return grasp.map(({ friction }, i) => {
      const of = (name) => this.value(this.label(i, name)) * (ASKS[states[i]][name] < 0 ? -1 : 1);
      const [spring, slip, normal, tangential] = [of("spring"), of("slip"), this.value(3 + 2 * i), this.value(4 + 2 * i)];
      const rubbing = Math.abs(slip) > TINY ? Math.abs(tangential + Math.sign(slip) * near(friction) * normal) : 0;
      const state = spring < TINY ? "detached" : slip > TINY ? "slip+" : slip < -TINY ? "slip-" : "stick";
      return { state, broken: Math.abs(normal - Math.max(0, spring)) + rubbing };
    });
  }
}

// The exact leaf with the multipliers that floats blame: motion, shares alpha and h of each contact, such
// that the motion d cancels in load . motion + sum (alpha e + h s). Null if they do not determine it.
function blamedLeaf(grasp, wrench, states, guide) {
  const has = (i, name) => guide.blamed.has(guide.label(i, name));
  let unknowns = 3;
  const parts = grasp.map((contact, i) => {
    const { N, T } = wrenchesOf(contact);
    const [low, high] = [has(i, "cone-"), has(i, "cone+")];
    const rubbed = scaledBy(T, low === high ? ZERO : times(contact.friction, high ? ONE : minus(ONE)));
    const loose = has(i, "normal") || (low && high) || has(i, "spring");
    const one = { contact, N, T, kappa: added(N, minusRow(rubbed)), still: !low && !high, loose,
      pressed: has(i, "least") || has(i, "spring"), alpha: -1, h: has(i, "slip") ? unknowns++ : -1 };
    if (one.pressed && loose) one.alpha = unknowns++;
    return one;
  });
  const cancel = [0, 1, 2].map(() => Array.from({ length: unknowns }, () => ZERO));
  const rows = [...cancel];
  const wide = (v) => [...v, ...Array.from({ length: unknowns - 3 }, () => ZERO)];
  for (const { contact, N, T, kappa, still, loose, pressed, alpha, h } of parts) {
    if (still) rows.push(wide(T));
    if (!loose && !pressed) rows.push(wide(kappa));
    cancel.forEach((row, j) => {
      const stiff = times(contact.stiffness, N[j]);
      if (alpha >= 0) row[alpha] = minus(stiff);
      else if (pressed) kappa.forEach((x, k) => { row[k] = less(row[k], times(stiff, x)); });
      if (h >= 0) row[h] = T[j];
    });
  }
  const { lines } = generators(unknowns, [], rows.map((row) => integers(row).row));
  if (lines.length !== 1) return null;
  const line = lines[0].map((x) => ratio(x));
  const motion = line.slice(0, 3);
  const pairs = parts.map(({ kappa, pressed, alpha, h }) => [alpha >= 0 ? line[alpha] : pressed ? dotted(motion, kappa) : ZERO, h >= 0 ? line[h] : ZERO]);
  const leaf = shortened(grasp, motion, pairs, wrench);
  if (leaf.room.n > 0n) return { states, ...leaf };
  const negated = (row) => row.map(minus);
  return { states, ...shortened(grasp, negated(motion), pairs.map(negated), wrench) };
}
