"""What a public function gives back of its work: where the result is, what was done, and what a
person should look at.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import Problem
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message, Part


@dataclass(frozen=True, repr=False)
class Outcome:
    """Something was written at `path`; `notes` is what the terminal says of it, `complaints` is
    what a person should look at. Printed, it is these in English, a line each.
    """

    path: Path
    notes: tuple[Part, ...] = ()
    complaints: tuple[Problem, ...] = ()

    def said(self) -> Iterator[Part]:
        """The notes and the complaints."""
        yield from self.notes
        for complaint in self.complaints:
            yield Message("grammar.complaint", complaint=complaint)

    def __repr__(self) -> str:
        return "\n".join(map(open_catalogue(ENGLISH).write, self.said()))
