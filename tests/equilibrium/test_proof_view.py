"""Proofs of a "no" for people: their parts cover all motions, and their works are lower bounds."""

from collections.abc import Sequence
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from hypothesis import given, reject, strategies as st

from arrangement.drawing.layout import lay_out
from arrangement.drawing.scene import Label, Path, area, measure
from arrangement.numbers.exact import dot
from equilibrium import Grasp, GraspError, Verdict, read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import certificate
from equilibrium.certificate.leaves import ClosedPart, parts, works
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict_text import verdict_lines
from equilibrium.grasps.inputs import random_grasp
from equilibrium.model.solution import Refutation
from equilibrium.pictures import draw_proof
from proofs_check.routes.oracle import Touch

from .judge import least_work, spring_and_slip
from .oracle import asked
from .trees import TooLarge, refutation

THREE = read_grasp("paper-three-contacts")


def refuted(seed: int) -> Verdict:
    """The first of some random questions that is not resisted."""
    source = Random(seed)
    while True:
        grasp = random_grasp(source.choice((1, 2, 3, 5)), source.randrange(10**6))
        grasp = grasp.with_preload(source.choice((0, 1)))
        verdict = solve(grasp, [source.randint(-3, 3) for _ in range(3)])
        if not verdict.stable:
            return verdict


def meets(part: ClosedPart, touches: Sequence[Touch], motion: Sequence[Fraction]) -> bool:
    """Whether the states decided in a part are those at a motion off all boundaries."""
    for i, wanted in part.states.items():
        force, slip = spring_and_slip(touches[i], [Fraction(1), *motion])
        way = "slip+" if slip > 0 else "slip-" if slip < 0 else "stick"
        if (wanted == "detached") != (force <= 0) or wanted not in ("detached", "attached", way):
            return False
    return True


@given(st.integers(0, 10**6), st.booleans())
def test_contact_work_bounded_for_any_friction(seed, slow):
    verdict, source = refuted(seed), Random(seed)
    grasp, wrench = verdict.grasp, verdict.wrench
    document = verdict.certificate.to_dict()
    if slow:
        try:
            document = certificate(
                "not resisted", grasp, wrench, tree=refutation(grasp, wrench, seed)
            ).to_dict()
        except TooLarge:
            reject()
    found, touches = list(parts(document)), asked(grasp, wrench).touches
    assert len(found) == check(document).leaves
    for part in found:
        done = works(grasp, wrench, [part])
        assert done.load + done.least > 0
        for _ in range(5):
            weights = [source.randint(0, 5) for _ in part.region]
            zero, *point = (dot(weights, column) for column in zip(*part.region, strict=True))
            motion = [Fraction(x, zero) for x in point] if zero else []
            if not motion or not meets(part, touches, motion):
                continue
            works_here = [least_work(touch, part.leaf.motion, motion) for touch in touches]
            for touch, factor, work in zip(touches, done.factors, works_here, strict=True):
                force = max(spring_and_slip(touch, [Fraction(1), *motion])[0], Fraction(0))
                assert work >= force * (factor or 0)
                assert factor is not None or force == 0
            assert sum(works_here) >= done.least


def regions(verdict: Verdict, sense: int) -> list[Path]:
    scene = draw_proof.scene(verdict.grasp, wrench=verdict.wrench)
    return [x for x in scene.items if isinstance(x, Path) and x.name.startswith(f"{sense}-region")]


def assert_filled(verdict: Verdict) -> None:
    """The regions of each map fill a square, and overlap nowhere."""
    for sense in (1, 2):
        found = [x.points for x in regions(verdict, sense)]
        size = np.ptp(np.concatenate(found), axis=0)
        assert size[0] == pytest.approx(size[1])
        assert sum(map(area, found)) == pytest.approx(size[0] * size[1])


@given(st.integers(0, 10**6))
def test_the_regions_of_each_map_fill_it_once(seed):
    assert_filled(refuted(seed))


def test_a_proof_by_states_is_drawn_and_said_by_their_planes():
    aside = {"virtual_motion": ["1", "2", "0"], "multipliers": {"0": ["-2"], "2": ["-2"]}}
    inner = {"contact": 2, "attachment": {"detached": ["1", "2", "0"], "attached": aside}}
    tree = {"contact": 0, "attachment": {"detached": ["-1", "2", "0"], "attached": inner}}
    wrench = (Fraction(0), Fraction(1), Fraction(0))
    verdict = Solver(THREE)._verdict(wrench, Refutation(tree))
    assert verdict.verify()
    said = "\n".join(verdict_lines(verdict))
    assert "contact 1 attached, contact 3 detached: on the virtual" in said
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Solver, "solve", lambda *_: verdict)
        assert_filled(verdict)
        assert {len(regions(verdict, sense)) for sense in (1, 2)} == {2}


def test_maps_without_preload_hold_for_all_sizes():
    figure = draw_proof(THREE, wrench=(0, 1, 0))
    assert "motions of every size" in "".join(t.get_text() for t in figure.axes[0].texts)


def test_a_resisted_wrench_has_no_proof_to_draw():
    with pytest.raises(GraspError, match=r"is resisted.*the view grasp"):
        draw_proof(THREE, wrench=(0, -1, 0))


WORDS = """\
not resisted: no contact state admits an equilibrium
proof: no contact forces in the friction cones balance the load
  x >= 0: on the virtual motion (-1, 2, 0) the load does work 11/5, the contacts at least -2
    least work at contact 1: -2 of its normal force
    least work at contact 2: 3/2 of its normal force
    least work at contact 3: 0 of its normal force
  x <= 0: on the virtual motion (1, 2, 0) the load does work 11/5, the contacts at least -2
    least work at contact 1: 0 of its normal force
    least work at contact 2: 3/2 of its normal force
    least work at contact 3: -2 of its normal force
"""


def test_solve_says_a_short_proof_in_words(run):
    question = ["solve", "paper-three-contacts-preload-1", "--wrench", "0", "11/10", "0"]
    assert run(*question, code=1) == WORDS
    assert "proof" not in run.json(*question, code=1)


def test_solve_counts_the_leaves_of_a_longer_proof(run):
    printed = run("solve paper-four-contacts --wrench 0 1 0", code=1)
    report = solve(read_grasp("paper-four-contacts"), (0, 1, 0)).verify()
    line = f"proof: {report.leaves} leaves; --certificate OUT.json writes it\n"
    assert printed.endswith(line)


@pytest.mark.parametrize("name", ["paper-three-contacts", "paper-four-contacts"])
@pytest.mark.parametrize("wrench", [(0, 1, 0), (0, 2, 1), (1, 3, 1), (0, 2, -1)])
def test_no_label_covers_an_arrow(name, wrench):
    scene = draw_proof.scene(read_grasp(name), wrench=wrench)
    boxes = []
    for label in scene.items:
        if isinstance(label, Label) and "work-" in label.name:
            x, y = label.place
            half = measure(label.text)[0] / 2
            boxes.append((x - half, y - 3, x + half, y + 3))
    assert len(boxes) >= len(read_grasp(name))
    ways = [x.points for x in scene.items if isinstance(x, Path) and "shift-" in x.name]
    ends = np.concatenate([np.linspace(way[3], (way[0] + way[-1]) / 2, 20) for way in ways])
    for left, low, right, high in boxes:
        inside = (ends > (left, low)) & (ends < (right, high))
        assert not inside.all(axis=1).any()


def test_beyond_eight_contacts_the_page_is_named_for_the_numbers():
    grasp = Grasp([c for c in random_grasp(60, 7) if c.normal[1] > 0][:9])
    scene = lay_out(draw_proof.scene(grasp, wrench=(0, 50, 0)))
    texts = [item for item in scene.items if isinstance(item, Label)]
    assert not any("work-" in item.name or "number-" in item.name for item in texts)
    assert any("a page (.html) has them" in item.text for item in texts)
