// The name of the isomorphism class. Up to 6 planes it is from the census: "6.3" is the third type
// of 6 planes there. Beyond, simplicial planes have one from the catalogue, such as "A(9,1)". Forms
// are compared, so these lists give names only.
const named = {};

function typeOf({ circles }) {
  const number = circles.normals.length;
  const known = data.named.filter(([planes]) => planes === number);
  const listed = number <= 6 || circles.regions.every(({ darts }) => darts.length === 3);
  if (circles.rank < 3 || !known.length || !listed) return null;
  named[number] ??= new Map(known.map(([, name, rows]) => [canonicalMap(circlesOf(rows.map((row) => row.map(BigInt)))), name]));
  return named[number].get(canonicalMap(circles)) ?? null;
}

// What the type is called besides.
function commonName({ dimension, distinct_planes: m, rank, t_vector: t, simple, simplicial }, type) {
  if (dimension === 3 && rank === 2) return "pencil";
  if (dimension === 2 || rank < 3) return "";
  if (m === 3) return "coordinate planes";
  if (t[m - 1] === 1 && t[2] === m - 1) return "near-pencil";
  if (type === "6.3") return "braid arrangement A₃";
  if (type === "A(9,1)") return "mirrors of the cube B₃";
  return simplicial ? "simplicial" : simple ? "in general position" : "";
}
