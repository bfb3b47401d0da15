"""What was read of a file of marks by hand, and which newer marks take the place of some of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from kinegrade.ask_names import Named
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.hand_marks import HandMark

GIVE_NEW = Message("marking.give-new")  # as what is carried over stands in a folder of marks


@dataclass(frozen=True, slots=True)
class HandRow:
    """A mark and where it stands; it was `carried` over from an earlier marking, or given now."""

    mark: HandMark
    where: str
    carried: bool


@dataclass(frozen=True, slots=True)
class Newer:
    """The `points` that are given now, by student and what they are for."""

    points: Mapping[tuple[str, str], Fraction]

    def replaces(self, student: str, named: Named) -> bool:
        """Whether any are for the same, or for the question as a whole of which that is a part."""
        return (student, named.column) in self.points or (student, named.question) in self.points


@dataclass
class HandFile:
    """What was read of one file: its marks, how many rows have none yet, what some of these say by
    student and question, the marks of what the policy `dropped` and of questions that the paper
    does `not_held`, how many were `replaced` by others, which ids are not as in the exam, how many
    `followed` a paper to another student than they were given to, and what is wrong.
    """

    rows: list[HandRow] = field(default_factory=list)
    unmarked: int = 0
    comments: dict[tuple[str, str], str] = field(default_factory=dict)
    dropped: list[HandRow] = field(default_factory=list)
    not_held: list[HandRow] = field(default_factory=list)
    replaced: int = 0
    restored: Mapping[str, str] = field(default_factory=dict)
    followed: int = 0
    faults: list[Fault] = field(default_factory=list)

    @property
    def left_out(self) -> tuple[HandRow, ...]:
        """The marks that do not count, and are kept."""
        return (*self.dropped, *self.not_held)
