"""The checker of certificates about assemblies: no solver, no floats.

The law is that of one body, in R^(3b): a contact has its rows in the numbers of body_a, and their
negatives in those of body_b, so "resisted" is checked like that of a grasp. "not resisted" is a
tree of contact states with the rule of `equilibrium.certificate.leaf_rule`; its leaves have virtual
motions for some bodies, 0 for the others. At the root the tree may instead be one of a *part*:
bodies S that touch the rest at contacts of one body in S with one outside, or with the ground.
Their balances add up to one in which only these contacts are left, and the law of these depends on
the motion of the one body relative to the other alone: so a planar proof about them and the whole
load of S will do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, shown
from equilibrium.model.assembly import SIZE
from equilibrium.model.errors import CertificateError

from .law import LawRow
from .leaf_rule import TreeQuestion
from .reading import FORMS, TreeForm, read_index
from .report import Report
from .tree import tree_report


def part_report(
    tree: Mapping[str, Any],
    bodies: Sequence[tuple[str, str | None]],
    rows: Sequence[LawRow],
    wrenches: Mapping[str, Sequence[Any]],
    form: TreeForm = FORMS[2],
    max_displacement: Fraction | None = None,
) -> Report:
    """Check a planar proof about the contacts of a part of an assembly with the rest.

    Args:
        bodies: body_a and body_b of each contact.
        rows: of the contacts, each in the numbers of its body_a alone.
        wrenches: the load of each body.
        form: of the planar tree.
    """
    check_keys(tree, ("part", "contacts", "tree"), (), "tree")
    part = check_list(tree["part"], "tree.part")
    for name in part:
        if not isinstance(name, str) or name not in wrenches:
            raise CertificateError(f"tree.part has {shown(name)}; expected names of bodies")
    listed = check_list(tree["contacts"], "tree.contacts")
    places = [read_index(i, f"tree.contacts[{k}]", len(bodies)) for k, i in enumerate(listed)]
    inside = set(part)
    crossing = [i for i, (a, b) in enumerate(bodies) if (a in inside) != (b in inside)]
    if sorted(places) != crossing or len(part) != len(inside):
        due = ", ".join(map(str, crossing))
        problem = f"tree.contacts: the contacts of the part with the rest are [{due}], each once"
        return Report("not resisted", problem)
    # A contact seen from its other body has the negatives of its rows.
    turned = [rows[i] if bodies[i][0] in inside else _opposite(rows[i]) for i in places]
    zero: RationalVector = (Fraction(0),) * SIZE
    columns = zip(zero, *(wrenches[name] for name in part), strict=True)
    load = tuple(sum(column) for column in columns)
    question = TreeQuestion(turned, load, form, max_displacement=max_displacement)
    report = tree_report(tree["tree"], question)
    if len({frozenset(bodies[i]) for i in places}) > 1:
        problem = "tree.part: it touches the rest at more than one pair of bodies"
        return replace(report, problem=problem)
    return replace(report, problem=report.problem and f"tree.{report.problem}")


def _opposite(row: LawRow) -> LawRow:
    return row._replace(wrenches=tuple(tuple(-x for x in wrench) for wrench in row.wrenches))
