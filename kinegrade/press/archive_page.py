"""The page that is printed and kept with the archive of an exam."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language import Language


@dataclass(frozen=True)
class ArchivePage:
    """What is stated of an archive: all plain text.

    `facts` are labels with what they label, `secret` the lines from which the numbers were drawn,
    `steps` how to restore the exam, `codes` the ids of students with the codes on their papers.
    """

    language: Language
    title: str
    warning: str
    facts: tuple[tuple[str, str], ...]
    secret: tuple[tuple[str, str], ...]
    steps: tuple[str, ...]
    codes: tuple[tuple[str, str], ...]
