"""What a person must know about a quiz file that was written, and what keeps one from being
written.
"""

from __future__ import annotations

from kinegrade.errors import ExportError, TypesetError

MOST_SHOWN = 40


class Remarks:
    """Complaints and faults, each said once however many papers it is about, in the order they were
    met.
    """

    def __init__(self) -> None:
        self._complaints: dict[str, None] = {}
        self._faults: dict[str, None] = {}
        self._hidden = 0

    @property
    def complaints(self) -> list[str]:
        """What was left out or must be done by hand, a line each."""
        return list(self._complaints)

    def complain(self, line: str) -> None:
        """Something that an instructor should know about the file."""
        self._complaints[line] = None

    def refuse(self, line: str) -> None:
        """Something that cannot be said in this format, so that no file is written."""
        if line in self._faults:
            return
        if len(self._faults) < MOST_SHOWN:
            self._faults[line] = None
        else:
            self._hidden += 1

    def refuse_texts(self, fault: TypesetError) -> None:
        """Texts that cannot be shown faithfully."""
        for line in fault.problems:
            self.refuse(line)

    def raise_faults(self) -> None:
        """Raises ExportError with all faults, if there are any."""
        if self._faults:
            more = (f"quiz: and {self._hidden} more",) if self._hidden else ()
            raise ExportError(*self._faults, *more)
