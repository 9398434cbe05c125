"""The form of certificates: a question, then a motion and forces, or a tree; read node by node.

``{"schema_version": 4, "certificate": "resisted", "grasp": ..., "wrench": [x, y, r],
"motion": [x, y, r], "forces": [[c_n, c_t], ...]}``, or ``"not resisted"`` with ``"tree": node``.
Numbers are integers or texts such as "7/3"; contacts and generators are counted from 0. Nodes cut
the space of motions or distinguish the states of one contact, and leaves have a virtual motion:

* ``[x, y, r]``, or ``{"virtual_motion": [x, y, r], "multipliers": {"4": [alpha],
  "7": [alpha, h]}}``: a leaf. The keys of multipliers are contacts; h is 0 if omitted.
* ``{"orthants": [8 nodes]}`` cuts the half space ``d_0 >= 0`` of homogeneous motions (d_0, d) into
  the cones of e_0, +-e_1, +-e_2, +-e_3; signs in the order +++, ++-, +-+, ..., ---.
* ``{"edge": [j, k], "at": [p, q], "children": [2 nodes]}`` cuts a cone of four generators at
  ``v = p g_j + q g_k``, divided by the gcd of its entries: v replaces g_j in the first child, g_k
  in the second. Without "at", p = q = 1.
* ``{"contact": i, "attachment": {"detached": node, "attached": node}}``, and below "attached"
  ``{"contact": i, "slip": {"stick": node, "slip+": node, "slip-": node}}``.

Of a grasp in space motions have six numbers, and forces three: normal, and along both tangents.
A tree has states alone, so h has two numbers, and instead of "slip" there is
``{"contact": i, "directions": [[p, q], ...], "children": [nodes]}``, below "attached": directions
of slip along the tangents, counter-clockwise and each less than half a turn from the next; the
children are stick, and the sectors between neighbours, from the last to the first at the end.
Below such a sector it has one direction, which cuts the sector in two. With ``"pyramid": K`` in the
certificate the cones of friction are pyramids (`equilibrium.model.contact`), and the split is
``{"contact": i, "faces": [nodes]}``: stick, then by turns slip along the normal of an edge of the
polygon, from the first, and slip between two such normals. Where contacts and load lie in one plane
the tree may be ``{"plane": [u, v], "tree": node}`` with two axes of the plane, orthonormal, and a
planar tree in coordinates along these. An equilibrium that has no
rational numbers is shown by an "enclosure", see `equilibrium.certificate.enclosure`.

Of an assembly, which stands in place of the grasp, motions and wrenches are objects by the names of
bodies, with three numbers each. Forces, splits of states and multipliers are those of the plane; a
leaf has virtual motions for some bodies, and may leave multipliers out. Instead of all this the
tree may be ``{"part": names, "contacts": [i, ...], "tree": node}`` with a planar tree, see
`equilibrium.certificate.assemblies`.

With "bounds" in the certificate it is about all grasps within them, and in another form, that of
`equilibrium.certificate.robust`.

With "max_displacement" in the certificate only equilibria count that move each contact point by at
most that along its normal and its tangents. Then a leaf ``{"virtual_motion": ..., "multipliers":
..., "displacements": {"4": [u, v]}}`` may use it: numbers of any sign for the normal and the
tangents of a contact, three in space; see `equilibrium.certificate.law.displacement_work`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, rational, rational_vector, shown
from equilibrium.model.assembly import SIZE, Assembly
from equilibrium.model.contact import WRENCH_SIZES, pyramid_edges
from equilibrium.model.displacement import read_displacement
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Enclosure, Leaf
from equilibrium.model.subject import LoadCase, Subject

from .robust import check_form

SCHEMA_VERSION = 4
#: What is read, and what to do where a tree fails.
VERSIONS = {
    3: "; version 3 left more multipliers out, so make a new certificate with `equilibrium solve`",
    SCHEMA_VERSION: "",
}
#: Contacts as keys: numbers without leading zeros.
_INDEX = re.compile("0|[1-9][0-9]{0,8}")
#: What the proof of a verdict on one question has.
KEYS = {"resisted": ("motion", "forces"), "not resisted": ("tree",)}
#: Of older certificates.
_OLD_BOUNDS = ("largest_turn", "largest_force")
_ENCLOSURE = ("basis", "friction", "pillars", "centre", "radius", "inverse")
#: The states that a split of a contact distinguishes, by the key of the split.
STATES = {"attachment": ("detached", "attached"), "slip": ("stick", "slip+", "slip-")}


class TreeForm(NamedTuple):
    """What a tree is about, as far as its form goes.

    Attributes:
        size: how many numbers a motion has.
        tangents: of each contact.
        splits: the keys of inner nodes.
        bodies: those whose motions are objects by names, three numbers each; None for one body.
        read: what takes a number of motions, forces or multipliers and its name to an exact one.
    """

    size: int
    tangents: int
    splits: tuple[str, ...]
    bodies: tuple[str, ...] | None = None
    read: Callable[[Any, str], Any] = rational


#: Of grasps, by their dimension.
FORMS = {
    2: TreeForm(WRENCH_SIZES[2], 1, ("orthants", "edge", *STATES)),
    3: TreeForm(WRENCH_SIZES[3], 2, ("attachment", "directions", "faces")),
}


class Split(NamedTuple):
    """An inner node.

    Attributes:
        kind: "orthants", "edge", "attachment", "slip", "directions" or "faces".
        at: of an edge j, k, p, q; of a contact its number.
        children: with their paths.
        directions: of slip, of the last kind.
    """

    kind: str
    at: tuple[int, ...]
    children: list[tuple[str, Any]]
    directions: tuple[RationalVector, ...] = ()


class Place(NamedTuple):
    """Where a node stands: its region, and the states of the contacts decided there.

    Attributes:
        region: generators; none where a tree has states alone.
    """

    path: str
    depth: int
    region: Sequence[Any]
    states: Mapping[int, Any]


class Plane(NamedTuple):
    """Two axes of a plane in space, and a planar tree."""

    axes: tuple[RationalVector, RationalVector]
    tree: Any


def check_version(document: Any) -> str:
    """Return the kind of a certificate of a version that is read here.

    Raises:
        CertificateError: it is something else.
    """
    if not isinstance(document, Mapping):
        raise CertificateError(f"the certificate is {shown(document)}; expected an object")
    kind, version = document.get("certificate"), document.get("schema_version")
    if kind in ("stable", "unstable"):
        raise CertificateError(
            f'this is an old certificate ("{kind}", by a list of regions); make a new one with '
            "`equilibrium solve GRASP --wrench FX FY TAU --certificate OUT.json`"
        )
    if type(version) is not int or version not in VERSIONS:
        due = " and ".join(map(str, VERSIONS))
        raise CertificateError(f"schema_version is {shown(version)}; {due} are read here")
    if not isinstance(kind, str) or kind not in KEYS:
        raise CertificateError(f"certificate is {shown(kind)}; expected one of {', '.join(KEYS)}")
    return kind


def parameter_of(document: Any) -> str:
    """Return the letter of a certificate for all values of a parameter; nothing for another one."""
    entry = document.get("parameter") if isinstance(document, Mapping) else None
    letter = entry.get("letter") if isinstance(entry, Mapping) else None
    return letter if isinstance(letter, str) else ""


def form_of(subject: Subject) -> TreeForm:
    """Return the form of trees about a grasp or an assembly."""
    if isinstance(subject, Assembly):
        return TreeForm(SIZE * len(subject.bodies), 1, tuple(STATES), subject.names)
    return FORMS[subject.dimension]


def read_case(document: Any) -> tuple[str, LoadCase]:
    """Return the kind of a certificate, and what it is about; its proof is not looked at.

    Raises:
        InputError: an old certificate, unknown keys, wrong types, a grasp out of range.
    """
    kind = check_version(document)
    read = _assembly_and_load if "assembly" in document else _grasp_and_wrench
    subject, load = read(document, kind)
    bound = None
    if "max_displacement" in document:
        bound = read_displacement(rational(document["max_displacement"], "max_displacement"))
    return kind, LoadCase(subject, load, bound, document.get("pyramid"))


def _assembly_and_load(document: Mapping[str, Any], kind: str) -> tuple[Assembly, RationalVector]:
    common = ("schema_version", "certificate", "assembly", "wrench")
    if "bounds" in document:
        check_form(document, kind, common)
    else:
        check_keys(document, (*common, *KEYS[kind]), ("max_displacement",), "the certificate")
    assembly = Assembly.from_dict(document["assembly"])
    if "wrench" in document["assembly"] or any(body.outline for body in assembly.bodies):
        raise CertificateError("the assembly of a certificate has no wrench and no outlines")
    return assembly, read_motion(document["wrench"], form_of(assembly), "wrench")


def _grasp_and_wrench(document: Mapping[str, Any], kind: str) -> tuple[Grasp, RationalVector]:
    if old := next((key for key in _OLD_BOUNDS if key in document), ""):
        raise CertificateError(
            f"the certificate has {old}; expected max_displacement. Make a new one with "
            "`equilibrium solve` and --max-displacement"
        )
    common = ("schema_version", "certificate", "grasp", "wrench")
    shown_by = ("enclosure",) if "enclosure" in document else KEYS[kind]
    if "bounds" in document:
        check_form(document, kind, common)
    else:
        rest = ("pyramid", "max_displacement")
        check_keys(document, (*common, *shown_by), rest, "the certificate")
    if isinstance(document["grasp"], Mapping) and "outline" in document["grasp"]:
        raise CertificateError("the grasp of a certificate has no outline; leave it out")
    grasp = Grasp.from_dict(document["grasp"])
    wrench = grasp.read_wrench(check_list(document["wrench"], "wrench"))
    if "enclosure" in document and (kind, grasp.dimension) != ("resisted", 3):
        raise CertificateError("an enclosure shows that a grasp in space resists")
    if "pyramid" in document and ("enclosure" in document or grasp.dimension != 3):
        raise CertificateError("a pyramid is for a grasp in space, and needs no enclosure")
    if "pyramid" in document:
        pyramid_edges(document["pyramid"])
    return grasp, wrench


def read_equilibrium(
    document: Mapping[str, Any], contacts: int, form: TreeForm
) -> tuple[RationalVector, list[RationalVector]]:
    """Return the motion, and the normal and tangential forces of each contact."""
    rows = check_list(document["forces"], "forces", contacts)
    forces = [
        _rationals(row, form.tangents + 1, f"forces[{i}]", form.read) for i, row in enumerate(rows)
    ]
    return read_motion(document["motion"], form, "motion"), forces


def read_motion(
    content: Any, form: TreeForm, where: str, *, some_bodies: bool = False
) -> RationalVector:
    """Return a motion, or a wrench, in R^n.

    Args:
        some_bodies: bodies may be left out, which do not move.
    """
    if form.bodies is None:
        return _rationals(content, form.size, where, form.read)
    due, rest = ((), form.bodies) if some_bodies else (form.bodies, ())
    entries = check_keys(content, due, rest, where)
    size = form.size // max(1, len(form.bodies))
    rows = (
        _rationals(entries[name], size, f"{where}.{name}", form.read)
        if name in entries
        else (Fraction(0),) * size
        for name in form.bodies
    )
    return tuple(x for row in rows for x in row)


def read_enclosure(content: Any, contacts: int, form: TreeForm) -> Enclosure:
    """Return an enclosure; whether it shows anything is not looked at."""
    check_keys(content, _ENCLOSURE, ("idle",), "enclosure")
    n = form.size
    centre, radius = (_rationals(content[key], n, f"enclosure.{key}") for key in _ENCLOSURE[3:5])
    inverse = _rows(content, "inverse", n, n)
    basis = _rows(content, "basis", None, n)
    pillars = []
    for i, pair in enumerate(check_list(content["pillars"], "enclosure.pillars", n - len(basis))):
        where = f"enclosure.pillars[{i}]"
        contact, tangent = check_list(pair, where, 2)
        place = read_index(contact, where, contacts), read_index(tangent, where, form.tangents)
        pillars.append(place)
    friction: list[RationalVector | None] = []
    for i, entry in enumerate(check_list(content["friction"], "enclosure.friction", contacts)):
        if entry in ("detached", "slip"):
            friction.append(None if entry == "detached" else ())
        else:
            friction.append(_rationals(entry, form.tangents, f"enclosure.friction[{i}]"))
    idle = _rows(content, "idle", None, n + 1) if "idle" in content else ()
    return Enclosure(basis, tuple(friction), tuple(pillars), centre, radius, inverse, idle)


def _rows(
    content: Mapping[str, Any], key: str, count: int | None, size: int
) -> tuple[RationalVector, ...]:
    rows = check_list(content[key], f"enclosure.{key}", count)
    return tuple(_rationals(row, size, f"enclosure.{key}[{i}]") for i, row in enumerate(rows))


def read_plane(tree: Any) -> Plane | None:
    """Return axes and planar tree of a tree in space that has them; else None."""
    if not isinstance(tree, Mapping) or "plane" not in tree:
        return None
    check_keys(tree, ("plane", "tree"), (), "tree")
    rows = check_list(tree["plane"], "tree.plane", 2)
    u, v = (_rationals(row, 3, f"tree.plane[{i}]") for i, row in enumerate(rows))
    return Plane((u, v), tree["tree"])


def read_node(content: Any, path: str, contacts: int, form: TreeForm) -> Leaf | Split:
    """Return a node of a tree; what its children are is not looked at.

    Inside one process a leaf may come as it is, in numbers; files have texts.

    Raises:
        InputError: this is not a node for this many contacts; the message has the path.
    """
    if isinstance(content, Leaf):
        return content
    if isinstance(content, (list, tuple)) and form.bodies is None:
        return Leaf(_rationals(content, form.size, path, form.read), {})
    kinds = ("virtual_motion", *form.splits)
    kind = next((key for key in kinds if isinstance(content, Mapping) and key in content), "")
    if not kind:
        short = "" if form.bodies else f"a list of {form.size} numbers or "
        raise CertificateError(
            f"{path} is {shown(content)}; expected {short}an object with one of the keys "
            f"{', '.join(kinds)}"
        )
    if kind == "virtual_motion":
        return _long_leaf(content, path, contacts, form)
    if kind == "orthants":
        check_keys(content, (kind,), (), path)
        return Split(kind, (), _children(content, kind, path, 8))
    if kind == "edge":
        check_keys(content, (kind, "children"), ("at",), path)
        ends = check_list(content[kind], f"{path}.edge", 2)
        j, k = (read_index(end, f"{path}.edge", 4) for end in ends)
        p, q = _rationals(content.get("at", (1, 1)), 2, f"{path}.at")
        if j == k or min(p, q) <= 0 or p.denominator * q.denominator != 1:
            raise CertificateError(f"{path}: an edge has two generators, at has integers above 0")
        at = (j, k, p.numerator, q.numerator)
        return Split(kind, at, _children(content, "children", path, 2))
    check_keys(content, ("contact", kind, *("children",) * (kind == "directions")), (), path)
    contact = (read_index(content["contact"], f"{path}.contact", contacts),)
    if kind == "faces":
        return Split(kind, contact, _children(content, kind, path, None))
    if kind == "directions":
        where = f"{path}.{kind}"
        rows = enumerate(check_list(content[kind], where))
        directions = tuple(_rationals(row, 2, f"{where}[{i}]") for i, row in rows)
        count = max(2, len(directions) + 1)
        return Split(kind, contact, _children(content, "children", path, count), directions)
    check_keys(content[kind], STATES[kind], (), f"{path}.{kind}")
    children = [(f"{path}.{kind}.{state}", content[kind][state]) for state in STATES[kind]]
    return Split(kind, contact, children)


def _long_leaf(content: Mapping[str, Any], path: str, contacts: int, form: TreeForm) -> Leaf:
    numbers = form.tangents + 1
    if form.bodies is None:
        check_keys(content, ("virtual_motion", "multipliers"), ("displacements",), path)
    else:
        check_keys(content, ("virtual_motion",), ("multipliers", "displacements"), path)
    where = f"{path}.virtual_motion"
    motion = read_motion(content["virtual_motion"], form, where, some_bodies=True)
    where = f"{path}.multipliers"
    multipliers = {}
    for i, row in _by_contacts(content.get("multipliers", {}), where, contacts).items():
        is_alpha = form.bodies is None and isinstance(row, (list, tuple)) and len(row) == 1
        numbers_read = _rationals(row, 1 if is_alpha else numbers, f"{where}.{i}", form.read)
        multipliers[i] = (*numbers_read, *[Fraction(0)] * (numbers - len(numbers_read)))
    where = f"{path}.displacements"
    given_bounds = _by_contacts(content.get("displacements", {}), where, contacts)
    displacements = {i: _rationals(row, numbers, f"{where}.{i}") for i, row in given_bounds.items()}
    return Leaf(motion, multipliers, displacements)


def _by_contacts(rows: Any, where: str, contacts: int) -> dict[int, Any]:
    """Return an object whose keys are contacts."""
    if not isinstance(rows, Mapping):
        raise CertificateError(f"{where} is {shown(rows)}; expected an object by contacts")
    places = {}
    for key, row in rows.items():
        place = int(key) if isinstance(key, str) and _INDEX.fullmatch(key) else contacts
        if place >= contacts:
            raise CertificateError(
                f"{where}: {shown(key)} is not a contact from 0 to {contacts - 1}"
            )
        places[place] = row
    return places


def _rationals(
    value: Any, length: int, where: str, read: Callable[[Any, str], Any] = rational
) -> RationalVector:
    return rational_vector(check_list(value, where, length), where, read)


def _children(
    content: Mapping[str, Any], key: str, path: str, count: int | None
) -> list[tuple[str, Any]]:
    children = check_list(content[key], f"{path}.{key}", count)
    return [(f"{path}.{key}[{i}]", child) for i, child in enumerate(children)]


def read_index(value: Any, where: str, below: int) -> int:
    """Return a number from 0 on that is below a bound."""
    if type(value) is not int or not 0 <= value < below:
        raise CertificateError(f"{where} is {shown(value)}; there are 0 to {below - 1}")
    return value
