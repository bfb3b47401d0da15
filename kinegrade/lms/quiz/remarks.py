"""What the instructor must know about a quiz file that was written, and what prevents a file."""

from __future__ import annotations

from kinegrade.errors import ExportError, Problem, TypesetError
from kinegrade.language.message import Message

_MOST_SHOWN = 40


class Remarks:
    """Complaints and faults in the order in which they were found, each once, however many papers
    it is about.
    """

    def __init__(self) -> None:
        self._complaints: dict[Problem, None] = {}
        self._faults: dict[Problem, None] = {}
        self._hidden = 0

    @property
    def complaints(self) -> list[Problem]:
        """What was left out or must be done by hand, one line for each."""
        return list(self._complaints)

    def complain(self, line: Problem) -> None:
        """Adds something that the instructor should know about the file."""
        self._complaints[line] = None

    def refuse(self, line: Problem) -> None:
        """Adds something that this format cannot express, so that no file is written."""
        if line in self._faults:
            return
        if len(self._faults) < _MOST_SHOWN:
            self._faults[line] = None
        else:
            self._hidden += 1

    def refuse_texts(self, fault: TypesetError) -> None:
        """Adds texts that cannot be shown faithfully."""
        for line in fault.faults:
            self.refuse(line)

    def raise_faults(self) -> None:
        """Raises ExportError with all faults, if there are any."""
        if self._faults:
            more = (Message("quiz-file.more", number=self._hidden),) if self._hidden else ()
            raise ExportError(*self._faults, *more)
