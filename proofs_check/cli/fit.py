"""The command that says what a sequence of values is."""

from __future__ import annotations

import argparse

from arrangement.console import terminal
from proofs_check.errors import OwnClaimError
from proofs_check.instances.families import span
from proofs_check.own_claims import claim_file
from proofs_check.own_claims.fit import (
    LEAST_CHECKED,
    MOST_PERIOD,
    fit,
    values_of_claim,
    values_of_text,
)
from proofs_check.reports.report import plain
from proofs_check.reports.text import table, value_text

from .listing import width


def run_fit(arguments: argparse.Namespace) -> int:
    """Print the values of a quantity on a family, and the polynomial that they fit."""
    named, of = arguments.quantity, arguments.of
    if claim_file.split(named)[0]:
        claims = claim_file.claims_named(named)
        if of or len(claims) > 1:
            raise OwnClaimError(
                f"{named}: name one claim after a colon, and its family in the file, not by --of"
            )
        values = values_of_claim(claims[0])
    elif of:
        values = values_of_text(named, of)
    else:
        raise OwnClaimError(
            "the instances are missing; give --of 'generic(m=2..9)', or give FILE.py:ID"
        )
    formula = fit(values.found, values.name)
    if arguments.json:
        terminal.print_json(
            {
                "quantity": values.quantity,
                "family": values.family,
                "parameter": values.name,
                "values": [[n, plain(value)] for n, value in values.found.items()],
                "fit": formula
                and {
                    "period": formula.period,
                    "degree": formula.degree,
                    "formulas": [{"class": k, "formula": x} for k, x in formula.parts.items()],
                    "fitted_on": list(formula.fitted),
                    "checked_on": list(formula.checked),
                },
            }
        )
        return terminal.YES if formula else terminal.NO
    name = values.name
    rows = [("values", ", ".join(value_text(plain(value)) for value in values.found.values()))]
    if formula:
        made, checked = span(formula.fitted, ", "), span(formula.checked, ", ")
        rows.append(("fits", f"{formula.text(name)} on {name} = {made}, checked on {checked}"))
        rows.append(("proved", "no"))
    else:
        rows.append(
            (
                "fits",
                f"no polynomial, nor quasi-polynomial of period up to {MOST_PERIOD}, that "
                f"leaves {LEAST_CHECKED} values to check it",
            )
        )
    print(f"{values.quantity} on {values.family}")
    print("\n".join(table(rows, width(), "  ")))
    return terminal.YES if formula else terminal.NO
