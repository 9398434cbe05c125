"""Which wrenches a grasp resists: exact intervals, polygons and polyhedra, and margins."""
