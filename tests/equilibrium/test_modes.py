"""Contact modes: tables of boxes, against all faces of all planes, and the command."""

import re
from fractions import Fraction
from itertools import product

import pytest

from arrangement import Arrangement, InputError
from arrangement.library.files.json_files import read_document
from equilibrium import ContactModes, Grasp, read_grasp
from equilibrium.grasps.inputs import random_grasp
from proofs_check.routes.contact_modes import mode_counts

Row = tuple[int, ...]
CORNERS = list(product((-1, 1), repeat=2))


def counts(modes: ContactModes) -> tuple[int, int]:
    return len(modes.contacting_separating), modes.sliding_sticking_count


def recounted(modes: ContactModes) -> tuple[int, int]:
    return mode_counts(modes.normals, modes.tangents, modes.n)


@pytest.mark.parametrize(
    ("walls", "contacting", "sliding"),
    [(1, 10, 196), (2, 46, 228), (3, 136, 136), (4, 10, 10), (5, 2, 2), (6, 1, 1)],
)
def test_boxes_at_walls(walls, contacting, sliding):
    modes = ContactModes.of_grasp(read_grasp(f"box-{walls}-wall{'s' * (walls > 1)}"))
    assert counts(modes) == recounted(modes) == (contacting, sliding)


def wrench(point: Row, force: Row) -> Row:
    (x, y, z), (a, b, c) = point, force
    return (a, b, c, y * c - z * b, z * a - x * c, x * b - y * a)


def box_on_a_box(walls: int) -> ContactModes:
    """Two cubes, one on the other: six coordinates of the upper one, and x, y, r_z of the lower.

    The first wall is the floor; the second stands at both, at x = -1.
    """
    normals, tangents = [], []

    def touch(point: Row, axis: int, upper: int, lower: int) -> None:
        def row(direction: int) -> Row:
            force = tuple(int(i == direction) for i in range(3))
            full = wrench(point, force)
            return tuple(upper * x for x in full) + tuple(lower * full[i] for i in (0, 1, 5))

        normals.append(row(axis))
        tangents.append(tuple(row(i) for i in range(3) if i != axis))

    for x, y in CORNERS:
        touch((x, y, 1), 2, 1, -1)
        touch((x, y, -1), 2, 0, 1)
    for y, z in CORNERS if walls == 2 else ():
        touch((-1, y, z), 0, 0, 1)
        touch((-1, y, z + 2), 0, 1, 0)
    return ContactModes(tuple(normals), tuple(tangents), 9)


@pytest.mark.parametrize(
    ("walls", "name", "modes"),
    [
        (1, "box-on-a-box-1-wall", (10, 9996)),
        pytest.param(2, "box-on-a-box-2-walls", (184, 11996), marks=pytest.mark.slow),
    ],
)
def test_a_box_on_a_box(walls, name, modes, run):
    boxes = ContactModes.from_dict(read_document(name, ("normals",)))
    built = box_on_a_box(walls)
    assert (boxes.normals, boxes.tangents, boxes.n) == (built.normals, built.tangents, 9)
    assert recounted(boxes) == modes
    assert tuple(run.json("info {} --modes --count", name).values()) == modes


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        ({"normals": [[1, 0], ["1/2"]], "tangents": [[], []]}, "lengths [1, 2]"),
        ({"normals": [], "tangents": []}, "lengths []"),
        ({"normals": [[]], "tangents": [[]]}, "lengths [0]"),
        ({"normals": [[1]], "tangents": []}, "tangents has 0 entries; expected 1"),
        ({"normals": [[1]], "tangents": [[1]]}, "tangents is 1"),
        ({"normals": [5], "tangents": [[]]}, "normals is 5"),
        ({"normals": [["x"]], "tangents": [[]]}, "not an exact number"),
        ({"normals": [[1]], "tangents": [[]], "wall": 1}, "unknown key 'wall'"),
    ],
)
def test_rows_that_are_none_are_refused(wrong, why):
    with pytest.raises(InputError, match=re.escape(why)):
        ContactModes.from_dict({"schema_version": 1, **wrong})


SMALL = [
    "two-opposed-fingers",
    "three-fingers-on-a-ball",
    "wedge",
    "paper-three-contacts",
    "paper-four-contacts",
    "opposed-contacts",
]


def all_modes(modes: ContactModes) -> tuple[set[Row], set[tuple[Row | None, ...]]]:
    """The modes from all faces of all planes, inside the cone and outside."""
    m = len(modes.normals)
    rows = [*modes.normals, *(row for pair in modes.tangents for row in pair)]
    inside = [
        face.signs
        for face in Arrangement(rows, dimension=modes.n).faces()
        if min(face.signs[:m], default=0) >= 0
    ]
    k = (len(rows) - m) // m if m else 0
    slips = {
        tuple(None if s[i] else s[m + k * i : m + k * i + k] for i in range(m)) for s in inside
    }
    return {signs[:m] for signs in inside}, slips


@pytest.mark.parametrize(
    "grasp",
    [read_grasp(name) for name in SMALL]
    + [
        random_grasp(m, seed=m, dimension=d)
        for d, m in ((2, 0), (2, 1), (2, 3), (2, 6), (3, 1), (3, 2))
    ]
    + [Grasp([*read_grasp("wedge"), *read_grasp("wedge")][:4])],
    ids=repr,
)
def test_they_are_the_faces_of_all_planes_on_the_right_side(grasp):
    modes = ContactModes.of_grasp(grasp)
    kept, slid = all_modes(modes)
    listed = list(modes.sliding_sticking())
    assert {mode.signs for mode in modes.contacting_separating} == kept
    assert {mode.signs for mode in listed} == slid
    assert (len(kept), len(listed)) == counts(modes) == recounted(modes)


def test_the_command_counts_and_lists(run):
    assert run.json("info box-1-wall --modes --count --time-limit 600") == {
        "contacting_separating": 10,
        "sliding_sticking": 196,
    }
    listed = run.json("info box-1-wall --modes")
    assert [len(listed[key]) for key in ("contacting_separating", "sliding_sticking")] == [10, 196]
    assert listed["sliding_sticking"][0] == {
        "signs": [[0, 0]] * 4,
        "dimension": 0,
        "motion": [0] * 6,
    }
    assert len(run("info box-1-wall --modes").splitlines()) == 2 + 10 + 196


def test_modes_are_printed_with_largest_entry_one(run):
    rows = re.findall(
        r"\(([-0-9/, ]+)\)$", run("info three-fingers-on-a-ball --modes"), re.MULTILINE
    )
    sizes = {max(abs(Fraction(x)) for x in row.split(", ")) for row in rows}
    assert sizes == {0, 1}
