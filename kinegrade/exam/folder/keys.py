"""An exam as grading sees it: who was asked what, and the key of each paper.

`key_decoding` and `exact_keys` fill these values; `sheet`, `judge` and `marks` use them.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple, Protocol, assert_never, overload

from kinegrade.language import Language
from kinegrade.numbers.amounts import add_amounts
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.sign_conventions import Convention

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Ask:
    """One answer box, the same on every paper; `unit` is "1" for a pure number.

    `sign` is the sign convention in words, as it stands on papers; "" where it is not known.
    `convention` is its keyword, None for one that the template's author put into words. The points
    of a `bonus` come on top of the maximum.
    """

    question: str
    ask: str
    unit: str
    points: Fraction
    sign: str = ""
    convention: Convention | None = None
    bonus: bool = False

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"


@dataclass(frozen=True, slots=True)
class Key:
    """The right answer, in the unit of the ask, and the rule that says how far from it is right.

    `period` is a full turn for an angle that is right with any number of turns more or less;
    `mistakes` are the wrong answers that known mistakes lead to, by id.

    >>> [float(bound) for bound in Key(Fraction("1.2304"), Tolerance(figures=3)).interval]
    [1.225, 1.235]
    """

    value: Fraction
    rule: Tolerance
    period: Fraction | None = None
    mistakes: Mapping[str, Fraction] = field(default_factory=dict, hash=False)

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest right answer."""
        return self.rule.interval(self.value)


# In place of the key of an alternative that a paper does not hold
NOT_ASKED = Key(Fraction(0), Tolerance())


class StatedKey(NamedTuple):
    """A key as it stands in key.jsonl; `key` works it out exactly, only when that is needed.

    `value` is the right answer as a decimal or a plain fraction, `mistakes` what mistakes lead to:
    to double precision, which is as far as they are known, or exactly.
    """

    value: str
    rule: Tolerance
    mistakes: Mapping[str, float | Fraction]
    period: Fraction | None

    def key(self, names: Container[str]) -> Key:
        """The exact key, with the mistakes of these names only."""
        mistakes = {
            name: wrong if isinstance(wrong, Fraction) else Fraction(repr(wrong))
            for name, wrong in self.mistakes.items()
            if name in names
        }
        return Key(Fraction(self.value), self.rule, self.period, mistakes)


class Keys(Protocol):
    """The keys of one paper in the order of its asks: `ListedKeys`, or as files state them."""

    def __getitem__(self, ask: int, /) -> Key | StatedKey:
        """The key of an ask."""

    def __len__(self) -> int:
        """How many there are."""

    def __iter__(self) -> Iterator[Key | StatedKey]:
        """All of them."""

    def state(self, ask: int, /) -> str:
        """The right answer to an ask, as a decimal or a fraction."""

    def list_centres(self) -> Sequence[float]:
        """The right answers in double precision; NaN where a number of turns is right too."""

    def list_values(self) -> Sequence[float]:
        """The right answers, those of cyclic angles too, nearly rounded."""

    def list_periods(self) -> Sequence[Fraction | None]:
        """The full turn of each ask, where any number of turns is right too."""

    def list_rules(self) -> tuple[Tolerance, ...]:
        """The rule of each ask; where papers share all of them, the same object."""

    def find_lacking(self) -> frozenset[int]:
        """The numbers of the asks that the paper does not hold; their keys are NOT_ASKED."""


class Paper(NamedTuple):
    """Whose paper it is, and its keys in the order of the asks.

    `put` gives for each ask the student from whose line of the key it comes, "" for this student's
    line; it is empty if that holds for all asks.
    """

    student: str
    name: str
    keys: Keys
    put: tuple[str, ...] = ()

    @property
    def lacks(self) -> frozenset[int]:
        """The numbers of the asks that it does not hold."""
        return self.keys.find_lacking()

    def source(self, ask: int) -> str:
        """The student on whose line of the key this ask stands as it was asked."""
        return (self.put[ask] if self.put else "") or self.student

    def key(self, ask: int, names: Container[str] | None = None) -> Key:
        """The exact key of an ask, with the mistakes of these names, or with all of them."""
        key = self.keys[ask]
        match key:
            case StatedKey():
                return key.key(key.mistakes if names is None else names)
            case Key(mistakes=mistakes):
                if names is None or len(mistakes) == 0:
                    return key
                kept = {name: wrong for name, wrong in mistakes.items() if name in names}
                return replace(key, mistakes=kept)
            case _:
                assert_never(key)


class PaperBlock(Sequence[Paper]):
    """Papers marked together, which say together whose they are and what their keys are."""

    @overload
    def __getitem__(self, row: int) -> Paper: ...

    @overload
    def __getitem__(self, row: slice) -> PaperBlock: ...

    @abstractmethod
    def __getitem__(self, row: int | slice) -> Paper | PaperBlock: ...

    @property
    @abstractmethod
    def students(self) -> Sequence[str]:
        """Whose they are."""

    @property
    @abstractmethod
    def names(self) -> Sequence[str]:
        """The names of these students."""

    @property
    @abstractmethod
    def keys(self) -> Sequence[Keys]:
        """Their keys."""

    @property
    @abstractmethod
    def lacking(self) -> Mapping[int, frozenset[int]]:
        """Those that do not hold every question, with the numbers of the asks that they lack."""

    @property
    @abstractmethod
    def put_together(self) -> Sequence[Paper]:
        """Those with questions of others."""


class RightAnswers(NamedTuple):
    """What is right on some papers: `values`, nearly rounded, have a row for each paper and a
    column for each ask, `rules` are those of each paper, `periods` the full turns of the asks or 0.
    """

    values: NDArray[np.float64]
    rules: Sequence[tuple[Tolerance, ...]]
    periods: Sequence[float]


class Sitting(Protocol):
    """What marking needs to know about an exam: what was asked of whom, and one paper after
    another.
    """

    @property
    def asks(self) -> tuple[Ask, ...]:
        """The asks in the order of the paper."""

    @property
    def students(self) -> tuple[str, ...]:
        """The ids of the examinees, in the order of the roster."""

    @property
    def names(self) -> Mapping[str, str]:
        """The names of the examinees, by id."""

    @property
    def codes(self) -> Mapping[str, str]:
        """The examinees by the codes of their papers."""

    @property
    def former_ids(self) -> Mapping[str, str]:
        """The examinees by the ids that they had before, which files may still have."""

    @property
    def spare_codes(self) -> Collection[str]:
        """The codes of spare papers, which are nobody's."""

    @property
    def codes_before(self) -> Collection[tuple[str, str]]:
        """Students with the codes of papers that were theirs before an exchange."""

    @property
    def language(self) -> Language:
        """The language of the papers."""

    def papers(self) -> Iterator[Paper]:
        """The papers in the order of the roster."""

    def blocks(self, size: int) -> Iterator[PaperBlock]:
        """The same in blocks of that size, or less."""

    def right_answers(self) -> Iterator[RightAnswers]:
        """What is right on the first of them, as many as stand in arrays."""

    def variants(self) -> Sequence[Paper]:
        """The papers of the pool that was made of the exam, none if there is no pool."""


def add_counted(asks: Iterable[Ask]) -> Fraction:
    """The maximum: the points of these asks, without those that are a bonus."""
    return add_amounts(ask.points for ask in asks if not ask.bonus)


def list_questions(asks: Sequence[Ask]) -> tuple[str, ...]:
    """The questions to which these asks belong, in their order."""
    return tuple(dict.fromkeys(ask.question for ask in asks))
