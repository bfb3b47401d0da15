"""What every description promises, read off its text alone: its numbers are those of the statement,
and none of its measures is the value of what is asked.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from kinegrade.description.description import describe
from kinegrade.description.said import Description
from kinegrade.language import Language
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.statement import write_statement

_INDEX = re.compile(r"_\{[^}]*\}|_\w|\\unit\{[^}]*\}")
_NUMBER = re.compile(r"\d+(?:(?:\.|\{,\})\d+)?")
_GIVEN = re.compile(r"\$[^$]*\\unit[^$]*\$|\$[^$]*= -?[\d.{},]+(?:\^\\circ)?\$")
# Of constructions, the same at every draw: halves and doubles, right and straight angles
_STRUCTURE = frozenset({"0", "1", "2", "90", "180", "270"})
_LONGEST = 125
_DIGITS = (3, 4, 6)


def find_numbers(prose: str) -> set[str]:
    """The numbers of a text, without indices and units."""
    return set(_NUMBER.findall(_INDEX.sub("", prose)))


def find_faults(solution: Solution, asks: Collection[str], language: Language) -> Iterator[str]:
    """What is wrong with the description of a question that asks for these."""
    described = describe(solution, language, asks)
    if described is not None:
        yield from list_faults(described, solution, asks, language)


def list_faults(
    described: Description, solution: Solution, asks: Collection[str], language: Language
) -> Iterator[str]:
    """What is wrong with this description of it."""
    statement = write_statement(solution.template, solution.parameters, language, asks)
    text = "\n".join(part.text for part in described.long)
    for number in find_numbers(text) - find_numbers(statement) - _STRUCTURE:
        yield f"{number} is not printed in the statement"
    for given in _GIVEN.findall(text):
        value = given.split("=")[-1].strip(" $")
        if given not in statement and value not in statement and value not in _STRUCTURE:
            yield f"{given} is not printed in the statement"
    if len(described.short) > _LONGEST or "$" in described.short:
        yield f"no short text: {described.short}"
    for name in solution.keys() & set(asks):
        yield from _find_told(solution[name], described, statement)


def _find_told(answer: Quantity, described: Description, statement: str) -> Iterator[str]:
    """Whether an answer is told that the statement does not print itself: exact, or rounded."""
    text = "\n".join((described.short, *(part.text for part in described.long)))
    if answer.at_infinity or answer.is_zero:
        return
    printed = {answer.size.decimal(digits) for digits in _DIGITS}
    told = (printed & find_numbers(text.replace("{,}", "."))) - _STRUCTURE
    if told - find_numbers(statement.replace("{,}", ".")):
        yield f"{answer.name} = {told} is told"
    exact = answer.size.latex
    if exact is None or exact.isdigit():
        return
    if f"= {exact}" in text and f"= {exact}" not in statement:
        yield f"{answer.name} = {exact} is told"
