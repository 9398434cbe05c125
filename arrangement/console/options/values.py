"""Words of a command line as values: the ``type=`` of arguments."""

from __future__ import annotations

import argparse
import math
import re
from fractions import Fraction

from arrangement.errors import InputError
from arrangement.numbers.exact import rational, shown

#: Repetitions of a task in one command, at most.
MAX_COUNT = 1_000_000
_WITH_UNIT = re.compile(r"[-+]?[0-9./]+ ?[A-Za-z]+")


def rational_argument(text: str) -> Fraction:
    """Read an exact number from the command line (the ``type=`` of an argument)."""
    if _WITH_UNIT.fullmatch(text):
        raise argparse.ArgumentTypeError(
            f"{shown(text)} has a unit; write the number alone: lengths and forces are in the "
            "units of the grasp, times in seconds (lengths on paper may have units)"
        )
    try:
        return rational(text, "value")
    except InputError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def count_argument(text: str) -> int:
    """Read a number of things to do, one after the other, or a seed."""
    if re.fullmatch(r"[0-9]{1,9}", text, re.ASCII) is None or int(text) > MAX_COUNT:
        raise argparse.ArgumentTypeError(
            f"{shown(text)} is not a whole number from 0 to {MAX_COUNT}; more takes days"
        )
    return int(text)


def integer_argument(text: str) -> int:
    """Read a whole number of ordinary size, such as a dimension or a seed."""
    if re.fullmatch(r"-?[0-9]{1,18}", text, re.ASCII) is None:
        raise argparse.ArgumentTypeError(f"{shown(text)} is not a whole number of up to 18 digits")
    return int(text)


def length_argument(text: str) -> float:
    """Read a length on paper or of a model, which is not an exact number."""
    try:
        return float(rational_argument(text))
    except OverflowError:
        raise argparse.ArgumentTypeError(f"{shown(text)} is too long for paper") from None


def times_argument(text: str) -> float:
    """Read how many times the budget is allowed."""
    try:
        return float(rational_argument(text))
    except OverflowError:
        return math.inf


def seconds_argument(text: str) -> float:
    """Read a time limit, above 0."""
    seconds = times_argument(text)
    if seconds <= 0:
        raise argparse.ArgumentTypeError(f"{shown(text)} is not above 0; give a number of seconds")
    return seconds


def shard_argument(text: str) -> tuple[int, int]:
    """Read which part of a computation a machine does, such as 2/5."""
    match = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text, re.ASCII)
    if match is None or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a shard; write 2/5 for the second of five"
        )
    return int(match[1]), int(match[2])


def digits_argument(text: str) -> int:
    """Read how many digits of a number are printed."""
    if not text.isascii() or not text.isdigit() or not 1 <= int(text[:5]) <= 1000:
        raise argparse.ArgumentTypeError(f"{shown(text)} digits; give 1 to 1000")
    return int(text)
