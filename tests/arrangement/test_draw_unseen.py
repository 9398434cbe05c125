"""What a picture cannot show is reported: once, on stderr, in JSON and in the scene."""

import json

import pytest

from arrangement import Arrangement

pytest.importorskip("matplotlib")

#: The first two are a millionth apart.
LINES = Arrangement([(1, 1), (1000000, 1000000), (1, 0), (0, 1)], [1, 1000001, 0, 0])
PLANES = Arrangement([(1, 0, 0), (0, 1, 0), (1, 1, 1), (1000000, 1000001, 1000000)])
GIVEN = {"coordinates": "given"}


def texts(scene):
    return [item.text for item in scene.items if hasattr(item, "text")]


@pytest.mark.parametrize(
    ("arrangement", "view", "options", "joint", "items", "narrow"),
    [
        (LINES, "lines", {}, "1,2", "lines", 3),
        (LINES, "lines", {"projective": True}, "1,2", "lines", 3),
        (PLANES, "sphere", GIVEN, "3,4", "circles", 3),
        (PLANES, "stereographic", GIVEN, "3,4", "circles", 4),
        (PLANES, "gnomonic", GIVEN, "3,4", "lines", 3),
    ],
)
def test_lines_drawn_as_one_have_a_note_and_a_joint_label(
    arrangement, view, options, joint, items, narrow
):
    scene = arrangement.draw(view, **options).scene
    near, unseen = scene.legend.notes
    assert near == f"{items} {joint}: nearer than a line's width, drawn as one"
    assert unseen == f"{narrow} regions are narrower than a line and cannot be seen"
    # The legend says the same: its counts are of all regions.
    assert [text for text, _ in scene.legend.lines if text in (near, unseen)] == [near, unseen]
    written = texts(scene)
    assert joint in written
    assert not set(joint.split(",")) & set(written)


@pytest.mark.parametrize("first", [(1, 1, "1/1000"), (1, -1, 0)])
def test_line_that_the_window_cuts_short_is_not_drawn_as_one(first):
    """Its ends are near the other line, those of the other line are not near it."""
    rows = [first, *{(1, 1, "1/1000"), (1, -1, 0)} - {first}]
    lines = Arrangement([row[:2] for row in rows], [row[2] for row in rows])
    scene = lines.draw("lines", window=[(0, 0), (10, 10)]).scene
    assert not any("drawn as one" in note for note in scene.legend.notes)


def test_far_lines_have_no_note():
    triangle = Arrangement([(1, 1), (1, 0), (0, 1)], [1, 0, 0])
    assert triangle.draw("lines").scene.legend.notes == []
    # Symmetric coordinates, the usual ones, move the circles apart.
    assert PLANES.draw("sphere").scene.legend.notes == []


def test_command_notes_on_stderr_and_in_json(tmp_path, run):
    path, picture = tmp_path / "two.txt", str(tmp_path / "two.svg")
    path.write_text("1 1 | 1\n1 1 | 1000001/1000000\n1 0 | 0\n0 1 | 0\n", encoding="utf-8")
    out, err = run("draw {} -o {} --json", path, picture), run.err
    notes = json.loads(out)["notes"]
    assert err.splitlines() == notes
    assert notes[0].startswith("lines 1,2: nearer than a line's width")
    out, err = run("draw braid-a3 -o {} --json", picture), run.err
    assert "notes" not in json.loads(out)
    assert err == ""
