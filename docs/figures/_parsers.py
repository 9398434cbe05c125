"""The parsers of the three commands, with the options that they add only when asked for help."""

import argparse

from arrangement import cli as arrangement_cli
from equilibrium.cli import program as equilibrium_cli
from proofs_check.cli import program as proofs_check_cli


def _whole(parser):
    lazy_options, parser.lazy_options = parser.lazy_options, None
    if lazy_options is not None:
        lazy_options()
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for child in action.choices.values():
                _whole(child)
    return parser


def arrangement():
    return _whole(arrangement_cli._parser())


def equilibrium():
    return _whole(equilibrium_cli._parser())


def proofs_check():
    return _whole(proofs_check_cli._parser())
