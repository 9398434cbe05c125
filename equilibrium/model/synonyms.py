"""Words of a course in statics for what can be asked of a grasp G under a wrench w, and the names.

`Grasp`, `Verdict` and the package answer unknown names with them; a page of the documentation shows
them; a test runs each.
"""

from __future__ import annotations

from collections.abc import Mapping

from arrangement.synonyms import by_word

#: By subject.
STATICS: Mapping[str, Mapping[str, str]] = {
    "Supports and loads": {
        "support": 'Contact([0, -1], [0, 1], "1/2")',
        "smooth support": "Contact([0, -1], [0, 1], 0)",
        "roller": "Contact([0, -1], [0, 1], 0)",
        "rough support": 'Contact([0, -1], [0, 1], "3/4")',
        "coefficient of friction": "G.contacts[0].friction",
        "angle of friction": "math.degrees(math.atan(G.contacts[0].friction))",
        "couple": "[0, 0, 1]",
        "weight": "[0, -1, 0]",
        "prestress": "G.with_preload(1)",
        "free-body diagram": 'G.draw("grasp", wrench=w)',
        "several bodies": "Assembly.from_polygons",
    },
    "Equilibrium": {
        "in equilibrium": "solve(G, w).stable",
        "statically determinate": "len(solve(G, w).equilibria)",
        "statically indeterminate": "solve(G, w).equilibria",
        "reactions": "solve(G, w).solution.forces",
        "support reactions": "solve(G, w).solution.forces",
        "normal force": "solve(G, w).solution.forces[0][0]",
        "friction force": "solve(G, w).solution.forces[0][1]",
        "displacement": "solve(G, w).solution.motion",
        "sticking": "solve(G, w).states",
        "slipping": "solve(G, w).states",
        "tipping": "solve(G, w).states",
        "proof": "solve(G, w).certificate",
        "principle of virtual work": "solve(G, w).certificate",
    },
    "Limits": {
        "impending motion": "ResistedSet(G).along(w)",
        "impending slip": "ResistedSet(G).along(w)",
        "limit load": "ResistedSet(G).along(w).intervals",
        "largest load": "ResistedSet(G).along(w).intervals",
        "load factor": "ResistedSet(G).margin(w).intervals",
        "factor of safety": "ResistedSet(G).margin(w).around",
        "safety factor": "ResistedSet(G).margin(w).around",
        "required friction": "ResistedSet(G).margin(w).friction()",
        "clamping force": "ResistedSet(G).margin(w).preloads",
        "interaction diagram": "ResistedSet(G).slice([1, 0, 0], [0, 1, 0])",
        "yield surface": "ResistedSet(G).polyhedra",
        "failure mechanism": "ResistedSet(G).what_gives(ResistedSet(G).along(w))",
        "rigid supports": "compare(G, w)",
    },
}

#: The same as names in Python: "factor of safety" is ``factor_of_safety``.
NAMES: Mapping[str, str] = {
    word.replace(" ", "_").replace("-", "_"): name
    for words in STATICS.values()
    for word, name in words.items()
}

#: Other words for arguments of `equilibrium.solve` and what is computed as it is.
ARGUMENTS: Mapping[str, str] = by_word("""
    direction external_wrench f force forces load moment tau torque w -> wrench=[f_x, f_y, torque]
    weight gravity wrenches -> wrench=[f_x, f_y, torque]
    contacts assembly system -> grasp
    friction mu -> grasp.with_friction(friction)
    preload -> grasp.with_preload(preload)
    timeout -> time_limit
    parameter -> letter
    literal -> as_printed
""")
