"""What the inputs of a template drive, so far as a statement can say it in words: the body or the
point, the way it goes, the givens that say how fast.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from typing import Literal

from flint import fmpq
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.expressions.tree import Expression, Name, Number, Operation, is_literal_zero
from kinegrade.problem.template.sentences import DriverSentence, find_axis
from kinegrade.sign_conventions import Convention

DrivenPart = Literal["turning", "moving"]
Path = Literal["turning", "circling", "moving"]


class Imposed(Struct, frozen=True):
    """A rate that is a given, or the given with a minus."""

    given: str
    turned: bool


class Driven(Struct, frozen=True):
    """A driven body or point: on which path, the sense of a positive rate, and its rates; the
    acceleration is None where the input states none.
    """

    path: Path
    positive: Convention
    velocity: Imposed
    acceleration: Imposed | None

    @property
    def givens(self) -> frozenset[str]:
        """The givens that say how fast it goes."""
        rates = (self.velocity, self.acceleration)
        return frozenset(rate.given for rate in rates if rate is not None)


Drives = Mapping[DrivenPart, Mapping[str, Driven]]


def drop_accelerations(drives: Drives) -> Drives:
    """What is driven, where nothing is said of accelerations."""
    return {
        part: {name: replace(driven, acceleration=None) for name, driven in named.items()}
        for part, named in drives.items()
    }


def find_driven(drivers: Iterable[DriverSentence], givens: Collection[str]) -> Drives:
    """What can be said of each body that turns and of each point that moves, by name.

    It can where the rates are givens, plain or with a minus, and a path is a circle or along an
    axis; not of what two inputs drive.
    """
    words: dict[DrivenPart, dict[str, Driven]] = {"turning": {}, "moving": {}}
    sentences = tuple(drivers)
    times = Counter(map(_name_driven, sentences))
    for sentence in sentences:
        part, name = driven = _name_driven(sentence)
        said = _read_driven(sentence, givens)
        if said is not None and times[driven] == 1:
            words[part][name] = said
    return words


def _name_driven(sentence: DriverSentence) -> tuple[DrivenPart, str]:
    """What an input drives: a body that turns, or a point."""
    if sentence.stated.TURNS:
        return "turning", sentence.body
    return "moving", sentence.point


def _read_driven(sentence: DriverSentence, givens: Collection[str]) -> Driven | None:
    """What can be said of what an input drives; None where nothing can."""
    path = _find_path(sentence)
    positive = _find_positive(sentence)
    velocity = _read_imposed(sentence.velocity, givens)
    acceleration = _read_imposed(sentence.acceleration, givens)
    unsaid = acceleration is None and sentence.acceleration != Number(fmpq(0))
    if positive is None or velocity is None or unsaid:
        return None
    return Driven(path, positive, velocity, acceleration)


def _find_path(sentence: DriverSentence) -> Path:
    if sentence.stated.TURNS:
        return "turning"
    return "circling" if sentence.centre else "moving"


def _find_positive(sentence: DriverSentence) -> Convention | None:
    """The sense of a positive rate; None for a direction that is along no axis."""
    return "ccw" if sentence.along is None else find_axis(sentence.along)


def _read_imposed(rate: Expression, givens: Collection[str]) -> Imposed | None:
    """A rate that is a given; None where it is another expression."""
    negated = isinstance(rate, Operation) and rate.sign == "-" and is_literal_zero(rate)
    named = rate.right if isinstance(rate, Operation) and negated else rate
    if not isinstance(named, Name) or named.name not in givens:
        return None
    return Imposed(named.name, turned=negated)
