"""The directives command-table and command-help: parsers of the programs.

The argument of command-table is a program: shown is a table of its commands, with links to their
pages in the folder commands.
The argument of command-help is a program and a command, ``arrangement count``: shown is what it
does, its exit codes, and its arguments and options, but for those of all commands.
"""

import argparse
import importlib

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

PROGRAMS = {
    "arrangement": "arrangement.cli",
    "equilibrium": "equilibrium.cli.program",
    "proofs-check": "proofs_check.cli.program",
}
#: Options of all commands, which the page explains once.
COMMON = ("help", "json", "limit", "traceback", "exact", "digits")


def parser_of(program):
    """Return the parser of a program."""
    return importlib.import_module(PROGRAMS[program])._parser()


def _actions(parser):
    """Return the arguments and options of a parser, with those that are added when it parses."""
    parser.add_lazy_options()
    return parser._actions


def commands_of(parser):
    """Return the subcommands of a parser by name."""
    listed = (x for x in _actions(parser) if isinstance(x, argparse._SubParsersAction))
    return {name: command for action in listed for name, command in action.choices.items()}


def _entries(parser):
    """Yield arguments and options in words, each with its help."""
    formatter = parser._get_formatter()
    for action in _actions(parser):
        shown = action.help != argparse.SUPPRESS and action.dest not in COMMON
        if shown and not isinstance(action, argparse._SubParsersAction):
            words = formatter._format_action_invocation(action)
            yield words, formatter._expand_help(action) if action.help else ""


def _definitions(parser):
    found = nodes.definition_list(classes=["options"])
    for words, text in _entries(parser):
        term = nodes.term("", "", nodes.literal("", words))
        body = nodes.definition("", nodes.paragraph("", text))
        found += nodes.definition_list_item("", term, body)
    return found


class CommandHelp(SphinxDirective):
    required_arguments = 2

    def run(self):
        program, name = self.arguments
        command = commands_of(parser_of(program))[name]
        kinds = commands_of(command)
        text = command.description.partition("\n\n")[0]
        codes = command.epilog.rpartition("\n\n")[2]
        made = [nodes.paragraph("", f"{text} {codes}"), _definitions(command)]
        for kind, parser in kinds.items():
            words = nodes.literal("", f"{program} {name} {kind}")
            about = nodes.inline("", f": {parser.description}")
            made += [nodes.paragraph("", "", words, about), _definitions(parser)]
        return made


class CommandTable(SphinxDirective):
    required_arguments = 1

    def run(self):
        (program,) = self.arguments
        pages = {name: f"/commands/{program}-{name}" for name in commands_of(parser_of(program))}
        lines = [".. list-table::", "   :widths: 18 82", "   :width: 100%", ""]
        for name, command in commands_of(parser_of(program)).items():
            about = command.description.partition("\n\n")[0]
            lines += [f"   * - :doc:`{name} <{pages[name]}>`", f"     - {about}"]
        lines += ["", ".. toctree::", "   :hidden:", "", *(f"   {page}" for page in pages.values())]
        return self.parse_text_to_nodes("\n".join(lines))


def setup(app):
    app.add_directive("command-table", CommandTable)
    app.add_directive("command-help", CommandHelp)
