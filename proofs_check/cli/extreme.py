"""The command that prints the extreme values of a quantity, with an example of each."""

from __future__ import annotations

import argparse
from pathlib import Path

from arrangement.console import terminal
from arrangement.console.writing import document_text, make_folder, write_text_atomically
from proofs_check.instances.domains import domain
from proofs_check.own_claims.extreme import extremes
from proofs_check.reports.report import plain
from proofs_check.reports.text import value_text


def run_extreme(arguments: argparse.Namespace) -> int:
    """Print the extreme value for each number of lines or planes, as soon as it is known."""
    what, unit = "smallest" if arguments.smallest else "largest", domain(arguments.of).unit
    results = extremes(
        arguments.quantity,
        arguments.of,
        *arguments.classes,
        largest=not arguments.smallest,
        when=arguments.when,
    )
    records: list[dict[str, object]] = []
    condition = f", {arguments.when}" if arguments.when else ""
    for extreme in results:
        if arguments.save is not None:
            make_folder(arguments.save)
            path = Path(arguments.save, f"{what}-{extreme.elements}.json")
            write_text_atomically(path, document_text(dict(extreme.example.document or {})))
        if not records and not arguments.json:
            print(f"{what} {arguments.quantity} of {arguments.of}{condition}: all classes")
            print(f"{unit:>6}  value  reached by           example")
        records.append(
            {
                "elements": extreme.elements,
                "value": plain(extreme.value),
                "reached_by": extreme.reached,
                "classes": extreme.classes,
                "label": extreme.example.label,
                "example": extreme.example.document,
            }
        )
        if not arguments.json:
            share = f"{extreme.reached:,} of {extreme.classes:,}"
            value = value_text(plain(extreme.value))
            example = "; ".join(map(str, extreme.example.subject))
            print(f"{extreme.elements:>6}  {value:>5}  {share:<19}  {example}")
    if arguments.json:
        terminal.print_json(
            {"quantity": arguments.quantity, "of": arguments.of, "extreme": what, "values": records}
        )
    elif not records:
        print(f"no class of {arguments.of} obeys: {arguments.when}")
    return terminal.YES if records else terminal.NO
