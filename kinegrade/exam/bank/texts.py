"""The texts of a bank by language: its own, and those of the templates that it asks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.errors import BankError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.problem.template.texts import find_language_faults
from kinegrade.problem.template.translated import Translated


def require_bank_language(bank: Bank, language: Language) -> None:
    """Raises BankError, with a line for the bank and for each template that lack texts in a
    language.
    """
    templates = [question.template for question in bank.questions]
    own = _find_bank_faults(bank.texts, language)
    faults = (*own, *find_language_faults(templates, language))
    if faults:
        raise BankError(*faults)


def require_bank_texts(title: Translated, course: Translated, language: Language) -> None:
    """Raises BankError where a bank lacks its title or course in a language."""
    faults = tuple(_find_bank_faults({"title": title, "course": course}, language))
    if faults:
        raise BankError(*faults)


def _find_bank_faults(texts: Mapping[str, Translated], language: Language) -> Iterator[Fault]:
    missing = [name for name, text in texts.items() if not text.has(language)]
    if missing:
        yield Fault(
            "bank",
            Message("texts.lacks", language=language, names=list_plainly(missing)),
            Message("texts.all-in", language=language),
            Message("texts.write-bank-file", language=language),
        )
