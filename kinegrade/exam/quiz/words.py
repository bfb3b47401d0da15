"""What a quiz on screen says of its rules: when an answer is right."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce

from kinegrade.exam.printing.rules import make_marking_rule
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message, Text
from kinegrade.numbers.tolerance import Tolerance


@dataclass(frozen=True)
class AskRule:
    """How far from right an ask's answer may be on a paper, by what the bank has stated, and the
    unit of that: a quiz has no table of units.
    """

    tolerance: Tolerance
    stated: Tolerance
    unit: str


def write_marking_rules(asks: Mapping[str, AskRule], language: Language) -> str:
    """When the answers of a question are right; `asks` holds the rules by symbol (math)."""
    rules = {
        symbol: make_marking_rule(ask.tolerance, ask.unit, ask.stated)
        for symbol, ask in asks.items()
    }
    written = write_sentences(_say_rules(rules), language)
    return write_decimals_of_prose(written, language)


def _say_rules(rules: Mapping[str, Message]) -> Iterator[Message]:
    """One sentence where all quantities have the same rule, else one for each."""
    distinct = set(rules.values())
    if len(distinct) == 1:
        yield Message("paper.rule", rule=distinct.pop())
        return
    for symbol, rule in rules.items():
        yield Message("paper.rule-of-quantity", symbol=symbol, rule=rule)


def write_sentences(sentences: Iterable[Text], language: Language) -> str:
    """Sentences one after another, with what the language puts between them; those that are empty
    left out.
    """
    catalogue = open_catalogue(language)
    written = filter(None, map(catalogue.write, sentences))
    return reduce(
        lambda first, second: catalogue.text("paper.sentences", first=first, second=second), written
    )
