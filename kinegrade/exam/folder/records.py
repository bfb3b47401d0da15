"""What stands in the files of an exam folder: its head (exam.json) and the lines of its key
(key.jsonl), each a typed record.

Numbers are exact, digit by digit. What format 1 lacked is empty: size, engine, values drawn.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property

import msgspec

from kinegrade.exam.choices import Choice
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_secret import ExamSecret, find_secret
from kinegrade.exam.roster.students import PrintFormat, make_file_names
from kinegrade.language import Language
from kinegrade.numbers.amounts import add_amounts


class Candidate(msgspec.Struct, frozen=True, gc=False, omit_defaults=True):
    """A student of the exam: `paper` is the code on the paper, `version` its letter where there are
    versions, `file` where a printed paper stands in the folder. What the roster did not say is
    empty; `language` is then that of the exam. `was_spare` is a paper made without a student. Files
    may have them by the ids that they had `formerly`.
    """

    student: str
    name: str
    email: str = ""
    paper: str = ""
    version: str = ""
    file: str = ""
    group: str = ""
    room: str = ""
    seat: str = ""
    language: str = ""
    extra_time: str = ""
    print_format: PrintFormat = ""
    was_spare: bool = False
    formerly: tuple[str, ...] = ()


class PaperBefore(msgspec.Struct, frozen=True, gc=False):
    """The code of the paper that a student had before that correction of the key."""

    student: str
    paper: str
    correction: int


class ExamQuestion(msgspec.Struct, frozen=True, kw_only=True):
    """A question of the exam: `refused` counts by reason those of its `combinations` that were not
    good; `good` is the number of different ones dealt, if they are fewer than the papers. The
    points of a `bonus` come on top of the maximum.
    """

    question: str
    template: str = ""
    points: Fraction = Fraction(0)
    combinations: int = 0
    refused: dict[str, int] = {}
    good: int | msgspec.UnsetType = msgspec.UNSET
    bonus: bool = False
    asks: tuple[Ask, ...]


class HandQuestion(msgspec.Struct, frozen=True, omit_defaults=True):
    """A question whose answers are marked by hand, which no answer sheet asks for."""

    question: str
    points: Fraction
    title: str = ""
    bonus: bool = False


class ExamHead(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True, dict=True):
    """The head of an exam, or of homework that is `due`: `language` is that of the papers,
    `students` stand in the order of the roster. What its numbers are drawn from is `secret`,
    `label` and `codes`, or the words `reproducible`, which earlier versions called `seed`.
    `credit` is the bank's table for answers that are not right, `scale` that of the grades,
    `solutions` whether feedback holds the worked solutions, `editable` a digest of each file that
    people edit, as it was generated. `earlier` has by template the values that earlier exams dealt
    and nobody is to get again. `paper_size` and `engine` printed the papers, which all have so many
    `pages` unless in large print, 0 where earlier versions printed them; `method` found the
    velocities of worked solutions, if one was asked for, and they have graphs over the `cycle`. Of
    the questions of `choices` papers hold only some, `spares` have no student, `corrections` is how
    often the key was corrected or papers changed hands, `papers_before` were exchanged, and where
    people were `forgotten`, names stand for them and marks have the exam as `known_as`. Papers of
    an `unprinted` exam are printed when asked for. `given` are digests by path of sources before
    correction.
    """

    format: int
    kinegrade: str = ""
    warning: str = ""
    title: str = ""
    course: str = ""
    date: str = ""
    kind: str = "exam"
    due: str = ""
    language: Language
    paper_size: str = ""
    engine: str = ""
    pages: int = 0
    method: str | None = None
    cycle: bool = False
    secret: str | None = None
    label: str | None = None
    codes: str | None = None
    reproducible: str | None = None
    seed: str | None = None
    versions: tuple[str, ...] = ()
    credit: dict[str, object] | None = None
    scale: dict[str, object] | None = None
    solutions: bool = False
    questions: tuple[ExamQuestion, ...]
    students: tuple[Candidate, ...]
    by_hand: tuple[HandQuestion, ...] = ()
    choices: tuple[Choice, ...] = ()
    spares: tuple[Candidate, ...] = ()
    editable: dict[str, str] | None = None
    earlier: dict[str, tuple[dict[str, str], ...]] = {}
    corrections: int = 0
    papers_before: tuple[PaperBefore, ...] = ()
    forgotten: bool = False
    known_as: str = ""
    unprinted: bool = False
    given: dict[str, str] = {}

    def __repr__(self) -> str:
        return f"ExamHead({self.title!r}, {self.date!r})"

    @property
    def drawn_from(self) -> ExamSecret | None:
        """The secret of the numbers; None where it was taken out of the folder, or is damaged."""
        words = self.seed if self.reproducible is None else self.reproducible
        stated = {"secret": self.secret, "label": self.label, "codes": self.codes}
        return find_secret({"reproducible": words, **stated})

    @property
    def everybody(self) -> tuple[Candidate, ...]:
        """All who have a paper: the students, then those who stand for the spare papers."""
        return (*self.students, *self.spares)

    @cached_property
    def asks(self) -> tuple[Ask, ...]:
        """The asks of all questions, in the order of the bank."""
        return tuple(ask for question in self.questions for ask in question.asks)

    @property
    def bonus(self) -> Mapping[str, Fraction]:
        """The points of the questions marked here that come on top of the maximum."""
        return {each.question: each.points for each in self.questions if each.bonus}

    @property
    def bonus_points(self) -> Fraction:
        """What comes on top of the maximum: the points of these, and of those marked by hand."""
        by_hand = (each.points for each in self.by_hand if each.bonus)
        return add_amounts((*self.bonus.values(), *by_hand))

    @cached_property
    def columns(self) -> tuple[str, ...]:
        """The columns of the asks in the answer sheet."""
        return tuple(ask.column for ask in self.asks)

    @cached_property
    def units(self) -> Mapping[str, str]:
        """The units of the asks, by column."""
        return {ask.column: ask.unit for ask in self.asks}

    @cached_property
    def candidates(self) -> Mapping[str, Candidate]:
        """The students by id."""
        return {each.student: each for each in self.students}

    @cached_property
    def holders(self) -> Mapping[str, Candidate]:
        """The same, and the spare papers by their names."""
        return {each.student: each for each in self.everybody}

    @cached_property
    def owners(self) -> Mapping[str, str]:
        """The students by the codes of their papers, as far as the folder states them."""
        return {each.paper: each.student for each in self.students if each.paper}

    @cached_property
    def former_ids(self) -> Mapping[str, str]:
        """The students by the ids that they had before."""
        return {before: each.student for each in self.students for before in each.formerly}

    @cached_property
    def file_stems(self) -> Mapping[str, str]:
        """The stem of each student's file names, by id."""
        return make_file_names(each.student for each in self.students)
