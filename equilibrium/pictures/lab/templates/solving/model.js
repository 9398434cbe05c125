// Grasps and wrenches as texts: fields, files, the address of the page.
const VERSION = "1";
const FIELDS = ["friction", "stiffness", "preload"];

const isUnit = ([x, y]) => same(plus(times(x, x), times(y, y)), ONE);

// What is wrong with a contact; empty if nothing.
function contactProblem({ normal, friction, stiffness, preload }) {
  if (!isUnit(normal)) return "the normal must have exactly the length 1";
  if (friction.n < 0n) return "the friction must be at least 0";
  if (preload.n < 0n) return "the preload must be at least 0";
  return stiffness.n > 0n ? "" : "the stiffness must be above 0";
}

// The document of the command line.
function documentOf(grasp, outline = null) {
  const shape = outline ? { outline: outline.corners ? outline.corners.map((p) => p.map(textOf))
    : { centre: outline.centre.map(textOf), radius: textOf(outline.radius) } } : {};
  return { schema_version: 1, ...shape, contacts: grasp.map((contact) => ({
    point: contact.point.map(textOf), normal: contact.normal.map(textOf),
    ...Object.fromEntries(FIELDS.map((name) => [name, textOf(contact[name])])) })) };
}

// The stated shape of the object: { corners } or { centre, radius }; null if none is stated.
function readOutline(form) {
  if (form === undefined) return null;
  const circle = !Array.isArray(form);
  const pairs = (circle ? [form?.centre] : form).map((p) => (Array.isArray(p) && p.length === 2 ? p.map((x) => readNumber(String(x))) : [null]));
  const radius = circle ? readNumber(String(form?.radius)) : ONE;
  if (pairs.flat().includes(null) || !radius || radius.n <= 0n || (!circle && pairs.length < 3)) {
    throw new Error("the outline must be three corners or more, or an object with centre and radius");
  }
  return circle ? { centre: pairs[0], radius } : { corners: pairs };
}

// The place on a stated outline nearest to a point, with the normal there; null if no side of it has
// an exactly unit normal.
function onOutline({ corners, centre, radius }, [x, y], steps) {
  if (centre) {
    const normal = nearestDirection(near(centre[0]) - x, near(centre[1]) - y);
    return { point: centre.map((c, k) => less(c, times(radius, normal[k]))), normal };
  }
  const turn = corners.reduce((sum, [a, b], i) => {
    const [c, d] = corners[(i + 1) % corners.length];
    return plus(sum, less(times(a, d), times(b, c)));
  }, ZERO).n > 0n ? ONE : minus(ONE);
  const sides = corners.map((from, i) => {
    const way = corners[(i + 1) % corners.length].map((c, k) => less(c, from[k]));
    const normal = unitOf([times(turn, minus(way[1])), times(turn, way[0])]);
    const [u, v] = way.map(near);
    const share = ((x - near(from[0])) * u + (y - near(from[1])) * v) / (u * u + v * v || 1);
    const parts = Math.max(1, Math.round(Math.hypot(u, v) * steps));
    const point = added(from, scaledBy(way, onGrid(Math.min(1, Math.max(0, share)), parts)));
    return { point, normal, away: Math.hypot(near(point[0]) - x, near(point[1]) - y) };
  }).filter(({ normal }) => normal);
  return sides.length ? sides.reduce((best, side) => (side.away < best.away ? side : best)) : null;
}

// A number of a document: a text, or an integer.
function numberOf(value, where) {
  const read = typeof value === "string" || Number.isInteger(value) ? readNumber(String(value)) : null;
  if (!read) throw new Error(`${where} must be a text with ${NUMBER_RULE}`);
  return read;
}

// Throws an Error that says what is wrong.
function readGrasp(document) {
  if (!Array.isArray(document?.contacts) || document.schema_version !== 1) {
    throw new Error("this is not a grasp: it needs \"schema_version\": 1 and a list \"contacts\"");
  }
  return document.contacts.map((entry, i) => {
    const number = (value, name) => numberOf(value, `contact ${i + 1}: ${name}`);
    const pair = (value, name) => {
      if (!Array.isArray(value) || value.length !== 2) throw new Error(`contact ${i + 1}: ${name} must be two numbers`);
      return value.map((x) => number(x, name));
    };
    const strange = Object.keys(entry ?? {}).find((name) => !["point", "normal", ...FIELDS].includes(name));
    if (strange !== undefined) throw new Error(`contact ${i + 1}: there is no "${strange}"`);
    const { point, normal, friction, stiffness = "1", preload = "0" } = entry ?? {};
    const contact = { point: pair(point, "point"), normal: pair(normal, "normal"),
      friction: number(friction, "friction"), stiffness: number(stiffness, "stiffness"), preload: number(preload, "preload") };
    const problem = contactProblem(contact);
    if (problem) throw new Error(`contact ${i + 1}: ${problem}`);
    return contact;
  });
}

function readWrench(values) {
  if (!Array.isArray(values) || values.length !== 3) throw new Error("the wrench must be three numbers: force x, force y, torque");
  return values.map((x) => numberOf(x, "the wrench"));
}

// The state in the address: "1|x,y,nx,ny,friction,stiffness,preload;...|fx,fy,torque", and the outline,
// if it is stated: "|x,y;x,y;...", or "|x,y,radius" of a circle.
function hashOf(grasp, wrench, outline = null) {
  const contacts = grasp.map((c) => [...c.point, ...c.normal, ...FIELDS.map((name) => c[name])].map(textOf).join(","));
  const shape = outline ? [(outline.corners ?? [[...outline.centre, outline.radius]]).map((p) => p.map(textOf).join(",")).join(";")] : [];
  return [VERSION, contacts.join(";"), wrench.map(textOf).join(","), ...shape].join("|");
}

function readState(text, most) {
  const [version, contacts, wrench, shape, ...rest] = text.split("|");
  if (version !== VERSION) throw new Error(`the link is of version ${version.slice(0, 9)}; this page reads ${VERSION}`);
  if (wrench === undefined || rest.length) throw new Error("the link is not whole");
  const list = contacts ? contacts.split(";").map((one) => {
    const [x, y, nx, ny, friction, stiffness, preload] = one.split(",");
    return { point: [x, y], normal: [nx, ny], friction, stiffness, preload };
  }) : [];
  if (list.length > most) throw new Error(`${list.length} contacts; this page takes ${most}`);
  const places = shape?.split(";").map((one) => one.split(","));
  const outline = places?.length === 1 ? { centre: places[0].slice(0, 2), radius: places[0][2] } : places;
  return { grasp: readGrasp({ schema_version: 1, contacts: list }), wrench: readWrench(wrench.split(",")), outline: readOutline(outline) };
}

// Exactly unit vectors, about 200 of them: (1 - t^2, 2 t) / (1 + t^2) for rational t, all quarters.
const DIRECTIONS = (() => {
  const found = new Map();
  for (let q = 1n; q <= 8n; q += 1n) {
    for (let p = 0n; p <= q; p += 1n) {
      if (gcdOf(p, q) !== 1n) continue;
      let [x, y] = [ratio(q * q - p * p, q * q + p * p), ratio(2n * p * q, q * q + p * p)];
      for (let turn = 0; turn < 4; turn += 1) {
        [x, y] = [minus(y), x];
        found.set(`${textOf(x)},${textOf(y)}`, [x, y]);
      }
    }
  }
  const angle = ([x, y]) => Math.atan2(near(y), near(x));
  return [...found.values()].toSorted((a, b) => angle(a) - angle(b));
})();

function nearestDirection(x, y) {
  const score = (v) => near(v[0]) * x + near(v[1]) * y;
  return DIRECTIONS.reduce((best, v) => (score(v) > score(best) ? v : best));
}

// The next unit vector counter-clockwise (1) or clockwise (-1).
function nextDirection(normal, way) {
  const here = DIRECTIONS.findIndex((v) => same(v[0], normal[0]) && same(v[1], normal[1]));
  if (here >= 0) return DIRECTIONS.at((here + way) % DIRECTIONS.length);
  return nearestDirection(...[Math.cos, Math.sin].map((f) => f(Math.atan2(near(normal[1]), near(normal[0])) + way * 0.05)));
}

// Numbers apart by commas or spaces, or by semicolons or spaces with decimal commas; null if they
// are not as many.
function readTuple(text, length) {
  const bare = text.replace(/[()]/g, "");
  for (const [apart, read] of [[/[,\s]+/, readNumber], [/[;\s]+/, readTyped]]) {
    const parts = bare.split(apart).filter(Boolean).map(read);
    if (parts.length === length && !parts.includes(null)) return parts;
  }
  return null;
}

const readMotion = (text) => readTuple(text, 3);
// A direction as text: exact where its length is rational; else null.
const readNormal = (text) => { const parts = readTuple(text, 2); return parts && unitOf(parts); };

// A direction made exactly unit; null if its length is not rational.
function unitOf(parts) {
  const square = plus(times(parts[0], parts[0]), times(parts[1], parts[1]));
  const root = (x) => {
    let r = BigInt(Math.floor(Math.sqrt(Number(x))));
    for (let k = 0; k < 9 && r > 0n; k += 1) r = (r + x / r) / 2n;
    return r * r === x ? r : null;
  };
  const [n, d] = [root(square.n), root(square.d)];
  return n && d ? parts.map((x) => over(x, ratio(n, d))) : null;
}
