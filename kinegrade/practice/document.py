"""A practice sheet as its page bakes it: what all draws of a question share, and what is of each.

Fields are shown to the script of the page under their names; what a draw has is kept in short
tuples, because there are many.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.practice.patterns import Line, Pattern
from kinegrade.practice.poses import PracticeMotion
from kinegrade.practice.skeleton import PracticeSkeleton
from kinegrade.sign_conventions import Convention


@dataclass(frozen=True)
class PracticeRule:
    """How far from right an answer may be: `relative` to it, or `absolute` in its unit, or to so
    many significant `figures`, whatever gives more room.
    """

    relative: float
    absolute: float
    figures: int | None


@dataclass(frozen=True)
class PracticeAsk:
    """What is asked for in every draw; `label` and `shown` (the unit) are HTML.

    `period` is a full turn of an angle that is right with any number of turns, else 0; no ask
    depends on one of a later `stage`; `mistakes` are labels of those known in any draw, `credits`
    the shares of the points that the bank gives for them.
    """

    name: str
    label: str
    unit: str
    shown: str
    convention: Convention | None
    sign: str
    points: float
    period: float
    stage: int = 0
    mistakes: tuple[str, ...] = ()
    credits: tuple[float, ...] = ()


# The right answer to 12 digits, the place of its rule, and for each mistake what it leads to as a
# multiple of the right answer (of 1, where that is zero), "" where it changes nothing
PracticeKey = tuple[str, int, str]


@dataclass(frozen=True)
class PracticeDraw:
    """The instance of a question with one set of numbers; `texts` are the statement, the figure,
    for each ask how far it may be off, and the parts of the worked solution. `follows` has the
    places of two asks, and what follows for the second from a value of the first: the coefficients
    of its powers 0, 1 and 2, with an "r" where it is the root of their sum; and those with a third,
    with whose right answer something else follows. `motion` is None for what cannot move.
    """

    texts: tuple[tuple[Line, ...], ...]
    keys: tuple[PracticeKey, ...]
    follows: tuple[str, ...]
    motion: PracticeMotion | None


@dataclass(frozen=True)
class PracticeQuestion:
    """A question with all its draws; `title` is HTML. `skeleton` is that of their motions, None
    where nothing moves; `followed` are the places of the asks that these have curves of.
    """

    title: str
    asks: tuple[PracticeAsk, ...]
    rules: tuple[PracticeRule, ...]
    patterns: tuple[Pattern, ...]
    draws: tuple[PracticeDraw, ...]
    skeleton: PracticeSkeleton | None
    followed: tuple[int, ...]


@dataclass(frozen=True)
class PracticeSheet:
    """All of a sheet; `course` is plain, the `rules` HTML, `mistakes` plain sentences by
    identifier.
    """

    title: str
    course: str
    rules: tuple[str, ...]
    mistakes: dict[str, str]
    questions: tuple[PracticeQuestion, ...]
