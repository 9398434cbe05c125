"""Values of a parameter for which a load is resisted: proofs for whole intervals at once."""

import json
import math
import re
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from random import Random

import numpy as np
import pytest
from PIL import Image

from arrangement import InputError
from arrangement.numbers.expressions import read_expression
from arrangement.numbers.functions import Domain, Function, Span, Undecided
from equilibrium import GraspError, ResistedSet, read_grasp, resisted_values, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import certificate, resisted_certificate
from equilibrium.grasps.inputs.parameter import read_parametric
from equilibrium.grasps.schemas import parameter_certificate_schema
from equilibrium.model.solution import Solution
from equilibrium.pictures.parameter import draw_values
from equilibrium.wrench_sets.parameter import Piece, _Search
from equilibrium.wrench_sets.sufficient_friction import sufficient_friction
from tests.schemas import validator

F = Fraction


def grasp(*contacts, wrench):
    """Return a document; a contact is point, normal or angle, friction, and maybe more."""
    listed = []
    for point, normal, friction, *rest in contacts:
        direction = {"angle": normal} if isinstance(normal, str) else {"normal": list(normal)}
        entry = {"point": list(point), **direction, "friction": friction, **(rest or [{}])[0]}
        listed.append(entry)
    return {"schema_version": 1, "contacts": listed, "wrench": list(wrench)}


FLOOR, WALL = (("0", "0"), ("0", "1")), (("4", "3"), ("-1", "0"))
#: A ladder with its foot at the origin and its top at (4, 3); a weight of 1 in its middle.
LADDER = grasp((*FLOOR, "t"), (*WALL, "0"), wrench=("0", "-1", "-2"))
#: A man of weight 1 on it, the share t of the way up; friction 2/5 at both ends.
CLIMBER = grasp((*FLOOR, "2/5"), (*WALL, "2/5"), wrench=("0", "-1", "-4*t"))
#: The same with the angle of the ladder, of length 1, in degrees: friction 1/2 at the floor.
LEANING = grasp(
    (("0", "0"), ("0", "1"), "1/2"),
    (("cos(t)", "sin(t)"), ("-1", "0"), "0"),
    wrench=("0", "-1", "-cos(t)/2"),
)
#: A block on a slope of t degrees with friction 1/2: it slides where tan t > 1/2.
SLOPE = grasp(
    (("0", "0"), "t+90", "1/2"),
    (("cos(t)", "sin(t)"), "90+t", "1/2"),
    wrench=("0", "-1", "-(cos(t)/2 - sin(t)/4)"),
)
#: Two stacked blocks; the upper one, of weight 1, is pushed by t: friction 1/4 between them.
STACK = {
    "schema_version": 1,
    "bodies": ["lower", "upper"],
    "contacts": [
        {"body_a": a, "body_b": b, "point": [x, y], "normal": ["0", "1"], "friction": mu}
        for a, b, y, mu in (("lower", None, "0", "1"), ("upper", "lower", "1", "1/4"))
        for x in ("-2", "2")
    ],
    "wrench": {"lower": ["0", "-1", "0"], "upper": ["t", "-1", "-t"]},
}


@pytest.mark.parametrize(
    ("document", "ends", "intervals", "slips"),
    [
        (LADDER, (0, 1), ["[2/3, 1]"], (1,)),
        (CLIMBER, (0, 1), ["[0, 23/58]"], (1, 2)),
        (STACK, (0, 1), ["[0, 1/4]"], (3, 4)),
    ],
)
def test_ends_are_exact_where_both_sides_stop_at_one_value(document, ends, intervals, slips):
    """By hand: tan of the friction angle; moments about the top; the force at the limit."""
    answer = resisted_values(document, *ends)
    assert [str(span) for span in answer.resisted] == intervals
    assert (answer.gaps, answer.complete) == ((), True)
    assert all(answer.verify())
    (end,) = answer.ends
    assert end.gives is not None
    assert end.gives.slips == slips


@pytest.mark.parametrize(
    ("document", "ends", "tangent"),
    [(SLOPE, (0, 45), (F(1, 2), "below")), (LEANING, (30, 80), (F(1), "above"))],
)
def test_angles_end_within_a_bracket(document, ends, tangent):
    """The block slides beyond tan t = mu; the ladder stands from tan t = 1 / (2 mu) on."""
    answer = resisted_values(document, *ends)
    inside = answer.resisted[0]
    end = inside.high if tangent[1] == "below" else inside.low
    (gap,) = (gap for gap in answer.gaps if end in gap)
    assert answer.complete
    assert all(gap.high - gap.low <= F(1, 10**6) for gap in answer.gaps)
    assert all(answer.verify())

    def tan(u):
        return 2 * u / (1 - u * u)

    assert tan(gap.low) < tangent[0] < tan(gap.high)


def test_loads_have_the_ends_that_magnitudes_have():
    """A family that is linear in the load: `along` answers it by other programs."""
    source = read_grasp("paper-three-contacts")
    for direction in ((1, 0, 0), (0, -1, 0), (1, 2, -1)):
        document = source.to_dict() | {"wrench": [f"{x}*t" for x in direction]}
        document.pop("outline", None)
        answer = resisted_values(document, 0, 4)
        intervals = ResistedSet(source).along(direction).intervals
        clipped = [(low, 4 if high is None else min(high, 4)) for low, high in intervals]
        for span, (low, high) in zip(answer.resisted, clipped, strict=True):
            assert low <= span.low <= low + F(1, 10**6)
            assert high - F(1, 10**6) <= span.high <= high


#: Their proofs by regions hold for short intervals only; those by states turn with the letter.
LONG_TREES = [
    grasp(
        (("1/2", "2"), ("-4/5", "3/5"), "1/3"),
        (("2", "1/2"), ("2*t", "1 - t^2"), "2", {"preload": "t"}),
        wrench=("1/2", "1/2", "-1"),
    ),
    grasp(
        (("t", "t"), ("0", "-1"), "1/5"),
        (("-1", "1"), ("4/5", "-3/5"), "1", {"preload": "t"}),
        (("t", "-1"), ("0", "1"), "2"),
        wrench=("1", "-1", "1/2"),
    ),
]


@pytest.mark.parametrize("document", LONG_TREES)
def test_few_proofs_are_enough(document):
    answer = resisted_values(document, 0, 1)
    assert answer.complete
    assert len(answer.pieces) <= 6
    assert all(answer.verify())


NORMALS = [("1", "0"), ("0", "1"), ("-1", "0"), ("0", "-1"), ("3/5", "4/5"), ("-4/5", "3/5")]
TURNING = [("2*t", "1 - t^2"), ("t^2 - 1", "2*t"), ("5/13", "-12/13")]


def random_family(source):
    """Return a random document in t, with one or two contacts."""
    contacts = []
    for _ in range(source.randint(1, 2)):
        normal = source.choice(TURNING if source.random() < 0.2 else NORMALS)
        moving = source.random() < 0.4
        point = [source.choice(["0", "1", "-1", *["t", "1-t"] * moving]) for _ in range(2)]
        values = {
            "stiffness": source.choice(["1", "2", "1 + t"]),
            "preload": source.choice(["0", "1", "t"]),
        }
        contacts.append((point, normal, source.choice(["0", "1/2", "1", "t"]), values))
    wrench = [source.choice(["0", "1", "-1", "t", "-t", "1 - 2*t"]) for _ in range(3)]
    return grasp(*contacts, wrench=wrench)


#: The first seed and the number of random families: 25, and 1000 more in the slow tests.
BLOCKS = [(0, 25), *(pytest.param((1000 * k, 100), marks=pytest.mark.slow) for k in range(1, 11))]


@pytest.fixture(scope="module", params=BLOCKS, ids=lambda block: f"families {block[0]}")
def answers(request):
    """Answers for random families; their letter stands somewhere."""
    found, (start, count) = [], request.param
    for seed in range(start, start + 1000):
        source = Random(f"family {seed}")
        document = random_family(source)
        numbers = [x["point"] + x["normal"] for x in document["contacts"]]
        numbers += [list(x.values())[2:] for x in document["contacts"]]
        if "t" in json.dumps([numbers, document["wrench"]]):
            found.append(resisted_values(document, 0, 1))
        if len(found) == count:
            return found
    raise AssertionError("too few families")


def test_every_value_has_the_verdict_of_its_interval(answers):
    kinds = Counter()
    for i, answer in enumerate(answers):
        assert answer.complete
        source = Random(i)
        ends = [x for piece in answer.pieces for x in (piece.span.low, piece.span.high)]
        for value in [*ends[:6], *(F(source.randint(0, 100), 100) for _ in range(6))]:
            proved = answer.verdict_at(value)
            if proved != "undecided":
                assert solve(*answer.family.at(value)).verdict == proved
                kinds[proved] += 1
        covered = [answer.between.low, *ends, answer.between.high]
        assert all(b - a <= F(1, 10**6) for a, b in list(pairwise(covered))[::2])
    assert min(kinds.values()) > 40


def numbers_at(proof, letter, value):
    """Return a proof with the values of its expressions."""
    if isinstance(proof, dict):
        return {key: numbers_at(x, letter, value) for key, x in proof.items()}
    if isinstance(proof, list):
        return [numbers_at(x, letter, value) for x in proof]
    if isinstance(proof, str) and proof not in ("stick",):
        return str(read_expression(proof, letter).value(value))
    return proof


def test_certificates_hold_at_single_values_by_the_ordinary_checker(answers):
    checked = 0
    for answer in answers:
        for piece in answer.pieces:
            span = piece.span
            values = [span.low + (span.high - span.low) * F(k, 21) for k in range(1, 21)]
            for value in values[:: 1 if span.low < span.high else 20]:
                subject, load = answer.family.at(value)
                proof = numbers_at(dict(piece.proof), "t", value)
                if "tree" in proof:
                    made = certificate("not resisted", subject, load, tree=proof["tree"])
                else:
                    forces = tuple(tuple(map(F, row)) for row in proof["forces"])
                    made = resisted_certificate(
                        subject, load, Solution(tuple(map(F, proof["motion"])), forces)
                    )
                assert made.verify()
                checked += 1
    assert checked > 500


def forged(source, value):
    """Return a document with one number of its proof, or an end, changed."""
    if isinstance(value, dict):
        key = source.choice(sorted(value))
        return {**value, key: forged(source, value[key])}
    if isinstance(value, list) and value:
        i = source.randrange(len(value))
        return [*value[:i], forged(source, value[i]), *value[i + 1 :]]
    if isinstance(value, str):
        return source.choice([f"{value} + 1/7", f"-({value})", "0", f"({value})*t", "1"])
    return value


@pytest.mark.parametrize("count", [120, pytest.param(600, marks=pytest.mark.slow)])
def test_what_is_accepted_after_a_change_is_true(answers, count):
    """Forged proofs and intervals are refused, or what they say holds at each value tried."""
    documents = [document for answer in answers for document in answer.certificates]
    source, found = Random("forged"), Counter()
    for _ in range(count):
        document = source.choice(documents)
        keys = [key for key in ("motion", "forces", "tree", "parameter") if key in document]
        key = source.choice(keys)
        if key == "parameter":
            low, high = (F(document[key][end]) for end in ("from", "to"))
            wide = {"letter": "t", "from": str(low - F(1, 5)), "to": str(high + F(1, 5))}
            document = {**document, key: wide}
        else:
            document = {**document, key: forged(source, document[key])}
        try:
            report = check(document)
        except InputError:
            found["unreadable"] += 1
            continue
        found[bool(report)] += 1
        if report:
            span = report.span
            for k in range(3):
                value = span.low + (span.high - span.low) * F(2 * k + 1, 6)
                asked = report.family.at(value)
                assert solve(*asked).verdict == report.kind
    assert found[False] > count / 3


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"wrench": ["0", "-1", "t t t +"]}, "ends too early"),
        ({"wrench": ["0", "-1", "__import__('os')"]}, "expected an expression in t"),
        ({"wrench": ["0", "-1", "t/2t"]}, "a product without [*] behind a /"),
        ({"wrench": ["0", "-1"]}, "wrench has 2 entries; expected 3"),
        ({"contacts": [*LADDER["contacts"], "x"]}, "contacts.2. is 'x'; expected a JSON object"),
        ({"contacts": [*LADDER["contacts"], None]}, "contacts.2. is null; expected a JSON object"),
        ({"contacts": [LADDER["contacts"][0] | {"normal": "1"}]}, "expected a list"),
        (grasp((("0", "0"), ("0", []), "t"), wrench="012"), "is not a number or an expression"),
        (grasp((("0", "0"), ("t", "1"), "1"), wrench="012"), "no rational function"),
        (grasp((("0", "0"), ("t", "t"), "1"), wrench="012"), "no rational function|normal is 0"),
        (grasp((("0", "0"), ("0", "1"), "t - 1"), wrench="012"), "friction is (t - 1|-1/2)"),
        (grasp((("1/t", "0"), ("0", "1"), "1"), wrench="012"), "divides by 0"),
        (grasp((("0", "0"), "t", "t"), wrench="012"), "the letter is an angle"),
        (grasp((("0", "0"), "2*t", "1"), wrench="012"), "an angle is t or -t"),
        (grasp((("0", "0"), ("0", "1"), "1"), wrench="012"), "stands nowhere"),
        (
            grasp((("0", "0"), ("0", "1"), "t", {"angle": "0"}), wrench="012"),
            "an angle and a normal; keep one",
        ),
        (grasp((("0", "0"), ("0", "1"), "sin(cos(t))"), wrench="012"), "letter is an angle"),
        (grasp((("0", "0"), ("0", "1"), "t/1e4999"), wrench="012"), "more than 4000 bits"),
        (grasp((("0", "0"), ("0", "1"), "t + ((9^20)^20)^20"), wrench="012"), "4000 bits"),
    ],
)
def test_what_is_no_question_is_one_clear_error(change, words):
    with pytest.raises(InputError, match=words) as caught:
        resisted_values({**LADDER, **change}, 0, 1)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d["motion"].__setitem__(0, "1/0"), "divides by zero"),
        (lambda d: d["motion"].__setitem__(0, "cos(t)"), "letter is an angle"),
        (lambda d: d["grasp"]["contacts"][0].__setitem__("angle", "90"), "keep one"),
        (lambda d: d["motion"].__setitem__(0, "((t^20)^20)^20"), "a degree above 1000"),
        (lambda d: d["grasp"]["contacts"][0]["point"].append("0"), "point has 3 coordinates"),
        (lambda d: d["grasp"].__setitem__("strange", 1), "strange"),
        (lambda d: d["parameter"].__setitem__("to", "0"), "has no values"),
        (lambda d: d["parameter"].__setitem__("without", ["to", "to"]), "expected .from., .to."),
        (lambda d: d["parameter"].__setitem__("letter", "s"), "expected an expression in s"),
    ],
)
def test_what_is_no_certificate_is_one_clear_error(change, words):
    document = json.loads(json.dumps(resisted_values(LADDER, 0, 1).certificates[-1]))
    assert check(document)
    change(document)
    with pytest.raises(InputError, match=words):
        check(document)


def test_schema_takes_certificates_and_refuses_others(answers):
    schema = validator(parameter_certificate_schema())
    angle, stack = resisted_values(SLOPE, 0, 45), resisted_values(STACK, 0, 1)
    documents = [x for answer in (*answers, angle, stack) for x in answer.certificates]
    assert len(documents) > 40
    for document in documents:
        schema.validate(json.loads(json.dumps(document)))
    proof = resisted_values(LADDER, 0, 1).certificates[-1]
    contact = proof["grasp"]["contacts"][0]
    for change in (
        {"parameter": {"letter": "t", "from": "0"}},
        {"parameter": {"letter": "time", "from": "0", "to": "1"}},
        {"parameter": {"letter": "t", "from": "0", "to": "1", "without": ["low"]}},
        {"schema_version": 2},
        {"motion": ["0", "1"]},
        {"motion": [0.5, "0", "1"]},
        {"motion": ["__import__", "0", "1"]},
        {"tree": ["0", "1", "0"]},
        {"certificate": "not resisted"},
        {"assembly": STACK},
        {"grasp": {"contacts": [{**contact, "angle": "90"}]}},
        {"grasp": {"contacts": [{**contact, "strange": "1"}]}},
    ):
        assert not schema.is_valid({**proof, **change})


def test_certificates_are_compared_with_a_question_with_the_letter(tmp_path, run, refused):
    table, proof = tmp_path / "ladder.csv", tmp_path / "proof.json"
    table.write_text("x,y,nx,ny,mu\n0,0,0,1,3*t/3\n4,3,-1,0,0\n")
    proof.write_text(json.dumps(resisted_values(LADDER, 0, 1).certificates[-1]))
    line = ["verify", str(proof), "--grasp", str(table)]
    assert "give --grasp" not in run(*line, "--weight", "1", "--at", "2", "3/2")
    assert "not valid: its wrench differs" in run(*line, "--wrench", "0", "-2", "-2", code=1)
    for friction, words in (
        ("t/2", "its contacts differ"),
        ("t^2", "its contacts differ|its numbers"),
    ):
        table.write_text(f"x,y,nx,ny,mu\n0,0,0,1,{friction}\n4,3,-1,0,0\n")
        assert re.search(words, run(*line, "--wrench", "0", "-1", "-2", code=1))
    refused(*line)
    refused(*line[:2], "--wrench", "0", "-1", "-2")
    assert "not compared with a question" in run(*(line[:2]))
    stack = tmp_path / "stack.json"
    stack.write_text(json.dumps(STACK))
    for document in resisted_values(STACK, 0, 1).certificates:
        proof.write_text(json.dumps(document))
        run("verify {} --grasp", proof, stack)
    report = check(document, read_parametric({**STACK, "bodies": ["lower", "other"]}))
    assert "other bodies" in report.problem
    assert "other bodies" in check(document, read_parametric(LADDER)).problem
    assert "parameter is another one" in check(document, read_parametric(SLOPE)).problem


@pytest.mark.parametrize(
    ("document", "ends", "bars"),
    [
        (LADDER, (0, 1), {"not-resisted-1": 2 / 3, "resisted-1": 1 / 3}),
        (LADDER, (0, "1/2"), {"not-resisted-1": 1}),
        (SLOPE, (0, 45), {"resisted-1": math.degrees(math.atan(0.5)) / 45}),
        (STACK, (0, 1), {"resisted-1": 1 / 4, "not-resisted-1": 3 / 4}),
    ],
)
def test_picture_shows_verdicts_along_the_letter(document, ends, bars):
    """Bars are as long as the intervals; the objects at the ends are drawn above them."""
    answer = resisted_values(document, *ends)
    scene = draw_values.scene(answer)
    drawn = {x.name: x.points for x in scene.items if x.name in (*bars, "between", "resisted-1")}
    whole = np.ptp(drawn["between"][:, 0])
    for name, share in bars.items():
        assert np.ptp(drawn[name][:, 0]) == pytest.approx(share * whole, rel=1e-4)
    assert ("resisted-1" in drawn) == bool(answer.resisted)
    texts = {item.text for item in scene.items if hasattr(item, "text")}
    assert len([text for text in texts if text.startswith("t = ")]) == (1 if answer.ends else 2)
    lines = [text for text, _ in scene.legend.lines]
    assert any("slips at contact" in text for text in lines) == any(
        e.gives and e.gives.slips for e in answer.ends
    )
    assert len({key.text for key in scene.legend.keys}) == len(scene.legend.keys)


def test_picture_of_values_by_the_command(tmp_path, run, refused):
    table, picture = tmp_path / "ladder.csv", tmp_path / "ladder.svg"
    table.write_text("x,y,nx,ny,mu\n0,0,0,1,t\n4,3,-1,0,0\n")
    load = ["--weight", "1", "--at", "2", "3/2"]
    line = ["draw", str(table), "-o", str(picture), "--parameter", "t=0..1"]
    run(*line, *load)
    assert 'id="resisted-1"' in picture.read_text()
    refused(*line, *load, "--view", "polar")
    refused(*line, *load, "--origin", "0", "0", "0")
    assert "there is no wrench" in refused(*line)


def test_pad_tips_where_its_load_is_too_high():
    """A block of weight 5 on a pad from -1 to 1 is pushed by 2 at the height t: 2 t = 5 at most."""
    places = [
        {"point": [x, "0"], "normal": ["0", "1"], "friction": "1/2"} for x in ("-1", "0", "1")
    ]
    points = [{**x, "share": "1/3", "stiffness": "1/3"} for x in places]
    document = {"schema_version": 1, "contacts": points, "wrench": ["2", "-5", "-2*t"]}
    answer = resisted_values(document, 0, 5)
    assert [str(span) for span in answer.resisted] == ["[0, 5/2]"]
    assert [str(span) for span in answer.not_resisted] == ["(5/2, 5]"]
    assert all(answer.verify())
    least = sufficient_friction({**document, "wrench": ["2", "-5", "-2"]}, [1])
    assert (least.low, least.high) == (F(2, 5), F(2, 5))
    with pytest.raises(GraspError, match="numbers of contacts from 1 to 1"):
        sufficient_friction({**document, "wrench": ["2", "-5", "-2"]}, [2])
    for y, words in (("t", "same height"), ("(t-1)*t", "for some value")):
        bent = [points[0], {**points[1], "point": ["0", y]}, points[2]]
        with pytest.raises(GraspError, match=words):
            resisted_values({**document, "contacts": bent}, 0, 2)


def test_movie_shows_the_object_at_each_value(tmp_path, run):
    table, movie = tmp_path / "ladder.csv", tmp_path / "ladder.gif"
    table.write_text("x,y,nx,ny,mu\n0,0,0,1,t\n4,3,-1,0,0\n")
    line = ["draw", str(table), "--wrench", "0", "-1", "-2", "--parameter", "t=0..1"]
    run(*line, "-o", movie, "--frames", "4")
    with Image.open(movie) as pictures:
        assert pictures.n_frames == 4
    answer = resisted_values(LADDER, 0, 1)
    for value, words in ((F(1, 3), "no equilibrium"), (F(1), "")):
        scene = draw_values.scene(answer, value=value)
        assert f"t = {value}" in {item.text for item in scene.items if hasattr(item, "text")}
        lines = [text for text, _ in scene.legend.lines]
        assert (f"t = {value}: no equilibrium" in lines) == bool(words)
    with pytest.raises(GraspError, match="value is 2; expected one in"):
        draw_values.scene(answer, value=2)


def test_comparisons_have_one_answer_or_none():
    letter = Function.letter(Domain(Span(F(0), F(1))))
    assert letter >= 0
    assert letter <= 1
    assert not letter < 0
    assert abs(letter - 2) == 2 - letter
    with pytest.raises(Undecided, match="t has more than one sign"):
        bool(letter > 0)
    narrowed = Domain(Span(F(0), F(1)), F(3, 4))
    assert Function.letter(narrowed) * 3 >= 2
    assert str(narrowed.span) == "[2/3, 1]"
    assert Function.letter(narrowed) * Function.letter(narrowed) < F(3, 4)
    assert F(2, 3) < narrowed.span.high < F(866025404, 10**9)


#: The ladder smooth at both ends.
SMOOTH = {**LADDER, "contacts": [{**x, "friction": "0"} for x in LADDER["contacts"]]}


@pytest.mark.parametrize(
    ("document", "contacts", "least"),
    [
        (SMOOTH, [1], F(2, 3)),
        # tan of the ladder's angle is 3/4 = (1 - f^2) / (2 f).
        (SMOOTH, [1, 2], F(1, 2)),
        (SMOOTH, [2], None),
        # Both slip: the floor bears n and n/3, the wall n/3 and f n/3 with n (1 + f/3) = 1; moments
        # about the foot give 3/3 n + 4 f/3 n = 2, so f = 3/2.
        (
            {
                **SMOOTH,
                "contacts": [{**SMOOTH["contacts"][0], "friction": "1/3"}, SMOOTH["contacts"][1]],
            },
            [2],
            F(3, 2),
        ),
        (STACK, [3, 4], F(1, 7)),
    ],
)
def test_least_friction_of_named_contacts(document, contacts, least):
    if document is STACK:
        document = {**STACK, "wrench": {"lower": ["0", "-1", "0"], "upper": ["1/7", "-1", "-1/7"]}}
    answer = sufficient_friction(document, contacts)
    assert (answer.low, answer.high, answer.impossible) == (least, least, least is None)
    asked = [x for x in (answer.up_to_1, answer.from_1) if x is not None]
    assert len(asked) == (2 if least is None or least > 1 else 1)
    assert all(all(x.verify()) for x in asked)
    assert all(x.complete for x in asked)


def test_least_friction_is_in_the_bracket_of_all_states():
    """`Margin.friction` refutes ranges by linear programs of all contact states."""
    bounded = 0
    for seed in range(14):
        source = Random(f"friction {seed}")
        contacts = [
            (
                [str(source.randint(-2, 2)) for _ in "xy"],
                source.choice(NORMALS),
                "1/2",
                {"preload": source.choice("012")},
            )
            for _ in range(source.randint(2, 3))
        ]
        document = grasp(*contacts, wrench=[str(source.randint(-2, 2)) for _ in range(3)])
        chosen = [1, len(contacts)][: source.randint(1, 2)]
        answer = sufficient_friction(document, chosen, tolerance="1/10000")
        margin = ResistedSet(
            read_grasp({k: x for k, x in document.items() if k != "wrench"})
        ).margin(document["wrench"])
        other = margin.friction("1/1000", chosen)
        assert answer.impossible == other.impossible
        if answer.high is not None:
            assert answer.low <= other.high
            assert other.low <= answer.high
            bounded += 1
    assert bounded > 4


def test_few_questions_leave_an_answer_incomplete(monkeypatch):
    monkeypatch.setattr("equilibrium.wrench_sets.parameter._MOST_QUESTIONS", 1)
    answer = resisted_values(LADDER, 0, 1)
    assert not answer.complete
    assert [str(span) for span in (*answer.resisted, *answer.not_resisted)] != []
    assert max(gap.high - gap.low for gap in answer.gaps) > answer.tolerance


@pytest.mark.parametrize("has_middle", [(True, False), (False, True), (False, False)])
def test_pieces_are_one_only_with_the_value_between_them(has_middle):
    answer = resisted_values(LADDER, 0, 1)
    whole = next(piece for piece in answer.pieces if piece.verdict == "resisted")
    low, middle, high = F(3, 4), F(4, 5), F(9, 10)
    parts = (
        whole._replace(span=Span(low, middle, True, has_middle[0])),
        whole._replace(span=Span(middle, high, has_middle[1], True)),
    )
    search = _Search(answer.family, answer.between, answer.tolerance)
    joined = whole._replace(span=Span(low, high)) if any(has_middle) else None
    assert search._union(*parts) == joined


def test_least_friction_above_1_is_that_of_the_largest_inverse():
    """Where the inverses f of sufficient coefficients 1/f have two intervals."""
    answer = sufficient_friction(SMOOTH, [2])
    proofs = [Piece(Span(F(1, a), F(1, b)), "resisted", {}) for a, b in ((5, 4), (3, 2))]
    between = replace(answer, from_1=replace(answer.from_1, pieces=tuple(proofs)))
    assert between.high == 2


def test_friction_of_no_contacts_is_refused():
    with pytest.raises(GraspError, match="expected at least one number"):
        sufficient_friction(SMOOTH, [])
    with pytest.raises(GraspError, match="numbers of contacts from 1 to 2"):
        sufficient_friction(SMOOTH, [3])


def test_tables_and_the_command(tmp_path, run, refused):
    table = tmp_path / "ladder.csv"
    table.write_text("x,y,nx,ny,mu\n0,0,0,1,t\n4,3,-1,0,0\n")
    family = read_parametric(str(table), wrench=["0", "-1", "-2"])
    assert family.at(F(1, 2))[0].contacts[0].friction == F(1, 2)
    line = ["resisted", str(table), "--wrench", "0", "-1", "-2", "--parameter", "t=0..1"]
    out = run(*line)
    assert "resisted for 2/3 <= t <= 1\n" in out
    assert "not resisted for 0 <= t < 2/3\n" in out
    assert "in all equilibria at 2/3: slips at contact 1" in out
    for document in run.json(*line)["certificates"]:
        path = tmp_path / "proof.json"
        path.write_text(json.dumps(document))
        assert "all t in" in run("verify", path)
    run(*line[:-1], "t=0..1/2", code=1)
    refused(*line[:-1], "t=0-1")
    assert "--preload does not go with --parameter" in refused(*line, "--preload", "1")
    stack = tmp_path / "stack.json"
    rough = [{**c, "friction": "t"} if c["body_b"] else c for c in STACK["contacts"]]
    stack.write_text(json.dumps({**STACK, "contacts": rough, "wrench": {}}))
    on = ["--on", "lower", "0", "-1", "0", "--on", "upper", "1/4", "-1", "-1/4"]
    assert "resisted for 1/4 <= t <= 1\n" in run("resisted", stack, *on, "--parameter", "t=0..1")
    weight = ["resisted", str(table), "--weight", "1", "--at", "2", "3/2"]
    assert "resisted for 2/3 <= t <= 1\n" in run(*weight, "--parameter", "t=0..1")
    table.write_text("x,y,nx,ny,mu\n0,0,0,1,0\n4,3,-1,0,0\n")
    assert run(*weight, "--friction", "1").startswith(
        "least friction of contact 1: 2/3\nresisted for 2/3 <= f"
    )
    printed = run(*weight, "--friction", "2", code=1)
    assert "contact 2: none is enough\nno friction f up to 1" in printed
    error = refused(*weight, "--friction", "1", "--parameter", "t=0..1")
    assert "--parameter and --friction are two questions" in error
    assert "--margin goes with a load" in refused(*line, "--margin")
