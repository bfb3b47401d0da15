"""The report on answers that fit other papers: a table, and a few sentences on what it means and
does not mean.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from kinegrade.files.csv_writing import encode_for_people, neutralise, write_csv_text
from kinegrade.grading.poisson import QUESTIONS_THAT_TELL
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Message, list_statements
from kinegrade.reports.sharing.search import Pair, SharedAnswer
from kinegrade.reports.sharing.sharing import MOST, Sharing

HEADER = (
    "student", "name", "other", "other_name", "wrong_answers", "fit_the_other_paper",
    "expected_by_chance",
    "right_there", "right_there_expected", "chance_in_the_class", "answers", "note",
)  # fmt: skip


def write_sharing_csv(sharing: Sharing, language: Language) -> bytes:
    """A CSV file with a line for each pair; cells that a spreadsheet might run are made harmless,
    ids stay unchanged.
    """
    catalogue = open_catalogue(language)
    rows = (_write_row(pair, catalogue) for pair in sharing.reported)
    return encode_for_people(write_csv_text(HEADER, rows))


def _write_row(pair: Pair, catalogue: Catalogue) -> tuple[str, ...]:
    right = sum(answer.as_key for answer in pair.answers)
    answers = catalogue.write(list_statements(map(_describe_answer, pair.answers)))
    return (
        pair.student.student, neutralise(pair.student.name),
        pair.other.student, neutralise(pair.other.name),
        str(pair.wrong), str(len(pair.answers)), f"{pair.expected:.2g}",
        str(right), f"{pair.as_key_expected:.2g}",
        f"{pair.chance:.1e}", neutralise(answers), catalogue.text("sharing.note"),
    )  # fmt: skip


def _describe_answer(answer: SharedAnswer) -> Message:
    typed = answer.typed.strip()
    if answer.as_key:
        return Message("sharing.right-there", column=answer.column, typed=typed)
    return Message("sharing.mistake-there", column=answer.column, typed=typed)


def describe_sharing(sharing: Sharing) -> Iterator[Message]:
    """The same for a person, without names: how much was found, and how it may and may not be
    read.
    """
    level = Decimal(f"{100 * sharing.level:g}")
    if sharing.found:
        yield Message("sharing.found", count=sharing.found, pairs=sharing.pairs, level=level)
        yield Message("sharing.only-a-hint")
    else:
        share = Message("grammar.percent", number=level)
        yield Message("sharing.none-found", pairs=sharing.pairs, level=share)
    if sharing.found > MOST:
        yield Message("sharing.most", most=MOST)
    yield from _describe_limits(sharing)


def _describe_limits(sharing: Sharing) -> Iterator[Message]:
    """What this exam cannot show."""
    if sharing.questions < QUESTIONS_THAT_TELL:
        yield Message("sharing.one-question")
    if sharing.papers < sharing.students:
        students, papers = sharing.students, sharing.papers
        yield Message("sharing.few-papers", students=students, papers=papers)
