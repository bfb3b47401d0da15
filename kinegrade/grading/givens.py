"""The numbers drawn for each paper, for accepted answers that depend on them: `r*omega`.

`policy_reading` and `accepted` use them; key.jsonl is read for them only where a policy names one.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from kinegrade.errors import ExamError

Given = tuple[str, str]  # the number as text, and its unit


@dataclass(frozen=True)
class Givens:
    """What was drawn for the papers of an exam folder."""

    folder: Path

    def of(self, student: str, question: str) -> Mapping[str, Given]:
        """The parameters of a question on a student's paper, by name."""
        return self._papers[student][question]

    def units(self, question: str) -> Mapping[str, str]:
        """The units of a question's parameters, by name; they are the same on every paper."""
        paper = next(iter(self._papers.values()))
        return {name: unit for name, (_, unit) in paper[question].items()}

    @cached_property
    def _papers(self) -> Mapping[str, Mapping[str, Mapping[str, Given]]]:
        file = self.folder / "key.jsonl"
        try:
            papers = map(json.loads, filter(str.strip, file.read_text(encoding="utf-8").split("\n")))
            return {paper["student"]: {each["question"]: _given(each["parameters"]) for each in paper["questions"]}
                    for paper in papers}
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as fault:
            raise ExamError(
                f"{file}: the numbers drawn cannot be read - expected the parameters of each question, which the "
                "policy uses - restore the exam folder as it was generated, or write the accepted answers as numbers"
            ) from fault


def _given(parameters: Mapping[str, Mapping[str, object]]) -> Mapping[str, Given]:
    return {name: (str(each["exact"] or each["value"]), str(each["unit"])) for name, each in parameters.items()}
