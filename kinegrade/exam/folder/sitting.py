"""What marking needs to know about an exam: what was asked of whom, and one paper after another."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Protocol

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.papers import Paper, PaperBlock, RightAnswers
from kinegrade.language import Language


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
