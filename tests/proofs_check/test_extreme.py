"""Extreme values over all isomorphism classes, against published ones and against brute force."""

import pytest

from arrangement import Arrangement, counts, read_arrangement
from arrangement.library.census import census, lines
from proofs_check.errors import OwnClaimError
from proofs_check.own_claims.extreme import extremes


def values(text, of, low, high, **options):
    return [one.value for one in extremes(text, of, low, high, **options)]


def test_published_extremes_of_lines_are_met():
    """Kobon's triangles (OEIS A006066); fewest points on two of m lines, not a pencil (A003034)."""
    assert values("bounded_p_vector.get(3, 0)", "lines", 3, 5) == [1, 2, 5]
    assert values("bounded_p_vector.get(3, 0)", "simple-lines", 3, 7) == [1, 2, 5, 7, 11]
    assert values("t_vector.get(2, 0)", "rank-3", 3, 7, largest=False) == [3, 3, 4, 3, 3]


def test_fewest_regions_are_those_of_a_near_pencil():
    found = [*extremes("regions", "rank-3", 3, 6, largest=False)]
    assert [one.value for one in found] == [4 * (m - 1) for m in range(3, 7)]
    assert [one.reached for one in found] == [1] * 4
    assert [one.classes for one in found] == [1, 2, 4, 17]
    for one in found:
        assert counts.t_vector(one.example.subject)[2] >= one.elements - 1


@pytest.mark.parametrize("largest", [True, False])
def test_extremes_are_those_of_a_plain_loop(largest):
    pick = max if largest else min
    for m in (3, 4, 5):
        every = [len(planes.regions()) for planes in lines(m)]
        (found,) = extremes("regions", "lines", m, m, largest=largest)
        assert (found.value, found.classes) == (pick(every), len(every))
        assert found.reached == every.count(pick(every))
        assert len(found.example.subject.regions()) == found.value


def test_hypothesis_leaves_classes_out():
    every = [planes for planes in census(5) if planes.is_simplicial]
    (found,) = extremes("regions", "rank-3", 5, 5, when="simplicial")
    assert found.classes == found.reached == len(every) == 1
    assert [*extremes("regions", "lines", 3, 4, when="regions > 99")] == []


@pytest.mark.parametrize(
    ("text", "of", "low", "high", "match"),
    [
        ("regions", "grasp", 3, 4, "lines or planes"),
        ("regions", "pseudolines", 3, 4, "lines or planes"),
        ("regions", "lines", 3, 9, "expected numbers of lines"),
        ("regions", "lines", 5, 4, "expected numbers of lines"),
        ("polynomial", "lines", 3, 3, "not a number"),
        ("simple", "lines", 3, 3, "not a number"),
        ("__import__", "lines", 3, 3, "__import__"),
    ],
)
def test_what_has_no_extreme_is_refused(text, of, low, high, match):
    with pytest.raises(OwnClaimError, match=match):
        list(extremes(text, of, low, high))


def test_command_prints_and_saves_examples(tmp_path, run):
    options = ["--of", "lines", "--classes", "3..4", "--save", str(tmp_path / "made")]
    lines = run("extreme bounded_regions", *options).splitlines()
    assert lines[0] == "largest bounded_regions of lines: all classes"
    assert lines[2].split()[:5] == ["3", "1", "1", "of", "4"]
    saved = read_arrangement(tmp_path / "made" / "largest-4.json")
    assert isinstance(saved, Arrangement)
    assert len(saved.bounded_regions()) == 3
    made = run.json("extreme bounded_regions", *options[:4], "--smallest")
    assert [one["value"] for one in made["values"]] == [0, 0]
    assert read_arrangement(made["values"][0]["example"]).bounded_region_count() == 0


def test_command_reports_that_no_class_is_left(run):
    words = ["extreme", "regions", "--of", "lines", "--classes", "3", "--when", "regions > 9"]
    assert run(*words, code=1) == "no class of lines obeys: regions > 9\n"
    assert run("extreme regions --of lines --classes 3..10", code=2) == ""


def test_folder_that_cannot_be_written_is_refused_before_results(tmp_path, run):
    (tmp_path / "file").write_text("")
    words = ["extreme", "regions", "--of", "lines", "--classes", "3..4"]
    out, err = run(*words, "--save", tmp_path / "file" / "folder", code=2), run.err
    assert (out, err.count("\n")) == ("", 1)
    assert "cannot write" in err
