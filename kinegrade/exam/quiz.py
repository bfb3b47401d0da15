"""From an exam folder to a quiz: everybody's paper, or variants of every question for all, one
after the other.

`read_quiz` is called by `kinegrade quiz`. Papers are made when they are asked for, a few ahead by
several processes, so that memory does not grow with the class. Numbers are those of the key;
nothing is solved again but worked solutions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import islice
from pathlib import Path

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.records import KeyLine
from kinegrade.exam.pages import version_name
from kinegrade.exam.quiz_document import Quiz, QuizAsk, QuizPaper
from kinegrade.exam.quiz_paper import QuizWishes, paper_asks, quiz_paper
from kinegrade.exam.quiz_source import QuizSource, read_quiz_source
from kinegrade.language import Language
from kinegrade.processes import executor, mapped

CHUNK = 20  # papers in one task, few enough for all processes to end together
AHEAD = 2  # tasks for each process that are under way or wait for it
PLAIN = QuizWishes()
Progress = Callable[[Iterator[QuizPaper], int], Iterator[QuizPaper]]
Line = tuple[int, bytes]


@dataclass(frozen=True)
class QuizOrder:
    """What a worker needs to know of an exam, and keeps between its tasks."""

    folder: Path
    language: Language | None
    wishes: QuizWishes
    pooled: bool


def read_quiz(
    exam: ExamFolder,
    language: Language | None = None,
    *,
    variants: int | None = None,
    wishes: QuizWishes = PLAIN,
    jobs: int = 1,
    progress: Progress = lambda papers, count: papers,
) -> Quiz:
    """The quiz of an exam, in the papers' language unless another one is wanted, by up to
    `jobs` processes.

    Everybody's own paper, of exams with versions one for each version; or the first `variants`
    papers for everybody. Raises ExamError where the folder is at fault or has fewer papers; the
    papers raise it too, when their turn comes.
    """
    source = read_quiz_source(exam, language)
    available = len(exam.head.versions) or len(exam.head.students)
    if variants is not None and variants > available:
        raise ExamError(
            f"{exam.path}: has {available} different papers - expected {variants} for {variants} "
            f"variants of each question - ask for up to {available}"
        )
    order = QuizOrder(exam.path, language, wishes, variants is not None)
    lines = islice(different(exam), variants)
    papers = _papers(order, source, lines, min(jobs, (variants or available) // CHUNK))
    return Quiz(
        source.language,
        source.course,
        source.title,
        progress(papers, variants or available),
        source.identifier,
        _asks(source, islice(different(exam), variants)),
    )


def different(exam: ExamFolder) -> Iterator[Line]:
    """The line of the key for every student, or for every version that somebody has, by letter.
    Raises ExamError.
    """
    if not exam.head.versions:
        yield from exam.texts()
        return
    found: dict[str, Line] = {}
    for line in exam.texts():
        found.setdefault(exam.read_line(*line).version, line)
        if len(found) == len(exam.head.versions):
            break
    yield from (found[letter] for letter in sorted(found))


def _asks(source: QuizSource, lines: Iterator[Line]) -> Iterator[tuple[str, QuizAsk]]:
    """The asks of these lines, papers one after the other."""
    for line in lines:
        yield from paper_asks(source, source.exam.read_line(*line))


def _papers(
    order: QuizOrder, source: QuizSource, lines: Iterator[Line], workers: int
) -> Iterator[QuizPaper]:
    """The papers of these lines, in order."""
    if workers > 1:
        yield from by_workers(order, lines, workers)
        return
    for line in lines:
        yield _paper(order, source, line)


def by_workers(order: QuizOrder, lines: Iterator[Line], workers: int) -> Iterator[QuizPaper]:
    """The same by other processes; at the end, whatever ends it, none of them runs any more.

    Raises what they raise, WorkerError where one of them was killed.
    """
    parts = iter(lambda: list(islice(lines, CHUNK)), [])
    with executor(workers, "quiz") as others:
        for papers in mapped(others, partial(work, order), parts, AHEAD * workers):
            yield from papers


def work(order: QuizOrder, lines: Sequence[Line]) -> list[QuizPaper]:
    """A task: the papers of these lines."""
    source = _source(order.folder, order.language)
    return [_paper(order, source, line) for line in lines]


@lru_cache(maxsize=1)
def _source(folder: Path, language: Language | None) -> QuizSource:
    """The exam of this process: reading it once is what makes it fast."""
    return read_quiz_source(open_exam(folder), language)


def _paper(order: QuizOrder, source: QuizSource, text: Line) -> QuizPaper:
    line = source.exam.read_line(*text)
    if line.version and not order.pooled:
        return _version(source, order.wishes, line)
    return quiz_paper(source, order.wishes, line, pooled=order.pooled)


def _version(source: QuizSource, wishes: QuizWishes, line: KeyLine) -> QuizPaper:
    """A paper of everybody who has that version."""
    paper = quiz_paper(source, wishes, line, pooled=True)
    return QuizPaper(line.version, "", version_name(line.version, source.language), paper.questions)
