"""TeX's complaints, in an instructor's words: which paper, which question, which line."""

from __future__ import annotations

from kinegrade.errors import short_line
from kinegrade.exam.latex_run import Outcome

PLACE = "%% "  # begins the comment lines of a source that say what follows


def faults(outcome: Outcome, source: str, where: str) -> tuple[str, ...]:
    """A line for the fault of a run, or for each character that no font printed; `where` if nothing
    nearer is known.
    """
    lines = source.split("\n")
    if outcome.fault is None:
        return tuple(_unprinted(character, lines, where) for character in sorted(outcome.missing))
    message, number = outcome.fault.message, outcome.fault.line
    if number is None or number > len(lines):
        return (f"{where}: TeX: {message}; expected LaTeX that can be typeset; fix the formulas",)
    offending = short_line(lines[number - 1].strip())
    return (
        f'{_place(lines, number, where)}: TeX: {message} in line "{offending}"; expected math that '
        "can be typeset;"
        " fix the formula in the template",
    )


def _unprinted(character: str, lines: list[str], where: str) -> str:
    numbers = (
        number
        for number, line in enumerate(lines, start=1)
        if character in line and not line.startswith(PLACE)
    )
    place = _place(lines, next(numbers, 0), where)
    return (
        f"{place}: no font prints {character} (U+{ord(character):04X}); expected Latin, Greek, "
        "Cyrillic or Chinese; write it otherwise"
    )


def _place(lines: list[str], number: int, where: str) -> str:
    """What the last comment before a line says."""
    before = (line for line in reversed(lines[:number]) if line.startswith(PLACE))
    return next((line.removeprefix(PLACE).removesuffix("%") for line in before), where)
