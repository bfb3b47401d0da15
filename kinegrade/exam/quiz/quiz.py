"""From an exam folder to a quiz: every student's paper, or variants of every question for all
students, one after another.

`read_quiz` is called by `kinegrade quiz`. Papers are made when they are asked for, a few ahead by
several processes, so that memory does not grow with the class. Numbers are those of the key;
nothing is solved again except for worked solutions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from itertools import islice

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.printing.pages import write_version_name
from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizPaper
from kinegrade.exam.quiz.paper import QuizWishes, list_asks, make_quiz_paper
from kinegrade.exam.quiz.source import QuizSource, list_own_sources, read_quiz_source
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.processes.executor import THIS_PROCESS, Shared, map_in_order, split_in_parts

_PART = 20  # papers in one task, few enough for all processes to end together
PLAIN = QuizWishes()
Progress = Callable[[Iterator[QuizPaper], int], Iterator[QuizPaper]]
Line = tuple[int, bytes]


@dataclass(frozen=True)
class _QuizOrder:
    """What is the same for all papers of a quiz; `own` are the sources of papers in languages of
    their students.
    """

    source: QuizSource
    own: Mapping[Language, QuizSource]
    wishes: QuizWishes
    pooled: bool


def read_quiz(
    exam: ExamFolder,
    language: Language | None = None,
    *,
    variants: int | None = None,
    wishes: QuizWishes = PLAIN,
    workers: Executor = THIS_PROCESS,
    progress: Progress = lambda papers, count: papers,
) -> Quiz:
    """The quiz of an exam, in the papers' language unless another one is wanted, that of each
    student where papers are the students'; `workers` make the papers as they are asked for.

    Every student's paper, or one for each version if the exam has versions; or the first `variants`
    papers for all students. Raises ExamError where the folder is at fault or has fewer papers; the
    papers raise it too, when their turn comes.
    """
    exam.require_sound_key()
    source = read_quiz_source(exam, language)
    available = len(exam.head.versions) or len(exam.head.students)
    if variants is not None and variants > available:
        what = Message("exam.too-few-papers", count=available, variants=variants)
        raise ExamError(Fault(str(exam.path), what))
    shared = language is not None or variants is not None or bool(exam.head.versions)
    own = {} if shared else list_own_sources(source)
    order = _QuizOrder(source, own, wishes, variants is not None)
    papers = _make_papers(order, islice(different(exam), variants), workers)
    return Quiz(
        source.language,
        source.course,
        source.title,
        progress(papers, variants or available),
        source.identifier,
        _list_asks(source, islice(different(exam), variants)),
    )


def different(exam: ExamFolder) -> Iterator[Line]:
    """The line of the key for every student, or for every version that a student has, by letter.
    Raises ExamError.
    """
    if not exam.head.versions:
        yield from exam.keys.texts()
        return
    found: dict[str, Line] = {}
    for line in exam.keys.texts():
        found.setdefault(exam.keys.read_line(*line).version, line)
        if len(found) == len(exam.head.versions):
            break
    yield from (found[letter] for letter in sorted(found))


def _list_asks(source: QuizSource, lines: Iterator[Line]) -> Iterator[tuple[str, QuizAsk]]:
    """The asks of these lines, papers one after the other."""
    for line in lines:
        yield from list_asks(source, source.exam.keys.read_line(*line))


def _make_papers(
    order: _QuizOrder, lines: Iterator[Line], workers: Executor
) -> Iterator[QuizPaper]:
    """The papers of these lines, in order."""
    shared = Shared(order)
    tasks = ((shared, part) for part in split_in_parts(lines, _PART))
    for papers in map_in_order(workers, _make_part, tasks):
        yield from papers


def _make_part(task: tuple[Shared[_QuizOrder], Sequence[Line]]) -> list[QuizPaper]:
    """The papers of a part of the class."""
    shared, lines = task
    return [_make_paper(shared.value, line) for line in lines]


def _make_paper(order: _QuizOrder, text: Line) -> QuizPaper:
    line = order.source.exam.keys.read_line(*text)
    if line.version and not order.pooled:
        return _make_version(order.source, order.wishes, line)
    source = order.own.get(_find_own_language(order.source, line))
    if source is None:
        return make_quiz_paper(order.source, order.wishes, line, pooled=order.pooled)
    paper = make_quiz_paper(source, order.wishes, line)
    return replace(paper, language=source.language, title=source.title)


def _find_own_language(source: QuizSource, line: KeyLine) -> Language:
    """The language of the student of a line; that of the quiz where nothing is known of either."""
    candidate = source.exam.head.candidates.get(line.student)
    return Language(candidate.language) if candidate and candidate.language else source.language


def _make_version(source: QuizSource, wishes: QuizWishes, line: KeyLine) -> QuizPaper:
    """The paper of all students who have that version."""
    paper = make_quiz_paper(source, wishes, line, pooled=True)
    return QuizPaper(
        line.version, "", write_version_name(line.version, source.language), paper.questions
    )
