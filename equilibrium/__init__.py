"""Decide whether a frictional grasp resists a wrench, with a certificate for either answer.

>>> from equilibrium import Contact, Grasp, ResistedSet, solve
>>> grasp = Grasp([Contact([-1, 0], [1, 0], "1/2", preload=1),   # point, normal, friction
...                Contact([1, 0], [-1, 0], "1/2", preload=1)])
>>> verdict = solve(grasp, [0, -1, 0])                           # wrench (f_x, f_y, tau)
>>> verdict
<Verdict: resisted, wrench (0, -1, 0), 2 contacts>
>>> bool(verdict.verify())                                       # without the solver
True
>>> [str(t) for t in ResistedSet(grasp).along([0, -1, 0]).intervals[0]]
['0', '1']

Describe a grasp
    Grasp, Contact       contacts on a rigid object, in the plane or in space
    unit_normal          rational unit vector near a direction: UnitNormal
    Circle, Polygon, Segments, Sphere, Mesh, Units    outlines, and what numbers are measured in
    read_grasp           read a file, or a built-in grasp by name
    inputs               grasps from tables of numbers, polygons, meshes, at random
    Assembly, RigidBody, BodyContact    several bodies in the plane; read_assembly reads a file

Decide one wrench
    solve, solve_many    decide one wrench, or many on one grasp
    Verdict              the answer, with its proof: a Solution, all Equilibrium families

Set of resisted wrenches
    ResistedSet          along a direction, in a plane, as polyhedra; margins; arrays of wrenches
    resisted_values      for which values of a letter in the data it resists: ResistedValues
    sufficient_friction  the least friction of named contacts: SufficientFriction

Many grasps
    check_grasps         decide arrays of grasps and wrenches in floats: CheckedGrasps

Certificates
    verify               check a certificate without the solver: Report
    Certificate, read_certificate

Other models
    compare              the verdicts of all methods that the paper compares with
    GraspWrenchSpace     force closure, epsilon and volume
    ContactModes         contact modes of one or several bodies

Pictures and errors
    pictures             every picture and page; `Grasp.draw` draws one
    EquilibriumError     base class; GraspError, CertificateError, TimeLimitError

``help(equilibrium.ResistedSet)`` lists the methods.
"""

from arrangement import __version__ as __version__
from arrangement.console.plugins import attach, lazy_names
from arrangement.synonyms import by_word

#: Other words for the names, each with what to write here.
_SYNONYMS = by_word("""
    from_csv load load_grasp read read_csv -> read_grasp(path)
    load_assembly -> read_assembly(path)
    plot show -> read_grasp(path).draw()
    check -> verify(source)
    is_stable -> solve(grasp, wrench).stable
    resisted -> ResistedSet(grasp).along(wrench)
    Solver WrenchSet resisted_set -> ResistedSet(grasp)
    is_force_closure -> GraspWrenchSpace(grasp).force_closure
    grasp_wrench_space wrench_space -> GraspWrenchSpace(grasp)
""")

attach(
    {
        "Assembly.from_polygons": "equilibrium.grasps.inputs.touching:touching_polygons",
        "Grasp.save": "equilibrium.grasps.inputs.csv_file:table_text",
        "CheckedGrasps.closure_friction": "equilibrium.methods.closure_friction:closure_frictions",
        "Grasp.draw": "equilibrium.pictures.views:DRAWINGS",
        "Grasp.lab": "equilibrium.pictures.lab.page:lab_in_notebook",
        "Grasp._repr_svg_": "equilibrium.pictures.notebook:grasp_svg",
        "ResistedValues.draw": "equilibrium.pictures.parameter:draw_values",
        "Verdict._repr_html_": "equilibrium.pictures.notebook:verdict_html",
        "Verdict._repr_svg_": "equilibrium.pictures.notebook:verdict_svg",
    }
)

__getattr__, __dir__ = lazy_names(__name__, __file__, _SYNONYMS)
