// The resisted forces (f_x, f_y) at one torque: for each choice of states an exact convex piece, by
// generators of all its solutions, mapped to forces, and turned into inequalities.
function* piecesOf(grasp, torque, states, printed = false) {
  for (const choice of states) {
    const system = systemOf(grasp, choice, [[ONE, ZERO, ZERO], [ZERO, ONE, ZERO], [ZERO, ZERO, torque]], { free: 2, printed });
    const { n, balance, equal, atLeast } = system;
    const rows = (list) => list.map((row) => integers(row).row);
    const only = (list) => rows(list.map(({ row }) => row));
    const whole = Array.from({ length: n + 1 }, (_, j) => BigInt(j === n));
    const { lines, rays } = generators(n + 1, [...only(atLeast), whole], [...rows(balance), ...only(equal)]);
    const flat = (v) => [v[n], v[3], v[4]];
    const image = rays.map(flat);
    if (image.some((v) => v[0] > 0n)) {
      const ends = lines.map(flat);
      const hull = generators(3, image, ends);
      yield pieceFrom(choice, hull, image);
    }
  }
}

// The same form as the other page of forces: rows (a, b, 0, d) say a f_x + b f_y + d >= 0.
function pieceFrom(states, { lines, rays }, image) {
  const row = ([d, a, b]) => {
    const exact = [a, b, 0n, d].map((x) => ratio(x));
    return { exact, float: scaled(exact.map(near)) };
  };
  const corners = image.filter((v) => v[0] > 0n).map((v) => [ratio(v[1], v[0]), ratio(v[2], v[0])]);
  return { states, atLeast: rays.filter(([, a, b]) => a || b).map(row), equal: lines.map(row), corners };
}
