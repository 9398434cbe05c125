"""Decide whether a frictional grasp resists a wrench, with a certificate for either answer.

>>> from equilibrium import Contact, Grasp, solve
>>> grasp = Grasp([Contact([-1, 0], [1, 0], "1/2", preload=1),   # point, normal, friction
...                Contact([1, 0], [-1, 0], "1/2", preload=1)])
>>> verdict = solve(grasp, [0, -1, 0])                           # wrench (f_x, f_y, tau)
>>> verdict
<Verdict: resisted, wrench (0, -1, 0), 2 contacts>
>>> bool(verdict.verify())                                       # without the solver
True

Describe a grasp
    Grasp, Contact, Circle, Polygon, Mesh, Units, unit_normal, UnitNormal
    read_grasp           read a file, or a built-in grasp by name
    inputs               grasps from tables of numbers, polygons, meshes, at random

Decide one wrench
    solve                decide; returns a Verdict with Solution or Equilibrium
    Solver               many wrenches of one grasp
    solve_literal        decide by the equations as printed in the paper: LiteralVerdict

Set of resisted wrenches
    wrench_sets, check_loads, least_friction, margin, resisted_magnitudes, resisted_region,
    resisted_set, smallest_unresisted_wrench

Certificates
    verify, check        check a certificate; returns a Report
    Certificate, read_certificate, write_certificate

Other models
    methods              the methods that the paper compares with
    contact_states       the slip states of a grasp
    ContactModes, Mode   contact modes of one or several bodies

Errors
    EquilibriumError     base class; GraspError, CertificateError, TimeLimitError
"""

from arrangement import __version__ as __version__
from arrangement.console.entry import lazy_names

# Without __all__, help() shows this page alone.
__getattr__, __dir__ = lazy_names(__name__, __file__)
