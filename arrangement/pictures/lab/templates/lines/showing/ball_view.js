// The ball with its great circles, seen from far away, and the dual that turns with it.

const rayOf = ({ crossings }, p) => {
  const ray = ballPoint(crossings[p % crossings.length].ray);
  return p < crossings.length ? ray : ray.map((x) => -x);
};

// The curves of an arrangement, once; turning only turns them.
function curvesOf({ circles }) {
  if (circles.curves?.shape !== state.shape) {
    const list = circles.arcs.map(({ circle, from, to }) => curveOf(ballNormal(circles.normals[circle]), rayOf(circles, from), rayOf(circles, to)));
    circles.curves = { shape: state.shape, list };
  }
  return circles.curves.list;
}

function paintBall() {
  const view = at("ball");
  const { arrangement } = shown();
  const { circles, infinity, members } = arrangement;
  const turn = (p) => turned(state.axes, p);
  const curves = curvesOf(arrangement).map((curve) => curve.map(turn));
  const lone = circles.normals.length === 1 ? [curveOf(ballNormal(circles.normals[0])).map(turn)] : null;
  paintBallOf(view, circles.regions.flatMap((region) => ballRegion(arrangement, region, curves)), circles.normals.map((_, i) => {
    const grip = i === infinity ? {} : { "data-grip": `circle-${i}`, tabindex: 0, role: "button", "aria-label": `great circle ${names(members[i])}: arrows tilt it` };
    return { class: `line grip${i === infinity ? " infinity" : lineStyle(members[i])}`, "data-mark": `line-${i}`, ...grip,
      tint: lineColour(i === infinity ? null : i), curves: lone ?? curves.filter((__, e) => circles.arcs[e].circle === i) };
  }));
  circles.crossings.forEach(({ on }, p) => {
    const ray = turn(rayOf(circles, p));
    for (const way of [1, -1]) if (way * ray[2] > 1e-9) paintMark(view, [way * RADIUS * ray[0], -way * RADIUS * ray[1]], on.length, p);
  });
}

function ballRegion(arrangement, region, curves) {
  const d = region.darts.length ? clipped(boundaryOf(region.darts, curves), 1) : "";
  if (!d) return [];
  if (arrangement.infinity !== null && region.key[arrangement.infinity] === "-") return [{ class: "region beyond", d }];
  return [{ class: "region", d, "data-mark": regionName(arrangement, region), fill: colourOf(arrangement, region) }];
}

// The dual: a region is the sum of the normals with its signs. In space this is the zonotope; for
// lines of the affine plane it is a tiling of a polygon by smaller ones.
function dualOf(arrangement) {
  const { circles, infinity } = arrangement;
  if (circles.dual?.shape === state.shape) return circles.dual;
  const { arcs, regions, points } = facesOf(arrangement);
  const sides = circles.normals.map((n, i) => (i === infinity ? [0, 0, 0] : infinity === null ? ballNormal(n) : unit([...floats(n).slice(0, 2), 0])));
  const { places, faces } = zonotopeOf(circles, sides, regions, (corner, p) => {
    if (infinity === null) return rayOf(circles, corner);
    return circles.crossings[p].signs[infinity] ? [0, 0, 1] : null;
  });
  const edges = arcs.length || circles.normals.length !== 1 || infinity !== null ? arcs : [{ circle: 0, left: 0, right: 1 }];
  circles.dual = { shape: state.shape, regions, places, faces, edges, points };
  return circles.dual;
}

function paintDual() {
  const { arrangement } = shown();
  const { regions, places, faces, edges } = dualOf(arrangement);
  const flat = arrangement.infinity !== null;
  const turnedPlaces = new Map([...places].map(([id, p]) => [id, flat ? p : turned(state.axes, p)]));
  paintDualOf(at("dual"), (id) => turnedPlaces.get(id), {
    faces: faces.map(({ p, ids }) => ({ ids, "data-mark": `point-${p}` })),
    edges: edges.map(({ circle, left, right }) => ({ left, right, tint: lineColour(circle), "data-mark": `line-${circle}` })),
    vertices: regions.map((region) => ({ id: region.id, fill: colourOf(arrangement, region), "data-mark": regionName(arrangement, region) })),
  }, flat);
}
