// The ball with its great circles, seen from far away, and the dual that turns with it. Besides what is at the head of
// cells.js, state has axes, shape (matrices of points and normals: the coordinates of the ball), and whether the edges of
// the dual have one length (equal).
const ballPoint = (ray) => unit(turned(state.shape.points, floats(ray)));
const ballNormal = (normal) => unit(turned(state.shape.normals, floats(normal)));

// The curves of an arrangement, once; turning only turns them.
function curvesOf({ circles }) {
  if (circles.curves?.shape !== state.shape) {
    const list = circles.arcs.map(({ circle, from, to }) =>
      curveOf(ballNormal(circles.normals[circle]), ...[from, to].map((p) => pointOf(circles, p, ballPoint))));
    circles.curves = { shape: state.shape, list };
  }
  return circles.curves.list;
}

// Draws the ball, and returns the curves as they are drawn. `attributes(i)` are those of circle i.
function paintGlobe(view, attributes) {
  const { arrangement } = shown();
  const { circles } = arrangement;
  const frame = curvesOf(arrangement).map((curve) => curve.map((p) => turned(state.axes, p)));
  const curves = Map.groupBy(frame, (_, e) => circles.arcs[e].circle);
  view.replaceChildren();
  draw("circle", { class: "ball", r: RADIUS }, view);
  for (const region of circles.regions) paintOnBall(view, arrangement, region, frame);
  circles.normals.forEach((_, i) => {
    const group = draw("g", attributes(i), view);
    group.style.setProperty("--tint", lineColour(arrangement, i));
    const [far, near] = [-1, 1].map((side) => curves.get(i).map((curve) => visible(curve, side)).join("") || "M0,0");
    draw("path", { class: "hidden-part", d: far }, group);
    if (state.projective) draw("path", { class: "target", d: near }, group);
    draw("path", { class: "stroke", d: near }, group);
  });
  draw("circle", { class: "limb", r: RADIUS }, view);
  numberCircles(view, arrangement);
  if (at("labels").checked) labelRegions(view, arrangement);
  return frame;
}

const DISC = `M${-RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${-RADIUS},0Z`;
// The part of a region on one half; one without a boundary is the whole half.
const regionPath = ({ darts }, frame, side) => (darts.length ? clipped(boundaryOf(darts, frame), side) : DISC);

function paintOnBall(view, arrangement, region, frame) {
  const d = regionPath(region, frame, 1);
  if (!d) return;
  const beyond = arrangement.infinity !== null && region.key[arrangement.infinity] === "-";
  const style = beyond ? { class: "region beyond" } : { class: `region ${styleOf(arrangement, region)}`, "data-mark": regionName(arrangement, region) };
  draw("path", { ...style, d }, view);
}

// Numbers of the planes beside the ball, pushed apart.
function numberCircles(view, arrangement) {
  const wanted = [];
  arrangement.circles.normals.forEach((n, i) => {
    if (i === arrangement.infinity) return;
    const normal = turned(state.axes, ballNormal(n));
    const angle = Math.atan2(normal[0], -normal[1]);
    const both = [angle, angle + Math.PI];
    const gaps = both.map((a) => Math.min(9, ...wanted.map((w) => Math.abs(wrapped(a - w.angle)))));
    const chosen = both[gaps[0] >= gaps[1] - 1e-9 ? 0 : 1];
    wanted.push({ i, angle: chosen, shown: chosen });
  });
  for (let round = 0; round < 60; round += 1) {
    for (const one of wanted) {
      for (const other of wanted) {
        const gap = wrapped(one.shown - other.shown);
        if (one === other || Math.abs(gap) >= 0.1) continue;
        const push = ((0.1 - Math.abs(gap)) / 2) * (gap > 0 || (gap === 0 && one.i > other.i) ? 1 : -1);
        one.shown += push;
        other.shown -= push;
      }
    }
  }
  for (const { i, angle, shown: there } of wanted) {
    const [c, s] = [Math.cos(there), Math.sin(there)];
    draw("path", { class: "lead", d: `M${spot([Math.cos(angle), Math.sin(angle)])}L${spot([1.06 * c, 1.06 * s])}` }, view);
    const text = draw("text", { class: "number", x: fixed(112 * c), y: fixed(-112 * s) }, view, names(arrangement, i));
    text.style.setProperty("--tint", lineColour(arrangement, i));
  }
}

const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

// A direction inside a region, and how far it is from the nearest circle on its boundary.
function middleOf(arrangement, region) {
  if (region.middle?.shape !== state.shape) {
    const { circles } = arrangement;
    const alone = circles.rank === 1 ? ballNormal(circles.normals[0]).map((x) => (region.key === "+" ? x : -x)) : [0, 0, 1];
    const curves = circles.rank > 1 ? region.darts.map((dart) => curvesOf(arrangement)[dart >> 1]) : [];
    const sum = [0, 1, 2].map((k) => curves.reduce((total, curve) => total + curve[curve.length >> 1][k], 0));
    const towards = curves.length ? unit(sum) : alone;
    const room = Math.min(1, ...region.darts.map((dart) => Math.abs(dot(ballNormal(circles.normals[circles.arcs[dart >> 1].circle]), towards))));
    region.middle = { shape: state.shape, towards, room };
  }
  return region.middle;
}

// Sign vectors, where there is room for them.
function labelRegions(view, arrangement) {
  for (const region of facesOf(arrangement).regions) {
    const { towards, room } = middleOf(arrangement, region);
    const p = turned(state.axes, towards);
    const text = signsText(arrangement, keySigns(region.key));
    if (p[2] > 0.15 && 1.9 * text.length < room * p[2] * RADIUS) writeTag(view, RADIUS * p[0], RADIUS * p[1], text);
  }
}

const writeTag = (view, x, y, text) => draw("text", { class: "tag", x: fixed(x), y: fixed(-y) }, view, text);

// The dual: a region is the sum of the normals with its signs. In space this is the zonotope; for
// lines of the affine plane it is a tiling of a polygon by smaller ones.
function dualOf(arrangement) {
  const { circles, infinity } = arrangement;
  if (circles.dual?.shape === state.shape && circles.dual.equal === state.equal) return circles.dual;
  const { arcs, regions } = facesOf(arrangement);
  const lengths = state.equal ? null : lengthsOf(arrangement);
  const sides = circles.normals.map((n, i) => {
    if (infinity === null) return ballNormal(n).map((x) => (lengths ? lengths[i] * x : x));
    return i === infinity ? [0, 0, 0] : unit([...floats(n).slice(0, 2), 0]);
  });
  const { places, faces } = zonotopeOf(circles, sides, regions, (corner, p) => {
    if (infinity === null) return pointOf(circles, corner, ballPoint);
    return circles.crossings[p].signs[infinity] ? [0, 0, 1] : null;
  });
  const edges = arcs.map((arc) => ({ ...arc, e: circles.arcs.indexOf(arc) }));
  circles.dual = { shape: state.shape, equal: state.equal, regions, places, faces, edges };
  return circles.dual;
}

// The length of the normals of each circle, as given, together.
function lengthsOf({ normals, members }) {
  const entries = floats(normals.flat());
  return members.map((list) => list.reduce((sum, k) => sum + Math.hypot(...entries.slice(3 * k, 3 * k + 3)), 0));
}

// Draws the dual, and returns the places of its vertices as they are drawn, by region.
function paintDual() {
  const view = at("dual");
  const { arrangement } = shown();
  const { regions, places, faces, edges } = dualOf(arrangement);
  const flat = arrangement.infinity !== null;
  const turnedPlaces = new Map([...places].map(([id, p]) => [id, flat ? p : turned(state.axes, p)]));
  const inFront = paintDualOf(view, (id) => turnedPlaces.get(id), {
    faces: faces.map(({ corner, ids }) => ({ ids, "data-mark": pointName(arrangement.circles, corner) })),
    edges: edges.map(({ e, circle, left, right }) => ({ left, right, tint: lineColour(arrangement, circle), "data-mark": arcName(e, circle) })),
    vertices: regions.map((region) => ({ id: region.id, style: styleOf(arrangement, region), "data-mark": regionName(arrangement, region) })),
  }, flat, Math.max(1.6, Math.min(4, 24 / Math.sqrt(regions.length))));
  if (at("labels").checked) labelVertices(view, arrangement, regions.filter(({ id }) => inFront(id)), turnedPlaces);
  return turnedPlaces;
}

function labelVertices(view, arrangement, regions, places) {
  const taken = [];
  for (const { id, key } of regions.toSorted((one, other) => places.get(other.id)[2] - places.get(one.id)[2])) {
    const [x, y] = places.get(id);
    const text = signsText(arrangement, keySigns(key));
    const half = 1.9 * text.length;
    const n = Math.hypot(x, y) || 1;
    const middle = [RADIUS * x + (x / n) * (half + 3), RADIUS * y + (y / n) * 7];
    const clash = taken.some(([u, v, w]) => Math.abs(u - middle[0]) < w + half && Math.abs(v - middle[1]) < 6.5);
    if (clash || Math.abs(middle[0]) + half > 124) continue;
    taken.push([...middle, half]);
    writeTag(view, ...middle, text);
  }
}
