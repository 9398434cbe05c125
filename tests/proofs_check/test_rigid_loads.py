"""The second implementations of closure, classes of loads and robustness, and their claims."""

from fractions import Fraction

from proofs_check import evaluate, registry
from proofs_check.routes.oracle import Question
from proofs_check.routes.rigid_loads import classes, immobile, within_bound


def question(wrench, *contacts):
    """Contacts (x, y, normal x, normal y, friction, preload) of stiffness 1 under a wrench."""
    rows = tuple((*map(Fraction, c[:5]), Fraction(1), Fraction(c[5])) for c in contacts)
    return Question(rows, tuple(map(Fraction, wrench)))


def test_claim_has_the_expected_verdict():
    """The other claims are in `tests.proofs_check.test_mutated_proofs`."""
    assert evaluate(registry()["algorithm-2-null-space"]).as_expected


def test_normals_of_a_corner_let_the_object_turn():
    corner = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)]
    assert not immobile(corner)
    assert immobile([*corner, (0, 0, 1), (0, 0, -1)])
    assert immobile([(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, -1, -1)])


def test_classes_of_loads_on_one_contact():
    """Inside the cone, along the normal, outside the cone, and away from the contact."""
    for wrench, found in (
        ((-2, 1, 0), (True, False)),
        ((-2, 0, 0), (True, True)),
        ((-1, 2, 0), (False, False)),
        ((1, 0, 0), (False, False)),
    ):
        assert classes(question(wrench, (0, 0, 1, 0, 1, 0))) == found


def test_the_bound_of_the_four_contacts_by_hand():
    four = [(-1, 1, 1, 0), (-1, -1, 1, 0), (1, -1, -1, 0), (1, 1, -1, 0)]
    touches = question((0, 0, 0), *((*c, "1/2", 1) for c in four)).touches
    assert within_bound(touches, ["stick"] * 4, Fraction(4, 5))
    assert not within_bound(touches, ["stick"] * 4, Fraction(4, 5) + Fraction(1, 10**9))
    assert not within_bound(touches, ["detached", *["stick"] * 3], Fraction(0))
    # Without any tangential spring a load along the contacts is not balanced.
    assert not within_bound(touches, ["slip"] * 4, Fraction(0))
