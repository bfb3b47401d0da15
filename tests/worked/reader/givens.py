"""What the reader of a worked solution has in hand: the statement and its figure."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.problem.as_stated import restate
from kinegrade.problem.solution import Solution
from tests.worked.reader.amounts import Amount, make_exact
from tests.worked.reader.formula_reader import read_unit

BODY = "体"  # stands for any name: a Chinese sentence has no space beside it
LETTER = re.compile(r"[A-Z](?:'|_\{\d\}|_\d)*")


def read_givens(solution: Solution) -> Iterator[tuple[str, Amount]]:
    """The symbols of the statement with their values, which are exact."""
    stated = restate(solution)
    for name, quantity in stated.parameters.items():
        symbol = re.sub(r"_(\w)(?!\w)", r"_{\1}", stated.template.parameters[name].symbol)
        if quantity.measure.degrees:
            yield symbol.replace(" ", ""), make_exact(math.radians(quantity.value))
            continue
        unit = read_unit(quantity.unit)
        value = quantity.value * unit.value
        yield symbol.replace(" ", ""), make_exact(value, unit.metres, unit.seconds)


def find_letters(solution: Solution) -> frozenset[str]:
    """The letters of points that the statement and the asks name."""
    template = solution.template
    wordings = [wording for wordings in template.words.texts.values() for wording in wordings]
    texts = [template.words.statement.in_language("en")]
    texts += [wording.text.in_language("en") for wording in wordings]
    texts += [ask.symbol for ask in template.asks.values()]
    found = {letter for text in texts for letter in LETTER.findall(text)}
    return frozenset(re.sub(r"_(\w)$", r"_{\1}", letter) for letter in found)


def find_introduced(prose: str) -> Iterator[str]:
    """The point that a sentence of the solution introduces, in any language."""
    for language in known_languages():
        message = Message("solution.unmarked-contact", body=BODY, point="POINT")
        pattern = re.escape(write_sentence(message, language))
        found = re.fullmatch(pattern.replace(BODY, ".*").replace("POINT", "(.*)"), prose)
        if found:
            yield found[1]
