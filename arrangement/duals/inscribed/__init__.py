"""The dual and the unit sphere: points in the regions, their hull, and duals that are inscribed.

[HaasHeger2018], section IV.A, takes a point of the unit sphere in each region and says that the
dual polyhedron with these vertices is convex. Two questions follow, and both are decided exactly:

* *These points:* the hull of given points is convex, but are its edges the adjacencies? See
  `representative_hull`.
* *Any points:* is there a convex polyhedron at all that has the graph of the dual and its vertices
  on a sphere? `inscribability` answers by Rivin's criterion. A "no" rules out every choice of
  points. A "yes" gives some inscribed polyhedron with this graph; that its vertices can also be
  placed in their regions is a further condition, which `representative_hull` checks for points at
  hand.
"""
