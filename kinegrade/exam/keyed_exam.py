"""An exam in memory, as `kinegrade.exam.folder.sitting.Sitting` wants it: every key at hand."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.exam.folder.asks import Ask, list_questions
from kinegrade.exam.folder.columns.blocks import list_blocks
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.exact_keys import ListedKeys
from kinegrade.exam.folder.keys import NOT_ASKED, Key
from kinegrade.exam.folder.papers import Paper, PaperBlock, RightAnswers
from kinegrade.language import ENGLISH, Language


@dataclass(frozen=True, slots=True)
class Examinee:
    """Whose paper it is, and its key by answer column, of those that it asks for."""

    student: str
    name: str
    keys: Mapping[str, Key]


@dataclass(frozen=True, slots=True)
class KeyedExam:
    """The asks in the order of the paper, the examinees in the order of the roster."""

    asks: tuple[Ask, ...]
    examinees: tuple[Examinee, ...]
    language: Language = ENGLISH

    @property
    def questions(self) -> tuple[str, ...]:
        """The questions in the order of the paper."""
        return list_questions(self.asks)

    @property
    def students(self) -> tuple[str, ...]:
        """The ids of the examinees."""
        return tuple(examinee.student for examinee in self.examinees)

    @property
    def names(self) -> Mapping[str, str]:
        """The names of the examinees, by id."""
        return {examinee.student: examinee.name for examinee in self.examinees}

    @property
    def codes(self) -> Mapping[str, str]:
        """None: papers in memory have none."""
        return {}

    @property
    def former_ids(self) -> Mapping[str, str]:
        """None: ids of papers in memory do not change."""
        return {}

    @property
    def codes_before(self) -> Collection[tuple[str, str]]:
        """None: papers in memory are not exchanged."""
        return ()

    @property
    def spare_codes(self) -> Collection[str]:
        """None: all papers in memory are somebody's."""
        return ()

    def papers(self) -> Iterator[Paper]:
        """The papers of the examinees."""
        for each in self.examinees:
            keys = [each.keys.get(ask.column, NOT_ASKED) for ask in self.asks]
            yield Paper(each.student, each.name, ListedKeys(keys))

    def blocks(self, size: int) -> Iterator[PaperBlock]:
        """The same in blocks of that size, or less."""
        return list_blocks(self.papers(), size)

    def right_answers(self) -> Iterator[RightAnswers]:
        """Nothing: keys in memory are no arrays."""
        return iter(())

    def variants(self) -> Sequence[Paper]:
        """None: an exam in memory has the papers of its examinees alone."""
        return ()


def read_whole(exam: ExamFolder) -> KeyedExam:
    """The whole exam of a folder. Raises ExamError."""
    columns = [ask.column for ask in exam.asks]

    def examinee(paper: Paper) -> Examinee:
        held = [number for number in range(len(columns)) if number not in paper.lacks]
        keys = {columns[number]: paper.key(number) for number in held}
        return Examinee(paper.student, paper.name, keys)

    return KeyedExam(exam.asks, tuple(map(examinee, exam.papers())))
