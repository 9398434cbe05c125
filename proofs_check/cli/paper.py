"""The command paper: every figure and table of the paper beside what is printed."""

from __future__ import annotations

import argparse
from pathlib import Path

from arrangement.console import terminal
from proofs_check.claims import paper
from proofs_check.reports.paper.page import PAGE, document, file_names, write_paper
from proofs_check.reports.paper.tables import TABLES, measured_times, stored_times


def run_paper(arguments: argparse.Namespace) -> int:
    """Write the page and the single files into a folder."""
    times = measured_times() if arguments.measure else stored_times()
    write_paper(arguments.output, times, paper())
    if arguments.json:
        contents = ((table, table.content(times)) for table in TABLES)
        terminal.print_json(document(contents, arguments.output))
    else:
        page = Path(arguments.output) / PAGE
        print(f"{page} and {len(file_names()) - 1} single files are written")
    return terminal.YES
