"""Which paper's questions a student was given: those of the student's paper, or those that a system
drew from a pool.

A question is recognised by the right answers in a download, by its text with its numbers, or by
both. Answers to a question that is not recognised would be marked with the wrong key, so the whole
file is refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.answer_file import Sources
from kinegrade.files.cell_text import trim
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.lms.responses.other_paper import agree, difference, right_answers, value_of
from kinegrade.lms.responses.people import Found
from kinegrade.lms.responses.typed_rows import TypedRow, TypedRows

if TYPE_CHECKING:
    from kinegrade.exam.quiz.variants import Variant, Variants

Pairs = Sequence[tuple[TypedRow, Found]]
_SAME = 1e-6  # relative: right answers are written with all their digits
_BLANK = ("", "-")
_ADVICE = Message("responses.download-texts")


def pool_of(exam: ExamFolder) -> Variants | None:
    """The pool that was made from an exam, None where none was made. Raises ExamError."""
    if not exam.keys.has_pool:
        return None
    from kinegrade.exam.quiz.variants import read_variants  # noqa: PLC0415  # takes seconds to load

    return read_variants(exam)


def own_papers_only(
    file: str, typed: TypedRows, pairs: Pairs, exam: ExamFolder
) -> list[tuple[TypedRow, Found]]:
    """Each row with its student, or with none where the student was given other questions than
    those of the student's paper.

    Raises TableError where that holds for most of the students.
    """
    checked: list[tuple[TypedRow, Found]] = []
    others = []
    for each, who in pairs:
        right = right_answers(exam, who.student) if each.right and who.student else {}
        other = difference(typed.columns, each.right, right)
        checked.append((each, _explain_other(who, other) if other else who))
        if other:
            others.append(Message("responses.line", line=each.row.line, difference=other))
    known = sum(who.student is not None for _, who in pairs)
    if len(others) > 1 and 2 * len(others) > known:
        raise TableError(
            Fault(
                file,
                Message("responses.other-papers", count=known, others=len(others), first=others[0]),
                Message("responses.own-papers"),
                Message("responses.answered-pool"),
            )
        )
    return checked


def _explain_other(who: Found, other: Message) -> Found:
    student = Quoted(who.student or "")
    return Found(None, "", Message("responses.other-paper", student=student, difference=other))


def put_to(
    file: str, typed: TypedRows, pairs: Pairs, variants: Variants, exam: ExamFolder
) -> Mapping[int, Sources]:
    """For each row, by its line number, whose line of the key each question belongs to. Raises
    TableError where that is not certain.
    """
    if not any(any(each.right) or any(each.texts) for each, _ in pairs) and pairs:
        pool = str(exam.keys.pool_file)
        raise TableError(
            Fault(
                file,
                Message("responses.pool", count=variants.count, pool=pool),
                Message("responses.texts"),
                _ADVICE,
            )
        )
    finder = _Finder(typed, variants)
    found: dict[int, Sources] = {}
    unknown: list[Message] = []
    for each, who in pairs:
        if who.student is not None:
            sources, faults = finder.sources(each)
            found[each.row.line] = sources
            unknown += faults
    if unknown:
        raise TableError(
            Fault(
                file,
                Message(
                    "responses.uncertain",
                    count=len(unknown),
                    variants=variants.count,
                    first=unknown[0],
                ),
                Message("responses.recognised"),
                _ADVICE,
            )
        )
    return found


@dataclass(frozen=True)
class _Finder:
    typed: TypedRows
    variants: Variants

    def sources(self, each: TypedRow) -> tuple[Sources, list[Message]]:
        """Whose line of the key the questions of a row belong to, for every column; and what is not
        recognised.
        """
        found = [""] * len(self.typed.columns)
        faults = []
        for drawn in self._drawn():
            likely = self._likely(each, drawn)
            if likely and _are_alike(likely):
                for number in drawn:
                    found[number] = likely[0].source
            elif any(trim(each.responses[number]) not in _BLANK for number in drawn):
                faults.append(self._explain(each, drawn, len(likely)))
        return tuple(found), faults

    def _explain(self, each: TypedRow, drawn: Sequence[int], likely: int) -> Message:
        line = each.row.line
        asks = list_plainly(self.typed.columns[number] for number in drawn)
        if likely:
            return Message("responses.several-meant", line=line, asks=asks, count=likely)
        return Message("responses.none-meant", line=line, asks=asks)

    def _drawn(self) -> Iterator[tuple[int, ...]]:
        places = {column: number for number, column in enumerate(self.typed.columns)}
        for columns in self.typed.drawn or [(column,) for column in self.typed.columns]:
            yield tuple(places[column] for column in columns)

    def _likely(self, each: TypedRow, drawn: Sequence[int]) -> list[Variant]:
        """The variants that agree with all the row has; none where it has nothing to compare."""
        question = self.typed.columns[drawn[0]].partition(".")[0]
        stated = [
            (self.typed.columns[number].partition(".")[2], value)
            for number in drawn
            if each.right and (value := value_of(each.right[number])) is not None
        ]
        text = next((each.texts[number] for number in drawn if each.texts), "")
        variants = self.variants.questions.get(question, ())
        by_text = self._of_text(variants, text)
        if not stated:
            return by_text
        likely = [variant for variant in variants if _is_right(variant, stated)]
        # a text of no variant may have been corrected in the system; that of another variant
        # is a contradiction
        return [variant for variant in likely if not by_text or variant in by_text]

    def _of_text(self, variants: Sequence[Variant], text: str) -> list[Variant]:
        """The variants whose statement a text contains; none where it is empty or that of no
        variant.
        """
        from kinegrade.exam.quiz.variants import of_text  # noqa: PLC0415  # takes seconds to load

        return of_text(variants, text) if trim(text) else []


def _are_alike(variants: Sequence[Variant]) -> bool:
    """Whether students could not tell variants apart: they differ in no given that is printed."""
    first, *others = variants
    return all(each.right == first.right and each.texts == first.texts for each in others)


def _is_right(variant: Variant, stated: Sequence[tuple[str, float]]) -> bool:
    return all(
        name in variant.right and agree(value, variant.right[name], _SAME) for name, value in stated
    )
