"""The named families in rank 3: central planes on a sphere, or lines of the plane."""

from arrangement.counts import essentialization
from arrangement.library import families
from arrangement.pictures import write_drawing

SPHERES = {
    "coxeter": families.coxeter("A3"),
    "graphical": families.graphical("1-2,2-3,3-4,1-4"),
    "signed-graphical": families.signed_graphical("1-2,1-3,2-3,1+2,1+3,2+3,1"),
    "resonance": families.resonance(3),
    "threshold-functions": families.threshold_functions(2),
    "separations": families.separations("permutohedron", 3),
    "discriminantal": families.discriminantal(5, 3, seed=3),
}
LINES = {
    "shi": families.shi(3),
    "shi-2": families.shi(3, 2),
    "catalan": families.catalan(3),
    "linial": families.linial(3),
    "semiorder": families.semiorder(3),
    "ish": families.ish(3),
    "ish-b": families.ish_b(2),
    "bigraphical": families.bigraphical("1-2,2-3,1-3"),
    "points": families.discriminantal(4, 2, affine=True, seed=3),
}
for name, planes in SPHERES.items():
    write_drawing(
        essentialization(planes), f"families-{name}.svg", "stereographic", width=50, labels="none"
    )
for name, planes in LINES.items():
    write_drawing(planes, f"families-{name}.svg", "lines", width=50, labels="none")
