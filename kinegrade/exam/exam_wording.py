"""What an exam's questions, asks and drawn numbers are called, from the templates that its folder
keeps.

Reports and feedback show it (`kinegrade.grading.wording` defines what they need). If this version
can no longer read a template, only its words are lost: identifiers replace them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from kinegrade.errors import BankError, ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.language import Language
from kinegrade.problem.printed_givens import find_printed_givens
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import find_language_faults, require_language
from kinegrade.students.mistaking.mistake_names import describe_all_mistakes


@dataclass(frozen=True)
class ExamWording:
    """Titles by question, meanings and sign conventions by answer column (prose), symbols (math),
    units of printed givens, sentences of mistakes, names of the exam and the course (plain).
    """

    titles: Mapping[str, str] = field(default_factory=dict)
    meanings: Mapping[str, str] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[tuple[str, str], str] = field(default_factory=dict)
    conventions: Mapping[str, str] = field(default_factory=dict)
    givens: Mapping[tuple[str, str], str] = field(default_factory=dict)
    mistakes: Mapping[str, str] = field(default_factory=dict)
    exam: str = ""
    course: str = ""


def read_exam_wording(exam: ExamFolder, language: Language) -> ExamWording:
    """The words of an exam in a language. Raises TemplateError where its templates lack it."""
    templates = exam.templates.readable
    require_language(templates.values(), language)
    asks = {
        f"{question}.{name}": ask
        for question, template in templates.items()
        for name, ask in template.asks.items()
    }
    title, course, by_hand = _read_names(exam, language)
    titles = {name: each.about.title.in_language(language) for name, each in templates.items()}
    return ExamWording(
        {**titles, **by_hand},
        {column: ask.means.in_language(language) for column, ask in asks.items()},
        {column: ask.symbol for column, ask in asks.items()},
        {
            (question, name): parameter.symbol
            for question, template in templates.items()
            for name, parameter in template.parameters.items()
        },
        {column: write_sign(ask.sign, language) for column, ask in asks.items()},
        dict(_list_givens(exam, templates)),
        describe_all_mistakes(templates.values(), language),
        title,
        course,
    )


def read_nearest_wording(exam: ExamFolder, language: Language) -> ExamWording:
    """The words of an exam in a language, or in that of the papers where a template lacks it."""
    lacking = find_language_faults(exam.templates.readable.values(), language)
    return read_exam_wording(exam, exam.language if lacking else language)


def _read_names(exam: ExamFolder, language: Language) -> tuple[str, str, Mapping[str, str]]:
    """The names of exam and course, and the titles of questions marked by hand; those on the papers
    where the bank does not have all of them in the language.
    """
    head = exam.head
    stated = head.title, head.course, {each.question: each.title for each in head.by_hand}
    if language == exam.language:
        return stated
    try:
        bank = KeptExam(exam).bank
    except (BankError, ExamError):  # as earlier versions kept it
        return stated
    if not all(text.has(language) for text in bank.texts.values()):
        return stated
    by_hand = {each.identifier: each.title.in_language(language) for each in bank.by_hand}
    return bank.title.in_language(language), bank.course.in_language(language), by_hand


def _list_givens(
    exam: ExamFolder, templates: Mapping[str, Template]
) -> Iterator[tuple[tuple[str, str], str]]:
    """The unit of each drawn number that a paper prints, by question and name."""
    for question, template in templates.items():
        asks = [ask.ask for ask in exam.asks if ask.question == question]
        printed = find_printed_givens(template, [name for name in asks if name in template.asks])
        for name, parameter in template.parameters.items():
            if name in printed:
                yield (question, name), parameter.unit.text
