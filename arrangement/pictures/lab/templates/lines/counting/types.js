// The name of the combinatorial type, from the census of up to 6 planes: "6.3" is the third type of
// 6 planes there. Forms are compared, so the census gives names only.
const named = {};

function typeOf({ circles }) {
  const number = circles.normals.length;
  if (circles.rank < 3 || !data.census[number]) return null;
  named[number] ??= new Map(data.census[number].map((rows, k) => [canonicalMap(circlesOf(rows.map((row) => row.map(BigInt)))), `${number}.${k + 1}`]));
  return named[number].get(canonicalMap(circles)) ?? null;
}

// What the type is called besides.
function commonName({ dimension, distinct_planes: m, rank, t_vector: t, simple, simplicial }, type) {
  if (dimension === 3 && rank === 2) return "pencil";
  if (dimension === 2 || rank < 3) return "";
  if (m === 3) return "coordinate planes";
  if (t[m - 1] === 1 && t[2] === m - 1) return "near-pencil";
  if (type === "6.3") return "braid arrangement A₃";
  return simplicial ? "simplicial" : simple ? "in general position" : "";
}
