"""The instructor's key of each paper, as one value for every typesetter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.bank.by_hand import HandQuestion
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.printing.pages import write_version_name
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import SetAsk, SetPaper, SetQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimal_text, write_decimals_of_math
from kinegrade.press.paper_parts import write_points_in_words, write_share
from kinegrade.press.sheet import KeyAnswer, KeyBook, KeyEntry, KeyPaper, KeyParameter
from kinegrade.problem.quantity import Quantity


def make_key_book(
    bank: Bank, papers: Iterable[KeyPaper], language: Language, name: str = "key"
) -> KeyBook:
    """The instructor's book of that name: a key for each paper, which may come one after another,
    or for each version.
    """
    shown = _select_versions(tuple(papers), language) if bank.versions else papers
    return KeyBook(
        language,
        bank.course.in_language(language),
        bank.title.in_language(language),
        open_catalogue(language).text("paper.key-warning"),
        shown,
        name,
    )


def _select_versions(papers: Sequence[KeyPaper], language: Language) -> tuple[KeyPaper, ...]:
    """One key for each version that a student got, by letter."""
    first = {paper.version: paper for paper in reversed(papers)}
    return tuple(
        replace(first[letter], student="", name=write_version_name(letter, language), code=letter)
        for letter in sorted(first)
    )


def make_key_paper(bank: Bank, paper: SetPaper, language: Language) -> KeyPaper:
    """The key of one paper."""
    entries = [_make_key_entry(question, language) for question in paper.questions]
    for question in bank.by_hand:
        entries.insert(question.number - 1, _make_hand_entry(question, language))
    student = paper.student
    return KeyPaper(student.student, student.name, paper.code, tuple(entries), paper.version)


def make_kept_keys(kept: KeptExam, candidates: Iterable[Candidate]) -> Iterator[KeyPaper]:
    """The keys of papers that an exam has. Raises ExamError, BankError."""
    language = kept.exam.head.language
    return (make_key_paper(kept.bank, kept.paper(each), language) for each in candidates)


def _make_hand_entry(question: HandQuestion, language: Language) -> KeyEntry:
    """That a question is marked by hand."""
    words = open_catalogue(language)
    points = write_points_in_words(question.points, words, bonus=question.bonus)
    note = words.text("paper.by-hand", points=points)
    return KeyEntry(question.identifier, question.title.in_language(language), (), (), note)


def _make_key_entry(question: SetQuestion, language: Language) -> KeyEntry:
    """The key of one question."""
    template, solution = question.question.template, question.drawn.solution
    parameters = tuple(
        KeyParameter(
            template.parameters[name].symbol,
            None if quantity.is_plain else _write_exact(quantity, language),
            write_decimal_text(quantity.decimal(6), language),
            quantity.unit,
        )
        for name, quantity in solution.parameters.items()
    )
    answers = tuple(
        KeyAnswer(
            template.asks[entry.ask.name].symbol,
            _write_exact(entry.answer, language),
            write_decimal_text(entry.answer.decimal(6), language),
            entry.answer.unit,
            write_interval(entry, language),
            write_share(entry.ask.points, language, bonus=question.question.bonus),
        )
        for entry in question.asks
    )
    return KeyEntry(
        question.question.identifier,
        template.about.title.in_language(language),
        parameters,
        answers,
    )


def _write_exact(quantity: Quantity, language: Language) -> str | None:
    """The exact number in LaTeX math where it fits a line."""
    exact = quantity.closed_form
    return exact and write_decimals_of_math(exact, language)


def write_interval(entry: SetAsk, language: Language) -> str:
    """The closed interval of what is marked right, rounded to six figures for the reader."""
    ends = entry.tolerance.interval(_read_decimal(entry.answer))
    low, high = (write_decimal_text(f"{float(end):.6g}", language) for end in ends)
    return open_catalogue(language).text("paper.interval", low=low, high=high)


def _read_decimal(quantity: Quantity) -> Fraction:
    """The value to 40 digits as a fraction."""
    return Fraction(quantity.certified)
