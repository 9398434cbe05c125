"""A linear complementarity problem for Siconos: ``python lcp.py < contacts.json``.

It runs in the interpreter that has Siconos (Debian: python3-siconos) and prints one JSON line:
processor seconds, what Siconos says (0 is a solution), and how far the point is from one.

For each contact, with ``c_t = b - e``:

    0 <= c_n  |  c_n / k + N . d - q / k >= 0
    0 <= b    |  s + T . d >= 0
    0 <= e    |  s - T . d >= 0
    0 <= s    |  mu c_n - b - e >= 0

and ``d = u - v`` with the three balances as two inequalities each, so that everything is one
problem ``0 <= z | M z + h >= 0``. M is copositive, but Lemke's method may stop on a ray where a
solution exists: its "no" is not a proof, and its "yes" is a float.
"""

import json
import statistics
import sys
import time
from typing import Any

import numpy as np

#: Iterations of the pivoting method, and repetitions of a measurement.
ITERATIONS, RUNS = 100000, 5


def problem(contacts: list[dict[str, Any]], wrench: list[float]) -> tuple[Any, Any]:
    """Return M and h; z holds all c_n, all b, all e, all s, then u and v."""
    m = len(contacts)
    normals = np.array([c["normal_wrench"] for c in contacts])
    tangents = np.array([c["tangential_wrench"] for c in contacts])
    stiffness, preload, friction = (
        np.array([c[key] for c in contacts]) for key in ("stiffness", "preload", "friction")
    )
    matrix, constant = np.zeros((4 * m + 6,) * 2), np.zeros(4 * m + 6)
    one = np.eye(m)
    n, b, e, s = (slice(k * m, (k + 1) * m) for k in range(4))
    for sign, d in ((1, slice(4 * m, 4 * m + 3)), (-1, slice(4 * m + 3, 4 * m + 6))):
        matrix[n, d], matrix[d, n] = sign * normals, -sign * normals.T
        for side, f in ((1, b), (-1, e)):
            matrix[f, d], matrix[d, f] = sign * side * tangents, -sign * side * tangents.T
        constant[d] = -sign * np.array(wrench)
    matrix[n, n] = one / stiffness
    constant[n] = -preload / stiffness
    for f in (b, e):
        matrix[f, s], matrix[s, f] = one, -one
    matrix[s, n] = np.diag(friction)
    return matrix, constant


def solve(matrix: Any, constant: Any) -> dict[str, float]:
    """Run Siconos' Lemke pivoting; the time is the median of a few runs."""
    import siconos.numerics as sn

    size, times = len(constant), []
    for _ in range(RUNS):
        z, w = np.zeros(size), np.zeros(size)
        start = time.process_time()
        options = sn.SolverOptions(sn.SICONOS_LCP_LEMKE)
        options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = ITERATIONS
        info = sn.linearComplementarity_driver(sn.LCP(matrix, constant), z, w, options)
        times.append(time.process_time() - start)
    w = matrix @ z + constant
    error = max(0.0, -z.min(), -w.min(), np.minimum(np.abs(z), np.abs(w)).max())
    return {"seconds": statistics.median(times), "info": info, "error": float(error)}


if __name__ == "__main__":
    asked = json.load(sys.stdin)
    print(json.dumps(solve(*problem(asked["contacts"], asked["wrench"]))))
