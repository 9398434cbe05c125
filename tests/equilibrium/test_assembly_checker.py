"""The checker of assemblies against the law and the rule of leaves, computed from displacements."""

from collections import Counter
from fractions import Fraction
from itertools import product
from random import Random

import pytest

from equilibrium import Assembly, BodyContact, Circle, Contact, Grasp, RigidBody, solve, verify

F = Fraction
NAMES = ("a", "b", "c")
STATES = ("undecided", "detached", "attached", "stick", "slip+", "slip-")
NORMALS = [(1, 0), (0, 1), (0, -1), (F(3, 5), F(4, 5)), (F(-5, 13), F(12, 13))]
ZERO = (F(0),) * 3


def moved(contact, motions):
    """Return how far body_a moves relative to body_b along the normal, and along the tangent."""
    (x, y), (nx, ny) = contact.contact.point, contact.contact.normal
    found = [F(0), F(0)]
    for name, sign in ((contact.body_a, 1), (contact.body_b, -1)):
        u, v, turn = motions.get(name, ZERO)
        along = (u - turn * y, v + turn * x)
        found[0] += sign * (nx * along[0] + ny * along[1])
        found[1] += sign * (nx * along[1] - ny * along[0])
    return found


def texts(rows):
    return {name: [str(x) for x in row] for name, row in rows.items()}


def document(kind, assembly, wrenches, **proof):
    about = {"assembly": assembly.to_dict(), "wrench": texts(wrenches)}
    return {"schema_version": 4, "certificate": kind, **about, **proof}


#: On a body that nothing touches; it holds wherever it stands.
FREE = {"virtual_motion": {"free": ["1", "0", "0"]}}


def placed(leaf, states):
    """Return a tree with a leaf where contacts have these states, and one that holds elsewhere."""
    tree = leaf
    for i, state in reversed(states.items()):
        if state in ("stick", "slip+", "slip-"):
            tree = {"contact": i, "slip": {**dict.fromkeys(STATES[3:], FREE), state: tree}}
            state = "attached"
        if state != "undecided":
            parts = {**dict.fromkeys(STATES[1:3], FREE), state: tree}
            tree = {"contact": i, "attachment": parts}
    return tree


def number(source):
    return F(source.randint(-3, 3), source.choice((1, 1, 2)))


def random_pair(source):
    """Return an assembly with two contacts at one place, of the same two bodies or two others."""
    point, normal = [source.randint(-2, 2) for _ in range(2)], source.choice(NORMALS)
    pairs = [("a", "b"), ("b", "a"), ("c", "b"), ("b", None), ("a", None)]
    first = second = source.choice(pairs)
    if source.random() < 0.2:
        second = source.choice(pairs)
    contacts = []
    for pair in (first, second):
        values = source.choice((0, F(1, 2), 2)), source.choice((1, 2, F(1, 3)))
        preload = source.choice((0, 1, F(2, 3)))
        contacts.append(BodyContact(*pair, Contact(point, normal, *values, preload)))
    return Assembly(NAMES, contacts)


def leaf_is_right(assembly, wrenches, virtual, multipliers, states):
    """Return whether each condition on a leaf holds: on alpha, kappa and h, on the sum, on work."""
    right = [True] * 3
    for i, contact in enumerate(assembly.contacts):
        (alpha, h), state = multipliers[i], states[i]
        a, b = moved(contact, virtual)
        signs = {"slip+": (1,), "slip-": (-1,)}.get(state, (1, -1))
        kappa = min(a - contact.contact.friction * sign * b for sign in signs)
        right[0] &= alpha >= 0 or state not in ("undecided", "detached")
        right[1] &= alpha <= kappa or state == "detached"
        slips = {"slip+": (1,), "slip-": (-1,), "stick": ()}.get(state, (1, -1))
        right[2] &= all(h * slip <= 0 for slip in slips)

    def bound(motions):
        total = F(0)
        for contact, (alpha, h) in zip(assembly.contacts, multipliers, strict=True):
            along, slip = moved(contact, motions)
            total += alpha * (contact.contact.preload - contact.contact.stiffness * along)
            total += h * slip
        return total

    still = bound({})
    units = [tuple(F(int(j == k)) for j in range(3)) for k in range(3)]
    right.append(all(bound({name: unit}) == still for name, unit in product(NAMES, units)))
    load = sum(x * y for n in NAMES for x, y in zip(wrenches[n], virtual[n], strict=True))
    return [*right, load + still > 0]


def test_leaf_holds_exactly_where_the_definition_says_so():
    source, found = Random("assembly leaves"), Counter()
    words = ("alpha must", "alpha is larger", "h ", "sum of", "work of")
    for _ in range(500):
        assembly = random_pair(source)
        virtual = {name: tuple(number(source) for _ in range(3)) for name in NAMES}
        states = {i: source.choice(STATES) for i in range(2)}
        one, other = (c.contact for c in assembly.contacts)
        a, b = moved(assembly.contacts[0], virtual)
        edge = a - one.friction * source.choice((b, -b, abs(b)))
        alpha, h = source.choice((F(0), edge, edge, edge + 1, number(source))), F(0)
        if source.random() < 0.5:
            h = number(source)
        back = (-alpha * one.stiffness / other.stiffness, -h)
        if source.random() < 0.3:
            back = (back[0] + source.choice((0, 1)), back[1] + source.choice((0, 1)))
        multipliers = [(alpha, h), back]
        least = alpha * one.preload + back[0] * other.preload
        size = sum(x * x for row in virtual.values() for x in row) or F(1)
        share = (source.choice((F(1), F(1), F(0), F(-1, 9))) - least) / size
        wrenches = {n: tuple(share * x for x in row) for n, row in virtual.items()}
        right = leaf_is_right(assembly, wrenches, virtual, multipliers, states)
        given = {str(i): [str(x) for x in row] for i, row in enumerate(multipliers) if any(row)}
        leaf = {"virtual_motion": texts({n: r for n, r in virtual.items() if any(r)})}
        leaf |= {"multipliers": given} if given else {}
        asked = (
            Assembly((*NAMES, "free"), assembly.contacts),
            {**wrenches, "free": (F(1), F(0), F(0))},
        )
        problem = verify(document("not resisted", *asked, tree=placed(leaf, states))).problem
        assert bool(problem) == (not all(right)), (problem, right)
        if sum(right) == 4:
            assert words[right.index(False)] in problem
        if sum(right) >= 4:
            found[right.index(False) if problem else -1] += 1
    assert min(found[k] for k in range(-1, 5)) > 3, found


def test_contact_without_multipliers_does_nothing_but_with_a_constant_force():
    """Between two bodies; the factor is 1, or with friction 2 it is -1, and 3 in slip+."""
    found = Counter()
    for stiffness, friction, state in product((0, 1), (0, 2), STATES):
        contact = Contact((0, 0), (0, 1), friction, stiffness, 3)
        assembly = Assembly((*NAMES, "free"), [BodyContact("a", "b", contact)])
        leaf = {"virtual_motion": texts({"a": (1, 1, 0)})}
        kappa = {"slip+": 3}.get(state, -1) if friction else 1
        due = 3 * kappa if not stiffness else 0 if kappa > 0 else None
        due = 0 if state == "detached" else due
        for load in (-10, -9, -4, -3, -1, 0, 1, 2, 3, 4):
            wrenches = {**dict.fromkeys(NAMES, ZERO), "free": (F(1), F(0), F(0))}
            wrenches["a"] = (F(0), F(load), F(0))
            proof = document("not resisted", assembly, wrenches, tree=placed(leaf, {0: state}))
            holds = due is not None and load + due > 0
            assert bool(verify(proof)) == holds, (stiffness, friction, state, load)
            found[due, holds] += 1
            if stiffness:
                # As with multipliers 0.
                zero = {**leaf, "multipliers": {"0": ["0", "0"]}}
                proof = document("not resisted", assembly, wrenches, tree=placed(zero, {0: state}))
                assert bool(verify(proof)) == holds
    assert min(found.values()) > 1


def test_equilibrium_holds_exactly_where_the_law_does():
    source, found = Random("assembly laws"), Counter()
    words = ("its spring gives", "of at most", "while it slips by", "add up to")
    for _ in range(400):
        assembly = Assembly(NAMES, random_pair(source).contacts[:1])
        (contact,) = assembly.contacts
        motions = {name: tuple(number(source) for _ in range(3)) for name in NAMES}
        if source.random() < 0.3:
            motions = dict.fromkeys(NAMES, ZERO)
        along, slip = moved(contact, motions)
        c = contact.contact
        spring = max(F(0), c.preload - c.stiffness * along)
        normal = spring + source.choice((0, 0, 0, F(1, 9)))
        limit = c.friction * normal
        friction = source.choice((-1, 1, -1, 1, 0, F(1, 2), F(11, 10))) * limit
        due = -limit if slip > 0 else limit
        right = [normal == spring, abs(friction) <= limit, not slip or friction == due]
        (x, y), (nx, ny) = c.point, c.normal
        force = (normal * nx - friction * ny, normal * ny + friction * nx)
        wrench = (*force, x * force[1] - y * force[0])
        off = source.choice((0, 0, 0, 1))
        loads = dict.fromkeys(NAMES, ZERO)
        loads[contact.body_a] = tuple(-z for z in wrench)
        if contact.body_b is not None:
            loads[contact.body_b] = wrench
        name = source.choice(NAMES)
        loads[name] = (loads[name][0], loads[name][1] + off, loads[name][2])
        right.append(not off)
        proof = {"motion": texts(motions), "forces": [[str(normal), str(friction)]]}
        report = verify(document("resisted", assembly, loads, **proof))
        assert bool(report) == all(right), (report.problem, right)
        if not all(right):
            assert words[right.index(False)] in report.problem
        found[right.index(False) if not all(right) else -1] += 1
    assert min(found[k] for k in range(-1, 4)) > 5, found


PUSHED = Assembly(
    ("a", "b"),
    [
        BodyContact("a", None, Contact((0, 0), (0, 1), F(1, 2))),
        BodyContact("a", "b", Contact((0, 1), (0, -1), F(1, 2))),
        BodyContact("b", "a", Contact((1, 1), (0, 1), F(1, 2))),
    ],
)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({}, ""),
        ({"contacts": [2, 1]}, ""),
        ({"contacts": [1]}, "contacts of the part"),
        ({"contacts": [1, 2, 2]}, "contacts of the part"),
        ({"contacts": [0, 1, 2]}, "contacts of the part"),
        ({"part": ["b", "b"]}, "contacts of the part"),
        ({"part": ["a"]}, "contacts of the part"),
        ({"part": ["a"], "contacts": [0, 1, 2]}, "more than one pair"),
        ({"part": ["a", "b"], "contacts": [0]}, ""),
        ({"part": [], "contacts": []}, "work of load"),
        ({"tree": ["1", "0", "0"]}, "tree.tree: at generator"),
    ],
)
def test_part_is_refuted_by_contacts_with_the_rest(change, words):
    """Lifted off: the load of a part pulls against contacts that only press."""
    loads = {"a": (F(0), F(0), F(0)), "b": (F(0), F(1), F(1, 2))}
    tree = {"part": ["b"], "contacts": [1, 2], "tree": ["0", "1", "0"], **change}
    report = verify(document("not resisted", PUSHED, loads, tree=tree))
    assert words in report.problem if words else not report.problem


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"part": ["d"]}, "names of bodies"),
        ({"part": [1]}, "names of bodies"),
        ({"part": [["b"]]}, "names of bodies"),
        ({"contacts": [3]}, "there are 0 to 2"),
        ({"contacts": [-1]}, "there are 0 to 2"),
        ({"more": 1}, "more"),
    ],
)
def test_part_of_another_form_is_refused(change, words):
    loads = {"a": ZERO, "b": (F(0), F(1), F(0))}
    tree = {"part": ["b"], "contacts": [1, 2], "tree": ["0", "1", "0"], **change}
    with pytest.raises(ValueError, match=words):
        verify(document("not resisted", PUSHED, loads, tree=tree))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"wrench": {"a": ["0"] * 3}}, "wrench"),
        ({"wrench": {"a": ["0"] * 3, "b": ["0"] * 3, "c": ["0"] * 3}}, "wrench"),
        ({"wrench": {"a": ["0"] * 3, "b": ["0"] * 2}}, "wrench.b"),
        ({"tree": ["0", "1", "0"]}, "virtual_motion, attachment, slip"),
        ({"tree": ["part"]}, "virtual_motion, attachment, slip"),
        ({"tree": 5}, "virtual_motion, attachment, slip"),
        ({"tree": {"virtual_motion": {"c": ["0"] * 3}}}, "virtual_motion"),
        ({"tree": {"virtual_motion": {}, "multipliers": {"0": ["1"]}}}, "multipliers.0"),
        ({"tree": {"virtual_motion": {}, "displacements": {"0": ["1"]}}}, "displacements.0"),
        ({"tree": {"orthants": []}}, "virtual_motion, attachment, slip"),
        ({"schema_version": 2}, "schema_version is 2"),
        ({"certificate": "unstable"}, "old certificate"),
        ({"max_displacement": "-1"}, "max_displacement"),
    ],
)
def test_certificate_of_another_form_is_refused(change, words):
    tree = {"virtual_motion": {"a": ["0", "1", "0"], "b": ["0", "1", "0"]}}
    loads = {"a": (F(0), F(1), F(0)), "b": ZERO}
    proof = document("not resisted", PUSHED, loads, tree=tree)
    assert verify(proof)
    with pytest.raises(ValueError, match=words):
        verify({**proof, **change})
    outlined = [RigidBody("a", Circle((0, 0), 1)).to_dict(), "b"]
    for key, value in (("wrench", {}), ("bodies", outlined)):
        with pytest.raises(ValueError, match="no wrench and no outlines"):
            verify({**proof, "assembly": {**proof["assembly"], key: value}})


def test_report_says_what_a_certificate_is_about():
    tree = {"virtual_motion": {"a": ["0", "1", "0"], "b": ["0", "1", "0"]}}
    loads = {"a": (F(0), F(1), F(0)), "b": ZERO}
    proof = document("not resisted", PUSHED, loads, tree=tree)
    report = verify(proof)
    heads = [line.split(":")[0][:19] for line in report.question]
    assert heads[:2] == ["wrench on a (0, 1, ", "wrench on b (0, 0, "]
    assert [head[:14] for head in heads[2:]] == [
        "contact 1 a on",
        "contact 2 a on",
        "contact 3 b on",
    ]
    found = report.to_dict()
    assert found.pop("assembly") == PUSHED.to_dict()
    assert found == {
        "valid": True,
        "certificate": "not resisted",
        "leaves": 1,
        "compared": False,
        "wrench": texts(loads),
    }
    assert verify({**proof, "wrench": texts(dict.fromkeys("ab", ZERO))}).to_dict()["problem"]
    assert verify(proof, (PUSHED, loads)).compared


def test_certificate_of_a_grasp_is_not_about_an_assembly():
    proof = solve(Grasp([Contact((0, 0), (0, 1), 1)]), (0, 1, 0)).proof
    report = verify(proof, (PUSHED, dict.fromkeys("ab", ZERO)))
    assert report.problem == "it is about one body, not about an assembly"


def test_assembly_of_no_body_has_no_virtual_motion():
    nothing = {"bodies": [], "contacts": []}
    document = {"schema_version": 4, "certificate": "not resisted", "assembly": nothing}
    found = verify({**document, "wrench": {}, "tree": {"virtual_motion": {}}})
    assert not found
    assert "not above 0" in found.problem


@pytest.mark.parametrize(("load", "kind"), [((0, -1, 0), "resisted"), ((2, -1, 0), "not resisted")])
def test_assembly_may_be_one_body(load, kind):
    ground = {"body_a": "box", "body_b": None, "point": [0, 0], "normal": [0, 1], "friction": "1/2"}
    verdict = solve(
        Assembly.from_dict({"bodies": ["box"], "contacts": [ground]}),
        {"box": load},
        max_displacement=10,
    )
    assert verdict.verdict == kind
    assert verdict.verify()


def test_wrenches_are_compared_as_solve_reads_them():
    feet = [BodyContact("b", None, Contact([x, 0], [0, 1], "1/2")) for x in (-1, 1)]
    assembly, wrenches = Assembly(["b"], feet), {"b": ["0", -1, "0"]}
    certificate = solve(assembly, wrenches).certificate
    assert verify(certificate, (assembly, wrenches))
    assert not verify(certificate, (assembly, {"b": [0, -2, 0]}))
    assert not verify(certificate, (assembly, {}))
    assert not verify(certificate, (Grasp([]), (0, 0, 0)))
