"""The checker of certificates about assemblies: no solver, no floats.

"resisted": a motion for each body and forces that obey the law, checked with the displacements of
bodies relative to each other. "not resisted": a tree of contact states. A leaf is a virtual motion
lambda for some bodies (0 for the others) and multipliers alpha, h of some contacts. With
``m = lambda_a - lambda_b``, ``a = m . N``, ``b = m . T`` the work of a contact on lambda is at
least ``alpha (q - k N . u) + h T . u`` for every relative motion u, if

* ``alpha >= 0`` where it is undecided or detached;
* ``alpha <= a - mu b`` in slip+, ``a + mu b`` in slip-, ``a - mu |b|`` else; none if detached;
* h = 0 but for ``h <= 0`` in slip+, ``h >= 0`` in slip-, any h in stick.

The leaf holds if what depends on motions cancels for each body, and the work of the load with all
``alpha q`` is above 0. At the root the tree may instead be one of a *part*: bodies S that touch the
rest at contacts of one body in S with one outside, or with the ground. Their balances add up to one
in which only these contacts are left, and the law of these depends on the motion of the one body
relative to the other alone: so a planar proof about them and the whole load of S will do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, rational_vector, shown, to_text, vector_text
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.contact import Contact
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp

from .checker import MAX_DEPTH, Report, check
from .law import frame, short
from .reading import SCHEMA_VERSION, STATES

_KEYS = {"resisted": ("motion", "forces"), "not resisted": ("tree",)}
#: The state that a split asks for, by its key.
_BEFORE = {"attachment": "undecided", "slip": "attached"}
_NONE = (Fraction(0),) * SIZE
Motions = Mapping[str, RationalVector]


@dataclass(frozen=True, repr=False)
class AssemblyReport(Report):
    """What a check of a certificate about an assembly found.

    Attributes:
        assembly, wrenches: the question that it is about.
    """

    assembly: Assembly = field(default_factory=lambda: Assembly([]))
    wrenches: Wrenches = field(default_factory=dict)

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        return "not compared with an assembly: give --grasp FILE, whose file has the wrenches"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the wrench on each body, and each contact."""
        lines = [f"wrench on {name} {vector_text(w)}" for name, w in self.wrenches.items()]
        for i, c in enumerate(self.assembly.contacts, 1):
            lines.append(f"contact {i} {c.pair} {c.contact.words}")
        return lines

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **({"problem": self.problem} if self.problem else {}),
            "wrench": {name: list(map(to_text, w)) for name, w in self.wrenches.items()},
            "assembly": self.assembly.to_dict(),
            "compared": self.compared,
        }


class Joint(NamedTuple):
    """A contact as the checker sees it: the bodies, N and T in the plane, and its values."""

    body_a: str
    body_b: str | None
    normal: RationalVector
    tangent: RationalVector
    contact: Contact


def check_assembly(
    document: Mapping[str, Any],
    question: tuple[Assembly, Wrenches] | None = None,
) -> AssemblyReport:
    """Check a certificate about an assembly.

    Args:
        question: that it has to be about.

    Raises:
        InputError: this is not a certificate, whatever its numbers are.
    """
    kind = _kind(document)
    assembly = Assembly.from_dict(document["assembly"])
    if "wrench" in document["assembly"] or any(body.outline for body in assembly.bodies):
        raise CertificateError("the assembly of a certificate has no wrench and no outlines")
    rows = check_keys(document["wrench"], assembly.names, (), "wrench")
    wrenches = {name: _three(rows[name], f"wrench.{name}") for name in assembly.names}
    joints, leaves = joints_of(assembly), 0
    if kind == "resisted":
        motions = check_keys(document["motion"], assembly.names, (), "motion")
        moved = {name: _three(motions[name], f"motion.{name}") for name in assembly.names}
        listed = enumerate(check_list(document["forces"], "forces", len(joints)))
        forces = [_numbers(row, 2, f"forces[{i}]") for i, row in listed]
        problem = law_problem(joints, wrenches, moved, forces)
    else:
        leaves, problem = _tree(document["tree"], joints, wrenches)
    compared = question is not None
    if question is not None and question != (assembly, wrenches):
        problem = "it is about another assembly or other wrenches"
    return AssemblyReport(
        kind, problem, leaves, compared=compared, assembly=assembly, wrenches=wrenches
    )


def joints_of(assembly: Assembly) -> list[Joint]:
    """Return the contacts as the checker sees them."""
    frames = ((c, frame(c.contact)) for c in assembly.contacts)
    return [Joint(c.body_a, c.body_b, n, t, c.contact) for c, (n, t) in frames]


def law_problem(
    joints: Sequence[Joint],
    wrenches: Wrenches,
    motions: Motions,
    forces: Sequence[RationalVector],
) -> str:
    """Return what is wrong with motions and forces (normal, tangential); empty if they obey."""
    total = {name: list(wrench) for name, wrench in wrenches.items()}
    for i, (joint, (pressed, rubbed)) in enumerate(zip(joints, forces, strict=True), 1):
        contact, moved = joint.contact, _relative(motions, joint)
        spring = contact.preload - contact.stiffness * _dot(joint.normal, moved)
        if pressed != max(Fraction(0), spring):
            due = short(max(Fraction(0), spring))
            return f"contact {i}: normal force {short(pressed)}, its spring gives {due}"
        limit, slip = contact.friction * pressed, _dot(joint.tangent, moved)
        if abs(rubbed) > limit:
            return f"contact {i}: friction {short(rubbed)} of at most {short(limit)}"
        if slip and rubbed != (-limit if slip > 0 else limit):
            given = f"contact {i}: friction {short(rubbed)} of at most {short(limit)}"
            return f"{given} while it slips by {short(slip)}"
        force = [pressed * n + rubbed * t for n, t in zip(joint.normal, joint.tangent, strict=True)]
        _add(total, joint, force)
    for name, rest in total.items():
        if any(rest):
            left = ", ".join(map(short, rest))
            return f"the forces on {name} add up to ({left}), not 0"
    return ""


def _tree(tree: Any, joints: Sequence[Joint], wrenches: Wrenches) -> tuple[int, str]:
    """Return the number of leaves, and the first inequality of one that fails, or nothing."""
    if isinstance(tree, Mapping) and "part" in tree:
        return _part(tree, joints, wrenches)
    leaves, problem = 0, ""
    waiting: list[tuple[Any, str, int, dict[int, str]]] = [(tree, "tree", 0, {})]
    while waiting:
        node, path, depth, states = waiting.pop()
        if isinstance(node, Mapping) and "virtual_motion" in node:
            leaves += 1
            moved, multipliers = _leaf(node, path, joints, wrenches)
            problem = problem or _leaf_problem(joints, wrenches, moved, multipliers, states, path)
            continue
        kind = next((key for key in STATES if isinstance(node, Mapping) and key in node), "")
        if not kind:
            raise CertificateError(
                f"{path} is {shown(node)}; expected an object with one of the keys virtual_motion, "
                f"{', '.join(STATES)}"
            )
        if depth == MAX_DEPTH:
            raise CertificateError(f"{path[:60]}...: more than {MAX_DEPTH} splits in a row")
        check_keys(node, ("contact", kind), (), path)
        i = _index(node["contact"], len(joints), f"{path}.contact")
        if states.get(i, "undecided") != _BEFORE[kind]:
            raise CertificateError(f"{path}: contact {i + 1} is not {_BEFORE[kind]} here")
        check_keys(node[kind], STATES[kind], (), f"{path}.{kind}")
        for name in reversed(STATES[kind]):
            below = {**states, i: name}
            waiting.append((node[kind][name], f"{path}.{kind}.{name}", depth + 1, below))
    return leaves, problem


def _leaf(
    node: Mapping[str, Any], path: str, joints: Sequence[Joint], wrenches: Wrenches
) -> tuple[dict[str, RationalVector], dict[int, RationalVector]]:
    """Read the virtual motions of a leaf, by bodies, and its multipliers, by contacts."""
    check_keys(node, ("virtual_motion",), ("multipliers",), path)
    where = f"{path}.virtual_motion"
    given = check_keys(node["virtual_motion"], (), wrenches, where)
    moved = {name: _three(row, f"{where}.{name}") for name, row in given.items()}
    where = f"{path}.multipliers"
    numbers = [str(i) for i in range(len(joints))]
    rows = check_keys(node.get("multipliers", {}), (), numbers, where)
    multipliers = {int(i): _numbers(row, 2, f"{where}.{i}") for i, row in rows.items()}
    return moved, multipliers


def _leaf_problem(
    joints: Sequence[Joint],
    wrenches: Wrenches,
    virtual: Motions,
    multipliers: Mapping[int, RationalVector],
    states: Mapping[int, str],
    path: str,
) -> str:
    """Return the inequality of a leaf that fails, or nothing."""
    work = sum((_dot(w, virtual.get(name, _NONE)) for name, w in wrenches.items()), Fraction(0))
    rest = {name: [Fraction(0)] * SIZE for name in wrenches}
    for i, joint in enumerate(joints):
        state, contact = states.get(i, "undecided"), joint.contact
        alpha, h = multipliers.get(i, (Fraction(0), Fraction(0)))
        moved = _relative(virtual, joint)
        along, across = _dot(joint.normal, moved), contact.friction * _dot(joint.tangent, moved)
        rub = across if state == "slip+" else -across if state == "slip-" else abs(across)
        if broken := _broken(state, alpha, h, along - rub):
            return f"{path}: contact {i + 1}, {state}: {broken}"
        work += alpha * contact.preload
        if alpha or h:
            factor = -alpha * contact.stiffness
            pairs = zip(joint.normal, joint.tangent, strict=True)
            _add(rest, joint, [factor * n + h * t for n, t in pairs])
    for name, row in rest.items():
        if any(row):
            return f"{path}: the sum of -alpha k N + h T on {name} is not 0"
    return "" if work > 0 else f"{path}: the work of load and contacts is not above 0"


def _broken(state: str, alpha: Fraction, h: Fraction, kappa: Fraction) -> str:
    """Return which bound of the multipliers of a contact is broken, or nothing."""
    if alpha < 0 and state in ("undecided", "detached"):
        return "alpha must be at least 0"
    if alpha > kappa and state != "detached":
        return f"alpha is {short(alpha)}, and must be at most {short(kappa)}"
    if (h > 0 and state not in ("stick", "slip-")) or (h < 0 and state not in ("stick", "slip+")):
        return "h has the wrong sign"
    return ""


def _part(tree: Mapping[str, Any], joints: Sequence[Joint], wrenches: Wrenches) -> tuple[int, str]:
    """Check a planar proof about the contacts of a part with the rest."""
    check_keys(tree, ("part", "contacts", "tree"), (), "tree")
    part = check_list(tree["part"], "tree.part")
    for name in part:
        if not isinstance(name, str) or name not in wrenches:
            raise CertificateError(f"tree.part has {shown(name)}; expected names of bodies")
    listed = check_list(tree["contacts"], "tree.contacts")
    places = [_index(i, len(joints), f"tree.contacts[{k}]") for k, i in enumerate(listed)]
    inside = set(part)
    crossing = [i for i, j in enumerate(joints) if (j.body_a in inside) != (j.body_b in inside)]
    if sorted(places) != crossing or len(part) != len(inside):
        due = ", ".join(map(str, crossing))
        return 0, f"tree.contacts: the contacts of the part with the rest are [{due}], each once"
    ends = {
        (j.body_a, j.body_b) if j.body_a in inside else (j.body_b, j.body_a)
        for j in (joints[i] for i in places)
    }
    if len(ends) > 1:
        return 0, "tree.part: it touches the rest at more than one pair of bodies"
    contacts = []
    for i in places:
        c, turned = joints[i].contact, joints[i].body_a not in inside
        normal = [-x for x in c.normal] if turned else c.normal
        contacts.append(Contact(c.point, normal, c.friction, c.stiffness, c.preload))
    load = [sum(column) for column in zip(_NONE, *(wrenches[name] for name in part), strict=True)]
    question = {
        "schema_version": SCHEMA_VERSION,
        "certificate": "not resisted",
        "grasp": Grasp(contacts).to_dict(),
        "wrench": [to_text(x) for x in load],
        "tree": tree["tree"],
    }
    report = check(question)
    return report.leaves, report.problem and f"tree.{report.problem}"


def _kind(document: Mapping[str, Any]) -> str:
    """Return the kind of a certificate about an assembly; refuse another form."""
    kind, version = document.get("certificate"), document.get("schema_version")
    if type(version) is not int or version != SCHEMA_VERSION:
        raise CertificateError(
            f"schema_version is {shown(version)}; expected {SCHEMA_VERSION}. Make a new certificate"
        )
    if not isinstance(kind, str) or kind not in _KEYS:
        raise CertificateError(f"certificate is {shown(kind)}; expected {' or '.join(_KEYS)}")
    common = ("schema_version", "certificate", "assembly", "wrench")
    check_keys(document, (*common, *_KEYS[kind]), (), "the certificate")
    return kind


def _relative(motions: Motions, joint: Joint) -> RationalVector:
    """Return the motion of body_a relative to body_b."""
    one = motions.get(joint.body_a, _NONE)
    other = _NONE if joint.body_b is None else motions.get(joint.body_b, _NONE)
    return tuple(x - y for x, y in zip(one, other, strict=True))


def _add(total: dict[str, list[Fraction]], joint: Joint, row: Sequence[Fraction]) -> None:
    """Add a row to body_a, and take it away from body_b."""
    for name, sign in ((joint.body_a, 1), (joint.body_b, -1)):
        if name is not None:
            total[name] = [x + sign * y for x, y in zip(total[name], row, strict=True)]


def _dot(left: Sequence[Fraction], right: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(left, right, strict=True)), Fraction(0))


def _three(row: Any, where: str) -> RationalVector:
    return _numbers(row, SIZE, where)


def _numbers(row: Any, count: int, where: str) -> RationalVector:
    return rational_vector(check_list(row, where, count), where)


def _index(value: Any, below: int, where: str) -> int:
    if type(value) is not int or not 0 <= value < below:
        raise CertificateError(f"{where} is {shown(value)}; expected 0 to {below - 1}")
    return value
