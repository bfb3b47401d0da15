"""What a quiz needs of an exam besides the papers' lines of the key: title, templates, tolerances,
credits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from hashlib import sha256
from hmac import digest

import msgspec

from kinegrade.errors import FieldError
from kinegrade.exam.bank.bank import read_bank_texts
from kinegrade.exam.bank.blueprint import BankAsk
from kinegrade.exam.bank.texts import require_bank_texts
from kinegrade.exam.folder.contents import BANK
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import describe_damage, explain_broken
from kinegrade.exam.folder.key.exact_keys import read_rule
from kinegrade.exam.folder.key.lines import StatedAnswer
from kinegrade.exam.quiz.words import AskRule
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import state_tolerance
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.written import NumberError, read_number
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import require_language

_DIGITS = 8  # hexadecimal, of the identifier


@dataclass(frozen=True)
class QuizSource:
    """An exam of which a quiz is made; `identifier` distinguishes it from other exams.

    It is derived from the bank and from the secret behind the papers' codes, which reveals nothing
    about the secret that draws the numbers: another exam of the same bank has another identifier,
    and the roster and its order do not matter.

    `templates` are by question; `credits` are the shares of the points that the bank gives for
    known mistakes, by mistake; `kept` has the bank, whose `asks` are by question and name, and
    derives worked solutions.
    """

    exam: ExamFolder
    identifier: str
    language: Language
    title: str
    course: str
    templates: Mapping[str, Template]
    credits: Mapping[str, Fraction]
    kept: KeptExam
    asks: Mapping[tuple[str, str], BankAsk]

    def rule(self, question: str, ask: str, kept: StatedAnswer) -> AskRule:
        """When an answer is right, by what a paper's key keeps of it. Raises FieldError, also for
        an ask that the bank does not have.
        """
        asked = self.asks.get((question, ask))
        if asked is None:
            raise FieldError(Message("exam.not-in", name=f"{question}.{ask}", file=BANK))
        tolerance = state_tolerance(asked, read_rule(kept.tolerance))
        return AskRule(tolerance, asked.tolerance, kept.unit)


def read_quiz_source(exam: ExamFolder, language: Language | None = None) -> QuizSource:
    """What a quiz needs of an exam; in the papers' language unless another one is wanted.

    Raises ExamError, with the faults of all templates; TemplateError or BankError where they lack
    the language, BankError where the bank cannot be read.
    """
    title, course = exam.head.title, exam.head.course
    templates = exam.templates.all()
    if language and language != exam.language:
        require_language(templates.values(), language)
        title, course = _translate(exam, language)
    kept = KeptExam(exam)
    return QuizSource(
        exam,
        _make_identifier(exam),
        language or exam.language,
        title,
        course,
        templates,
        _read_credits(exam),
        kept,
        {(each.identifier, ask.name): ask for each in kept.bank.questions for ask in each.asks},
    )


def list_own_sources(source: QuizSource) -> dict[Language, QuizSource]:
    """The same for each language that students have of their own. Raises what `read_quiz_source`
    does.
    """
    stated = {each.language for each in source.exam.head.students} - {"", source.language}
    found = {}
    for language in map(Language, sorted(stated)):
        require_language(source.templates.values(), language)
        title, course = _translate(source.exam, language)
        found[language] = replace(source, language=language, title=title, course=course)
    return found


def _make_identifier(exam: ExamFolder) -> str:
    """The exam's identifier; if the secret was taken out of the folder, derived from the first
    paper's code.
    """
    secret = exam.head.drawn_from
    if secret is None:
        first = exam.head.students[0].paper
        return sha256(f"{first}\n{exam.bank}".encode()).hexdigest()[:_DIGITS]
    return digest(secret.coding.encode(), f"quiz\n{exam.bank}".encode(), "sha256").hex()[:_DIGITS]


def _translate(exam: ExamFolder, language: Language) -> tuple[str, str]:
    """Title and course in another language. Raises BankError where the bank lacks them."""
    title, course = read_bank_texts(exam.path / BANK)
    require_bank_texts(title, course, language)
    return title.in_language(language), course.in_language(language)


def _read_credits(exam: ExamFolder) -> dict[str, Fraction]:
    """The shares of the points that the bank gives for known mistakes. Raises ExamError."""
    stated = (exam.head.credit or {}).get("mistakes", {})
    try:
        shares = msgspec.convert(stated, dict[str, object])
        return {name: read_number(share) for name, share in shares.items()}
    except (msgspec.ValidationError, NumberError) as fault:
        raise explain_broken(exam.path, [Fault("credit", describe_damage(fault))]) from fault
