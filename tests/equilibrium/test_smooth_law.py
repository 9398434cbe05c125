"""The law in floats: its derivatives, many questions at once, what it tends to, and rationals."""

import math
from fractions import Fraction
from random import Random

import numpy as np
import pytest

from arrangement.numbers.exact import dot
from equilibrium.core.cones import Cones, LineCones, Pyramids, RoundCones
from equilibrium.core.contact_law import spring_force
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.float_law import Balance, norms, smooth_slip
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.rows import ContactRows

from .random_assemblies import random_question


def rows(kind: str, seed: int) -> ContactRows:
    if kind == "assembly":
        entry, _ = random_question(seed, 6)
        return Assembly.from_dict(entry).rows
    return ContactRows.of_grasp(random_grasp(5, seed, dimension=2 if kind == "plane" else 3))


KINDS = [
    ("plane", LineCones()),
    ("assembly", LineCones()),
    ("space", RoundCones()),
    ("space", Pyramids(pyramid_edges(8))),
]


def law_of(kind: str, cones: Cones, seed: int) -> tuple[Balance, FloatContacts, np.ndarray]:
    contacts, source = FloatContacts(rows(kind, seed)), np.random.default_rng(seed)
    load, motion = source.normal(size=(2, contacts.rows.n))
    weights = source.uniform(0.5, 2, size=contacts.rows.n)
    return Balance.of(contacts, load, cones.smooth, weights), contacts, motion


@pytest.mark.parametrize(("kind", "cones"), KINDS)
def test_derivative_of_the_balance_equals_differences(kind, cones):
    for seed in range(20):
        law, _, motion = law_of(kind, cones, seed)
        for eps in (1.0, 0.1):
            _, derivative = law.smoothed(motion, eps)
            steps = 1e-6 * np.eye(len(motion))
            ends = [
                law.smoothed(motion + s, eps)[0] - law.smoothed(motion - s, eps)[0] for s in steps
            ]
            assert pytest.approx(derivative(), rel=1e-5, abs=1e-5) == np.array(ends).T / 2e-6


@pytest.mark.parametrize(("kind", "cones"), [KINDS[0], KINDS[2]])
def test_many_questions_at_once_equal_each_alone(kind, cones):
    singles = [law_of(kind, cones, seed) for seed in range(12)]
    laws, motions = [law for law, _, _ in singles], np.array([motion for *_, motion in singles])
    widths = np.geomspace(1.0, 1e-6, len(laws))
    together = Balance(laws[0].smooth, *map(np.array, zip(*(law[1:] for law in laws), strict=True)))
    kept = np.arange(0, len(laws), 2)
    values, derivatives = together.take(kept).smoothed(motions[kept], widths[kept, None, None])
    for k, value, jacobian in zip(kept, values, derivatives(), strict=True):
        alone, derivative = laws[k].smoothed(motions[k], widths[k])
        assert value == pytest.approx(alone, rel=1e-12, abs=1e-12)
        assert jacobian == pytest.approx(derivative(), rel=1e-12, abs=1e-12 / widths[k])


@pytest.mark.parametrize(("kind", "cones"), KINDS)
def test_sharp_contacts_obey_the_law(kind, cones):
    """Springs do not pull, friction is at its limit and does most work against the slip."""
    for seed in range(20):
        law, c, motion = law_of(kind, cones, seed)
        pressed = np.maximum(0.0, c.preload - c.stiffness * (c.normal @ motion))
        slips = c.tangents @ motion
        work = -pressed * c.friction * cones.support(slips)
        force, share, _ = law.forces(motion, 1e-9)
        assert np.maximum(0.0, force[:, 0]) == pytest.approx(pressed)
        rubbed = (c.friction * pressed)[:, None] * share
        assert (rubbed * slips).sum(axis=1) == pytest.approx(work, abs=1e-6)
        friction = np.einsum("mt,mtn->n", rubbed, c.tangents)
        value, _ = law.smoothed(motion, 1e-9)
        unweighted = Balance.of(c, np.zeros(c.rows.n), cones.smooth).smoothed(motion, 1e-9)[0]
        assert unweighted == pytest.approx(pressed @ c.normal + friction, abs=1e-6)
        # Weights, and the load, are those of `law_of`.
        source = np.random.default_rng(seed)
        load, _ = source.normal(size=(2, c.rows.n))
        weights = source.uniform(0.5, 2, size=c.rows.n)
        assert value == pytest.approx(weights * (load + unweighted))


@pytest.mark.parametrize("kind", ["plane", "assembly", "space"])
def test_floats_and_rationals_have_one_law(kind):
    """Forces of springs, slips, wrenches and least works, of rational motions and in floats."""
    for seed in range(20):
        contacts, source = FloatContacts(rows(kind, seed)), Random(seed)
        exact = [Fraction(source.randint(-9, 9), 4) for _ in range(contacts.rows.n)]
        motion = np.array(exact, dtype=float)
        shares = np.random.default_rng(seed).normal(size=contacts.tangents.shape[:2])
        forces, slips = contacts.spring_forces(motion), contacts.slips(motion)
        wrenches = contacts.unit_wrenches(shares)
        kappa = contacts.least_works(motion, norms(slips))
        for i, c in enumerate(contacts.rows):
            normal, *tangents = (
                dot(row, exact) for row in (c.normal_wrench, *c.tangential_wrenches)
            )
            assert forces[i] == pytest.approx(float(spring_force(c, exact)))
            assert slips[i] == pytest.approx([float(x) for x in tangents])
            rubs = float(c.friction) * shares[i]
            columns = np.array([c.normal_wrench, *c.tangential_wrenches], dtype=float)
            assert wrenches[i] == pytest.approx(np.array([1, *rubs]) @ columns)
            rubbed = float(c.friction) * math.hypot(*map(float, tangents))
            assert kappa[i] == pytest.approx(float(normal) - rubbed)


@pytest.mark.parametrize(("kind", "cones"), [KINDS[0], KINDS[2]])
def test_balance_of_fixed_states_has_its_derivative(kind, cones):
    for seed in range(20):
        _, c, motion = law_of(kind, cones, seed)
        law = Balance.of(c, np.ones(len(motion)), cones.smooth)
        source = np.random.default_rng(seed)
        on, slides = source.random((2, len(c.rows))) < [[0.7], [0.5]]
        held = source.uniform(-0.5, 0.5, size=c.tangents.shape[:2])
        force, share, total, derivative = law.in_states(motion, on, slides, held)
        steps = 1e-6 * np.eye(len(motion))
        ends = [
            law.in_states(motion + s, on, slides, held)[2]
            - law.in_states(motion - s, on, slides, held)[2]
            for s in steps
        ]
        assert derivative() == pytest.approx(np.array(ends).T / 2e-6, rel=1e-5, abs=1e-5)
        assert force == pytest.approx(c.spring_forces(motion))
        sharp = smooth_slip(c.slips(motion), 1e-12)[0]
        assert share == pytest.approx(np.where(slides[:, None], sharp, held))
        wrench = np.where(on, force, 0) @ c.unit_wrenches(share)
        assert total - 1 == pytest.approx(wrench, rel=1e-6)
