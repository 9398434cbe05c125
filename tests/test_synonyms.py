"""Names of other programs: each target runs, and unknown attributes are answered with it."""

import doctest
import math

import pytest

import equilibrium
from arrangement import Arrangement, counts, families, synonyms
from equilibrium import ResistedSet, read_grasp, solve
from equilibrium.model.synonyms import NAMES, STATICS

LINES = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])


def run(expression: str, **names: object) -> None:
    """Run an expression as a documentation test, which shows its value only if it raises."""
    example = doctest.DocTestParser().get_doctest(
        f">>> value = {expression}\n", names, expression, None, 0
    )
    doctest.DebugRunner().run(example, clear_globs=False)
    assert "value" in example.globs


@pytest.mark.parametrize("planes", [LINES, families.braid(3)], ids=["affine", "central"])
@pytest.mark.parametrize("program", synonyms.ARRANGEMENT)
def test_names_for_arrangements_run(program, planes):
    regions = planes.regions()
    names = {
        "A": planes,
        "B": planes[:1],
        "counts": counts,
        "i": 1,
        "normal": [1] * planes.dimension,
        "offset": 0,
        "point": regions[0].witness,
        "r": regions[0],
        "s": regions[1],
    }
    for word, name in synonyms.ARRANGEMENT[program].items():
        assert word not in dir(planes), f"{word} is there"
        run(name.replace("A.dual", "A.dual" if planes.is_central else "A.cone().dual"), **names)
        with pytest.raises(AttributeError) as error:
            getattr(planes, word)
        assert str(error.value).endswith(f"; use {name}")


def test_one_name_means_one_thing():
    rows = [row for words in synonyms.ARRANGEMENT.values() for row in words.items()]
    known = {word.lower(): name for word, name in rows}
    for word, name in rows:
        assert known[word.lower()] == name, word


@pytest.mark.parametrize("name", ["zon", "unbounded_face_list", "cut"])
def test_names_that_are_only_alike_get_no_hint(name):
    with pytest.raises(AttributeError, match=f"'{name}'$"):
        getattr(LINES, name)


GRASP, LOAD = read_grasp("paper-four-contacts-preload-1"), [0, "1/2", 0]


@pytest.mark.parametrize("subject", STATICS)
def test_words_of_statics_run(subject):
    pytest.importorskip("matplotlib")
    names = {name: getattr(equilibrium, name) for name in dir(equilibrium)}
    for name in STATICS[subject].values():
        run(name, **names, G=GRASP, w=LOAD, math=math)


@pytest.mark.parametrize(
    "value", [GRASP, solve(GRASP, LOAD), ResistedSet(GRASP)], ids=["G", "v", "R"]
)
def test_words_of_statics_are_answered(value):
    for word, name in NAMES.items():
        if word not in dir(value):
            with pytest.raises(AttributeError) as error:
                getattr(value, word)
            hint = str(error.value).partition("; use ")[2]
            assert name.endswith(hint or "nothing")
