"""Single planes with names, colours and dashes: in values, files, views, pages and commands."""

import copy
import json
import pickle

import pytest

from arrangement import Arrangement, InputError, counts, read_arrangement
from arrangement.pictures import draw_cells, draw_lattice, draw_lines, draw_planes, draw_sphere
from arrangement.pictures.lab.arrangement_page import arrangement_page
from arrangement.pictures.looks import DASHES, Look, read_looks, read_names

LINES = Arrangement([[1, 0], [0, 1], [1, 1], [2, 0]], [0, 0, 1, 0], names=["ell", "", "n", ""])
BRAID = read_arrangement("braid-a3")


def named(scene):
    return {item.name: item for item in scene.items if item.name}


def texts(scene):
    return {item.text: item for item in scene.items if hasattr(item, "text")}


class TestValues:
    def test_names_are_labels_which_no_comparison_sees(self):
        other = LINES.named({1: "a"})
        assert (LINES.names, other.names) == (("ell", "", "n", ""), ("a", "", "", ""))
        assert LINES == other == LINES.named([])
        assert LINES.named(()).names == ()

    def test_names_go_with_their_planes(self):
        assert copy.copy(LINES).names == pickle.loads(pickle.dumps(LINES)).names == LINES.names
        assert LINES[1:].names == ("", "n", "")
        assert counts.deletion(LINES, 1).names == ("ell", "n", "")

    def test_files_keep_names(self):
        document = json.loads(json.dumps(LINES.to_dict()))
        assert document["names"] == ["ell", "", "n", ""]
        assert read_arrangement(document).names == LINES.names
        assert "names" not in LINES.named([]).to_dict()

    def test_conversion_keeps_names_or_reports_that_they_are_lost(self, tmp_path, run):
        LINES.save(tmp_path / "lines.json")
        for form, lost in (("json", ""), ("sage", "names of planes")):
            document = run.json("convert {} --to", tmp_path / "lines.json", form)
            assert document["lost"].partition(";")[0] == lost

    @pytest.mark.parametrize(
        "names",
        [
            ["a"],
            {0: "a"},
            {5: "a"},
            {"1": "a"},
            {1: 2},
            {1: "a\nb"},
            {1: "3"},
            {1: "x" * 41},
            "ab",
            7,
        ],
    )
    def test_wrong_names_are_refused(self, names):
        with pytest.raises(InputError):
            LINES.named(names)

    def test_texts_of_options_are_read(self):
        assert read_names("1=ell, 3 = m x") == {1: "ell", 3: "m x"}
        looks = read_looks("ell=gold,2=#0af:dashed,n=:dotted", LINES)
        assert looks == {
            0: Look("#ffd700", ""),
            1: Look("#00aaff", "dashed"),
            2: Look("", "dotted"),
        }
        assert read_looks({1: "gold", "n": ":dotted"}, LINES) == {0: looks[0], 2: looks[2]}

    @pytest.mark.parametrize("text", ["1", "=a", "1=a,1=b", "x=a", ""])
    def test_wrong_texts_are_refused(self, text):
        with pytest.raises(InputError):
            LINES.named(read_names(text))
        with pytest.raises(InputError):
            read_looks(text, LINES)

    @pytest.mark.parametrize(
        "text", ["0=red", "5=red", "m=red", "1=reddish", "1=red:dash", "1=a b", "red", "red,gold"]
    )
    def test_wrong_colours_are_refused(self, text):
        with pytest.raises(InputError):
            read_looks(text, LINES)

    def test_one_for_each_plane_needs_no_numbers(self):
        looks = read_looks("1=red,2=gold,3=:dotted,4=blue", LINES)
        assert read_looks("red, gold,:dotted,blue", LINES) == looks
        assert read_looks(["red", "gold", ":dotted", "blue"], LINES) == looks
        assert LINES.named(read_names("a, b,,d")).names == ("a", "b", "", "d")


class TestPictures:
    def test_lines_have_names_colours_dashes_and_a_legend(self):
        scene = draw_lines.scene(LINES, colours="ell=#d55e00,2=:dashed,n=navy:dotted")
        items, labels = named(scene), texts(scene)
        assert {"ell,4", "2", "n"} <= labels.keys()
        assert items["line-1"].style["ec"] == "#d55e00"
        assert items["line-2"].style["ec"] == "black"
        assert items["line-2"].style["ls"] == DASHES["dashed"]
        assert (items["line-3"].style["ec"], items["line-3"].style["ls"]) == (
            "#000080", DASHES["dotted"],
        )  # fmt: skip
        assert labels["n"].style["color"] == "#000080"
        assert labels["2"].style.get("color", "black") == "black"
        keys = {key.text: key.symbol[0].style for key in scene.legend.keys}
        assert keys["ell,4"]["ec"] == "#d55e00"
        assert keys["2"]["ls"] == DASHES["dashed"]

    def test_without_colours_nothing_changes_but_names(self):
        plain, other = draw_lines.scene(LINES.named([])), draw_lines.scene(LINES)
        assert [x.style for x in plain.items] == [x.style for x in other.items]
        assert [k.text for k in plain.legend.keys] == [k.text for k in other.legend.keys]

    def test_labels_may_be_true_or_false(self):
        plain = [texts(draw_lines.scene(LINES, labels=kind)) for kind in (True, False)]
        usual = [texts(draw_lines.scene(LINES, labels=kind)) for kind in (None, "none")]
        assert [x.keys() for x in plain] == [x.keys() for x in usual]
        assert plain[0].keys() != plain[1].keys()

    def test_coincident_planes_have_the_look_of_the_first(self):
        scene = draw_lines.scene(LINES, colours={4: "gold"})
        assert named(scene)["line-1"].style["ec"] == "#ffd700"
        scene = draw_lines.scene(LINES, colours={4: "gold", 1: "navy"})
        assert named(scene)["line-1"].style["ec"] == "#000080"

    def test_hidden_halves_of_circles_stay_dashed(self):
        scene = draw_sphere.scene(BRAID, names="1=ell", colours="ell=gold:dotted")
        usual = named(draw_sphere.scene(BRAID))
        items = named(scene)
        assert items["back-1"].style["ls"] == usual["back-1"].style["ls"]
        assert items["back-1"].style["ec"] == "#ffd700"
        fronts = [x for name, x in items.items() if name.startswith("front-1-")]
        assert fronts
        assert all(x.style["ls"] == DASHES["dotted"] for x in fronts)
        assert items["back-2"].style == usual["back-2"].style
        assert "ell" in texts(scene)

    def test_facets_are_filled(self):
        scene = draw_planes.scene(BRAID, names={2: "m"}, colours={"m": "gold"})
        facets = {n: x for n, x in named(scene).items() if n.startswith("facet-")}
        assert {x.style["fc"] for n, x in facets.items() if n.endswith("-plane-2")} == {"#ffd700"}
        assert "#ffd700" not in {x.style["fc"] for n, x in facets.items() if n[-1] != "2"}
        assert texts(scene)["m"].style["plate"]["fc"] == "#ffd700"

    def test_every_view_of_planes_takes_names_and_colours(self):
        for view in ("sphere", "stereographic", "gnomonic", "dual", "graph", "planes", "cells"):
            figure = BRAID.draw(view, names="1=ell", colours="ell=gold")
            assert "ell" in {key.text for key in figure.scene.legend.keys}, view

    def test_names_of_planes_in_other_spaces_and_coordinates(self):
        braid = Arrangement([[1, -1, 0], [1, 0, -1], [0, 1, -1]], names=["a", "b", "c"])
        assert {"a", "b", "c"} <= texts(draw_lines.scene(braid)).keys()
        assert {"a", "b"} <= texts(draw_sphere.scene(braid, coordinates="even")).keys()
        assert any("a" in text for text in texts(draw_lattice.scene(braid)))
        assert draw_cells.scene(BRAID, names={1: "ell"})

    def test_formula_that_is_none_is_refused(self):
        with pytest.raises(InputError, match="not a formula"):
            draw_lines.scene(LINES, names={1: r"$\foo$"})


class TestCommand:
    @pytest.mark.parametrize("ending", ["svg", "pdf", "tex", "html"])
    def test_each_kind_of_file_takes_names_and_colours(self, tmp_path, ending, run):
        path = tmp_path / f"x.{ending}"
        options = ["--names", "1=ell", "--colours", "ell=#123456"]
        run("draw braid-a3 -o", path, *options)
        text = path.read_bytes()
        if ending in ("svg", "html"):
            assert b"#123456" in text
        if ending in ("tex", "html"):
            assert b"ell" in text

    def test_names_of_views_that_have_no_colours(self, tmp_path, run, refused):
        path = str(tmp_path / "x.svg")
        for view in ("lattice", "poset"):
            command = ["draw", "braid-a3", "--view", view, "-o", path, "--names", "1=ell"]
            run(*command)
        assert "no option" in refused(*command[:-2], "--colours", "1=red")

    def test_names_of_a_file_are_drawn(self, tmp_path, run):
        LINES.save(tmp_path / "lines.json")
        path = tmp_path / "x.tex"
        view = ["--view", "lines", "--colours", "n=:dashed"]
        run("draw {} -o", tmp_path / "lines.json", path, *view)
        assert "ell" in path.read_text()

    def test_page_has_names_and_colours(self):
        page = arrangement_page(BRAID.named({1: "ell"}), colours="ell=gold")
        data = json.loads(page.split('id="data"')[1].split(">", 1)[1].split("</script>")[0])
        assert data["names"][0] == "ell"
        assert data["tints"] == {"0": "#ffd700"}
