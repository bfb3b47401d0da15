"""What a person gave, in an explanation of marks: in place of the machine's points, or beside
them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Message, Part, list_statements
from kinegrade.language.terminal_lines import align
from kinegrade.marks_folder.hand_marks import EXTRA, HandMark
from kinegrade.numbers.amounts import write_amount

_INDENT = "  "


def write_hand_marks(marks: Iterable[HandMark], words: Catalogue) -> Iterator[str]:
    """A heading and a line for each mark; nothing where there are none."""
    rows = [
        (_INDENT, mark.column, words.write(list_statements(list(_describe(mark)))))
        for mark in marks
    ]
    if rows:
        yield ""
        yield words.text("explain.by-hand")
        yield from align(rows[0], rows[1:]).splitlines()


def _describe(mark: HandMark) -> Iterator[Part]:
    """The points, what the machine gave there, and the reason."""
    points = write_amount(mark.points)
    if mark.question == EXTRA or mark.out_of is None:
        yield Message("explain.on-top", points=points)
    else:
        yield Message("explain.of", points=points, out_of=write_amount(mark.out_of))
    if mark.is_override and mark.machine is not None:
        yield Message("explain.in-place-of", points=write_amount(mark.machine))
    if mark.comment:
        yield show_in_one_line(mark.comment)
