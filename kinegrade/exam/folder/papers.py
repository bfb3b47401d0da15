"""The papers of an exam as grading sees them: whose they are, and the keys of each."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple, assert_never, overload

from kinegrade.numbers.tolerance import Tolerance

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
from kinegrade.exam.folder.keys import Key, Keys, StatedKey


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
