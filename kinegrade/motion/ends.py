"""Where a path ends, and what lies on it."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language.message import Message


@dataclass(frozen=True)
class Limit:
    """The input can go no further than `displacement`, rad or m since the instant: it turns back
    there, at a dead point; `line` says what is in line or at right angles, where that is known.
    """

    displacement: float
    line: Message | None


@dataclass(frozen=True)
class Receding:
    """A part is so far away at `displacement` that the path is cut off there."""

    displacement: float


@dataclass(frozen=True)
class Blocked:
    """Beyond `displacement` no position meets all conditions, of which some are redundant."""

    displacement: float


@dataclass(frozen=True)
class Open:
    """The input could go on beyond `displacement`, at which the path is cut off."""

    displacement: float


@dataclass(frozen=True)
class Closed:
    """The mechanism is again as at the instant, after so many full `turns` of its input."""

    displacement: float
    turns: int


@dataclass(frozen=True)
class ChangePoint:
    """A position in which the mechanism could also go on otherwise: links in line for which a
    second way begins. The path goes straight on.
    """

    displacement: float
    line: Message | None


End = Limit | Receding | Blocked | Open | Closed
