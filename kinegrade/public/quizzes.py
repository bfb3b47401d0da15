"""`kinegrade.quiz`: the papers of an exam as a quiz for a learning management system."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from fractions import Fraction
from os import PathLike
from pathlib import Path

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import ANSWER_WORKBOOK
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.exam.quiz.paper import QuizWishes
from kinegrade.exam.quiz.quiz import Progress, read_quiz
from kinegrade.exam.quiz.variants import variants_stored
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message, list_all, list_first
from kinegrade.lms.quiz.formats import FORMATS, FileWishes, choose_writer
from kinegrade.lms.quiz.moodle.questions import Form
from kinegrade.problem.template.template import Method
from kinegrade.processes.executor import open_executor
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_opened
from kinegrade.public.options import find_language, require_known, require_word
from kinegrade.public.outcome import Outcome
from kinegrade.question_numbers import find_bank_number

_NAMED = 5  # students


def _as_they_come(papers: Iterator[QuizPaper], count: int) -> Iterator[QuizPaper]:
    return papers


@dataclass(frozen=True)
class QuizOptions:
    """What a quiz holds.

    Every student's paper, or a pool of the first `variants` papers for all students. `form` is that
    of Moodle's questions; `megabytes` splits Moodle's file into several. With `mistakes` known
    mistakes are named and earn the share `credit`, by default the bank's; `solutions` adds worked
    solutions, by `method` where several serve. Papers are made by up to `jobs` processes, or by the
    workers of the `cluster` whose scheduler has that address; `progress` is given them one after
    another, and their number.
    """

    variants: int | None = None
    form: Form = "cloze"
    megabytes: Fraction | float | None = None
    mistakes: bool = True
    credit: Fraction | None = None
    solutions: bool = False
    method: Method | None = None
    jobs: int = 1
    cluster: str | None = None
    progress: Progress = _as_they_come

    @property
    def wishes(self) -> QuizWishes:
        """What the questions are to hold."""
        return QuizWishes(self.mistakes, self.credit, self.solutions, self.method)

    @property
    def file(self) -> FileWishes:
        """How the file is to be written."""
        limit = None if self.megabytes is None else Fraction(str(self.megabytes))
        return FileWishes(self.form, limit)


_ORDINARY = QuizOptions()


def quiz(
    exam: ExamFolder,
    output: str | PathLike[str],
    *,
    to: str,
    language: str | None = None,
    force: bool = False,
    options: QuizOptions = _ORDINARY,
) -> Outcome:
    """Write the papers of an exam as a quiz that a learning management system imports, as
    `kinegrade quiz` does; each paper in its own language unless another one is wanted.

    The file gives the key away. Raises KinegradeError.

    >>> exam = kinegrade.open_exam("EXAM")
    >>> quiz(exam, "quiz.zip", to="qti12").path.name
    'quiz.zip'
    >>> quiz(exam, "quiz.xml", to="moodle")
    Traceback (most recent call last):
    kinegrade.errors.OptionError: to: unknown: "moodle" - did you mean "moodle-xml"? ...
    """
    expect_opened(exam=exam)
    place = Path(output)
    expect_own_place(place)
    require_word("to", to, FORMATS)
    require_known(options)
    _refuse_alternatives(exam)
    chosen = None if language is None else find_language(language)
    writer = choose_writer(to, options.file)
    with open_executor(options.jobs, "quiz", cluster=options.cluster) as workers:
        put = _read(exam, chosen, options, workers)
        with variants_stored(exam, options.variants or 0):
            remarks = writer(put, place, force=force)
    written = Message("terminal.quiz-written", file=str(place))
    other = (*_list_left_out(exam, place), *_list_bonus(exam, place))
    if chosen is None and (options.variants or exam.head.versions):
        other = (*_list_other_languages(exam, place), *other)
    notes = (written, Message("terminal.marked-there"), *_name_versions(exam, options))
    return Outcome(place, notes, (*remarks, *other))


def _name_versions(exam: ExamFolder, options: QuizOptions) -> Iterator[Message]:
    """Where it stands who has which version, as each has a quiz of its own."""
    if exam.head.versions and not options.variants:
        yield Message("terminal.versions-stand", file=str(exam.path / ANSWER_WORKBOOK))


def _refuse_alternatives(exam: ExamFolder) -> None:
    """Raises ExamError where papers hold different questions, which no quiz can ask."""
    listed = [name for choice in exam.head.choices for name in choice.questions]
    if listed:
        numbers = list_all([find_bank_number(each) for each in listed])
        what = Message("quiz.alternatives", questions=numbers)
        raise ExamError(Fault(str(exam.head_file), what, do=Message("quiz.one-for-all")))


def _list_left_out(exam: ExamFolder, place: Path) -> Iterator[Fault]:
    """That questions without numbers are not in the quiz."""
    by_hand = exam.head.by_hand
    if by_hand:
        numbers = list_all([find_bank_number(each.question) for each in by_hand])
        what = Message("quiz.by-hand", count=len(by_hand), questions=numbers)
        yield Fault(str(place), what, do=Message("quiz.ask-by-hand"))


def _list_bonus(exam: ExamFolder, place: Path) -> Iterator[Fault]:
    """That bonus questions are questions like any other in the quiz."""
    bonus = exam.head.bonus
    if bonus:
        numbers = list_all([find_bank_number(each) for each in bonus])
        what = Message("quiz.bonus", count=len(bonus), questions=numbers)
        yield Fault(str(place), what, do=Message("quiz.mark-bonus"))


def _list_other_languages(exam: ExamFolder, place: Path) -> Iterator[Fault]:
    """Whose papers have another language than a quiz that several are put."""
    other = [
        each.student for each in exam.head.students if each.language not in ("", exam.language)
    ]
    if other:
        what = Message(
            "quiz.other-language",
            count=len(other),
            students=list_first(other, _NAMED),
            language=exam.language,
        )
        yield Fault(str(place), what, do=Message("quiz.in-each-language"))


def _read(
    exam: ExamFolder, language: Language | None, options: QuizOptions, workers: Executor
) -> Quiz:
    """The quiz of an exam, whose questions are read while it is written."""
    return read_quiz(
        exam,
        language,
        variants=options.variants,
        wishes=options.wishes,
        workers=workers,
        progress=options.progress,
    )
