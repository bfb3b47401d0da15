"""TeX's complaints, in an instructor's words: which paper, which question, which line."""

from __future__ import annotations

from kinegrade.language.lines import shorten
from kinegrade.language.message import Fault, Location, Message, Quoted
from kinegrade.press.latex.xetex import Outcome
from kinegrade.press.protocol import unprintable_character

_PLACE = "%% "  # begins the comment lines of a source that say what follows


def find_faults(outcome: Outcome, source: str, where: Location) -> tuple[Fault, ...]:
    """A line for the fault of a run, or for each character that no font printed; `where` if nothing
    nearer is known.
    """
    lines = source.split("\n")
    if outcome.fault is None:
        return tuple(
            _describe_unprinted(character, lines, where) for character in sorted(outcome.missing)
        )
    complaint = Message("typesetting.tex", complaint=outcome.fault.message)
    number = outcome.fault.line
    if number is None or number > len(lines):
        return (Fault(where, complaint, Message("typesetting.latex"), Message("typesetting.fix")),)
    offending = shorten(lines[number - 1].strip())
    return (
        Fault(
            _find_place(lines, number, where),
            Message("typesetting.in-line", complaint=complaint, line=Quoted(offending)),
            Message("typesetting.math"),
            Message("typesetting.fix-template"),
        ),
    )


def _describe_unprinted(character: str, lines: list[str], where: Location) -> Fault:
    numbers = (
        number
        for number, line in enumerate(lines, start=1)
        if character in line and not line.startswith(_PLACE)
    )
    place = _find_place(lines, next(numbers, 0), where)
    return unprintable_character(place, character)


def _find_place(lines: list[str], number: int, where: Location) -> Location:
    """What the last comment before a line says."""
    before = (line for line in reversed(lines[:number]) if line.startswith(_PLACE))
    return next((line.removeprefix(_PLACE).removesuffix("%") for line in before), where)
