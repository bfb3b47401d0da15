"""The numbers drawn for each paper, for accepted answers that depend on them: `r*omega`.

`policy_reading` and `accepted` use them; key.jsonl is read for them only where a policy names one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from kinegrade.errors import ExamError
from kinegrade.grading.key_lines import KeyLines

Given = tuple[str, str]  # the number as text, and its unit
Drawn = Mapping[str, Mapping[str, Given]]  # by question and parameter


@dataclass
class Givens:
    """What was drawn for the papers of an exam folder; of the papers the last that was asked for is
    kept.
    """

    folder: Path
    _last: tuple[str, Drawn] = field(default=("", {}), init=False)

    def of(self, student: str, question: str) -> Mapping[str, Given]:
        """The parameters of a question on a student's paper, by name. Raises ExamError."""
        return self._drawn(student)[question]

    def units(self, question: str) -> Mapping[str, str]:
        """The units of a question's parameters, by name; they are the same on every paper. Raises
        ExamError.
        """
        with self._readable():
            paper = self._drawn(self._lines.first)
        return {name: unit for name, (_, unit) in paper[question].items()}

    @cached_property
    def _lines(self) -> KeyLines:
        return KeyLines(self.folder / "key.jsonl")

    def _drawn(self, student: str) -> Drawn:
        if self._last[0] != student:
            with self._readable():
                paper = self._lines.paper(student)
                drawn = {
                    each["question"]: _given(each["parameters"]) for each in paper["questions"]
                }
            self._last = student, drawn
        return self._last[1]

    @contextmanager
    def _readable(self) -> Iterator[None]:
        try:
            yield
        except (
            OSError,
            ValueError,
            LookupError,
            TypeError,
            AttributeError,
            StopIteration,
        ) as fault:
            raise ExamError(
                f"{self.folder / 'key.jsonl'}: the numbers drawn cannot be read - expected the "
                "parameters of each question, which the policy uses - restore the exam folder as "
                "it was generated, or write the accepted answers as numbers"
            ) from fault


def _given(parameters: Mapping[str, Mapping[str, object]]) -> Mapping[str, Given]:
    return {
        name: (str(each["exact"] or each["value"]), str(each["unit"]))
        for name, each in parameters.items()
    }
