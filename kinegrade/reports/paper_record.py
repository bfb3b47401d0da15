"""What was right on a marked paper, for reports and feedback: from the student's line of the key,
or from those of a pool whose questions the student was given.

No marks are decided here: `judge` does that.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import nan
from pathlib import Path

from kinegrade.errors import ExamError, FieldError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import decoding, name_paper
from kinegrade.exam.folder.key.exact_keys import find_exact_value, read_rule
from kinegrade.exam.folder.key.lines import KeyLine, StatedAnswer
from kinegrade.exam.folder.numbers import require_double
from kinegrade.grading.policy.policy import AS_PRINTED, Policy
from kinegrade.grading.policy.reading import read_kept_policy
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.rows import Put
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.reports.predictions import Predictions, find_predictions


@dataclass(frozen=True)
class RightAnswer:
    """A right answer: `exact` is an expression where there is one; `rule` is the tolerance by which
    it was marked, `coarse` how far off an answer may be that is rounded too coarsely, 0 where that
    is not known.
    """

    value: Fraction
    exact: str | None
    unit: str
    rule: Tolerance
    coarse: float = 0.0

    @cached_property
    def bounds(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest answer that is right. By significant figures one may lie
        much farther from the value than the other.
        """
        return self.rule.interval(self.value)


@dataclass(frozen=True)
class StatedAnswers(Mapping[str, RightAnswer]):
    """The right answers of a line of the key by column, each worked out as it is asked for, as
    reports need few of them. Raises ExamError at one that cannot be read.
    """

    key: Path
    student: str
    stated: Mapping[str, StatedAnswer]
    rounding: Mapping[str, float]
    policy: Policy
    known: dict[str, RightAnswer] = field(default_factory=dict)

    def __getitem__(self, column: str) -> RightAnswer:
        if column not in self.known:
            self.known[column] = self._read(column)
        return self.known[column]

    def _read(self, column: str) -> RightAnswer:
        stated = self.stated[column]
        with decoding(self.key, name_paper(self.student)):
            try:
                rule = self.policy.ruling(column).rule(read_rule(stated.tolerance))
                value, coarse = find_exact_value(stated), self.rounding.get(column, 0.0)
                return RightAnswer(value, stated.exact, stated.unit, rule, coarse)
            except FieldError as fault:
                problem = Message("marks.of-answer", ask=column, fault=fault.faults[0])
                raise FieldError(problem) from fault

    def __contains__(self, column: object) -> bool:
        return column in self.stated

    def __iter__(self) -> Iterator[str]:
        return iter(self.stated)

    def __len__(self) -> int:
        return len(self.stated)

    @classmethod
    def of(
        cls, key: Path, line: KeyLine, rounding: Mapping[str, float], policy: Policy
    ) -> StatedAnswers:
        """Those of a line, by the tolerances of a policy; `rounding` is what may be off by rounding
        too coarsely, by column.
        """
        stated = {
            f"{question.question}.{name}": answer
            for question in line.questions
            for name, answer in question.asks.items()
        }
        return cls(key, line.student, stated, rounding, policy)


@dataclass(frozen=True)
class PaperRecord:
    """One paper: the questions as printed, right answers by column, drawn numbers by question and
    parameter, and predicted difficulties by question, where they are known.

    A number is NaN where the question's asks were put with different values.
    """

    printed: tuple[str, ...]
    answers: Mapping[str, RightAnswer]
    parameters: Mapping[tuple[str, str], float]
    difficulties: Mapping[str, float]


@dataclass(frozen=True)
class PaperRecords:
    """The papers of an exam, each read when it is needed.

    `put` says which answers were marked by lines other than the student's, where questions came
    from a pool; `policy` by which tolerances.
    """

    exam: ExamFolder
    put: Put = field(default_factory=dict)
    policy: Policy = AS_PRINTED

    @classmethod
    def of_marks(cls, exam: ExamFolder, marks: MarksFolder) -> PaperRecords:
        """Those by which a class was marked. Raises PolicyError."""
        return cls(exam, marks.put, read_kept_policy(marks.path, exam))

    def paper(self, student: str) -> PaperRecord:
        """The paper of a student. Raises ExamError where the exam has no paper for that student."""
        line, predictions = self.exam.keys.line_of(student), self._predictions
        rounding = predictions.rounding.get(student, {})
        answers = StatedAnswers.of(self.exam.keys.file, line, rounding, self.policy)
        with decoding(self.exam.keys.file, name_paper(student)):
            parameters = dict(_read_parameters(line))
        difficulties = predictions.difficulties.get(student, {})
        return PaperRecord(line.order, answers, parameters, difficulties)

    @cached_property
    def _predictions(self) -> Predictions:
        return find_predictions(self.exam)

    def marked(self, student: str, columns: Iterable[str]) -> PaperRecord:
        """The paper of a student whose answers stand in these columns. Raises ExamError where it
        does not ask them.
        """
        paper = self._as_put(self.paper(student), self.put.get(student, {}))
        unknown = next((column for column in columns if column not in paper.answers), None)
        if unknown is not None:
            problem = Message("marks.not-asked", student=Quoted(student), ask=unknown)
            expected, do = Message("marks.of-this-exam"), Message("marks.name-exam")
            raise ExamError(Fault(str(self.exam.keys.file), problem, expected, do))
        return paper

    def _as_put(self, paper: PaperRecord, put: Mapping[str, str]) -> PaperRecord:
        """The paper with the answers that were put to the student, and the numbers of their
        questions.

        A question whose asks come from several variants has several values for each parameter, so
        it gets none.
        """
        if not put:
            return paper
        answers, parameters = dict(paper.answers), dict(paper.parameters)
        difficulties = dict(paper.difficulties)
        sources: dict[str, set[str]] = {}
        for column, source in put.items():
            other = self.paper(source)
            if column in other.answers:
                answers[column] = other.answers[column]
            question = column.partition(".")[0]
            sources.setdefault(question, set()).add(source)
            alone = len(sources[question]) == 1
            parameters |= {
                place: number if alone else nan
                for place, number in other.parameters.items()
                if place[0] == question
            }
            difficulties[question] = other.difficulties.get(question, nan) if alone else nan
        return PaperRecord(paper.printed, answers, parameters, difficulties)


def _read_parameters(line: KeyLine) -> Iterator[tuple[tuple[str, str], float]]:
    """The drawn numbers, by question and parameter. Raises FieldError."""
    for question in line.questions:
        for name, stated in question.parameters.items():
            yield (question.question, name), require_double(name, stated.value)
