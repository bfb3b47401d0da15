"""What an exam's questions and asks are called in texts for people.

`kinegrade.exam.exam_wording` reads it from the exam folder; where a text is missing, the identifier
is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol


class Wording(Protocol):
    """Texts in one language: prose is Markdown with `$...$` LaTeX math, a symbol is LaTeX math."""

    @property
    def exam(self) -> str:
        """Plain: what the exam is called."""

    @property
    def course(self) -> str:
        """Plain."""

    @property
    def titles(self) -> Mapping[str, str]:
        """Prose by question, those marked by hand among them."""

    @property
    def meanings(self) -> Mapping[str, str]:
        """Prose by column of the answer sheet: what is asked for."""

    @property
    def symbols(self) -> Mapping[str, str]:
        """Math by column of the answer sheet."""

    @property
    def parameters(self) -> Mapping[tuple[str, str], str]:
        """Math by question and name of a drawn number."""

    @property
    def conventions(self) -> Mapping[str, str]:
        """Prose by column of the answer sheet: the sign convention."""

    @property
    def givens(self) -> Mapping[tuple[str, str], str]:
        """The unit of each drawn number that is printed, by question and name."""

    @property
    def mistakes(self) -> Mapping[str, str]:
        """A plain-text sentence by identifier of a known mistake."""
