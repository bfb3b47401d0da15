"""Points that the statement names and that do not exist, or that the figure does not letter: only
those of bodies, joints and circles have letters. And bodies that are named by a word which the
catalogues do not know, and so have no name in some of a template's languages.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinegrade.figure.sketch import sketch
from kinegrade.language import ENGLISH
from kinegrade.language.message import Message, list_plainly
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import find_used_languages
from kinegrade.problem.template.translated import Translated
from kinegrade.proof.symbols import note_shared_symbols, note_unexplained_letters
from kinegrade.worked.words.bodies import is_kind, is_word

_FORMULA = re.compile(r"\$([^$\n]+)\$")
_LETTER = re.compile(r"[A-Z](?:_\d+)?'*", re.ASCII)  # A, O_1, B'
_LETTERS = re.compile(rf"(?:\\(?:angle|triangle)\s*)?((?:{_LETTER.pattern})+)", re.ASCII)


def note_letters(template: Template) -> Iterator[Message]:
    """A remark for each letter of the statement and of the figure that cannot be what it seems."""
    yield from note_unknown_points(template)
    yield from note_renamed_points(template)
    yield from note_shared_symbols(template)
    yield from note_unexplained_letters(template, _list_formulas(template))
    yield from note_unnamed_bodies(template)


def note_unknown_points(template: Template) -> Iterator[Message]:
    """A remark for each letter of a point, alone or as in OA or an angle, that the statement has
    and nothing in the file.
    """
    named = [letter for formula in _list_formulas(template) for letter in _find_letters(formula)]
    for letter in dict.fromkeys(named):
        if letter not in _list_known_letters(template):
            yield Message("template.no-such-point", point=letter)


def note_renamed_points(template: Template) -> Iterator[Message]:
    """A remark for each point that the figure letters as another: worked solutions go by its name
    in the file.
    """
    for point in template.scheme.points:
        label, symbol = template.figure.labels.get(point), write_point_symbol(point)
        if label and _LETTER.fullmatch(_plain(label)) and _plain(label) != _plain(symbol):
            yield Message("template.renamed-point", point=_plain(symbol), label=_plain(label))


def note_unnamed_bodies(template: Template) -> Iterator[Message]:
    """A remark for each of them. The word itself is taken for English where there are English
    texts, else for the language in which the template has its first texts.
    """
    used = find_used_languages(template)
    own = ENGLISH if ENGLISH in used else next(iter(used), ENGLISH)
    for body in template.scheme.bodies:
        if is_word(body.name) and not is_kind(body.name.rstrip("0123456789")):
            called = template.words.called.get(body.name, Translated())
            lacking = [each for each in used if each != own and not called.has(each)]
            if lacking:
                yield Message(
                    "template.unnamed-body", body=body.name, languages=list_plainly(lacking)
                )


def _find_letters(formula: str) -> list[str]:
    """The letters of a formula that consists of points."""
    points = _LETTERS.fullmatch(formula)
    return _LETTER.findall(points.group(1)) if points else []


def _list_known_letters(template: Template) -> set[str]:
    """The letters in the names of points and bodies, in labels and in symbols."""
    names = (*template.scheme.points, *(body.name for body in template.scheme.bodies))
    symbols = (
        *map(write_point_symbol, names),
        *filter(None, template.figure.labels.values()),
        *(given.symbol for given in template.parameters.values()),
        *(ask.symbol for ask in template.asks.values()),
    )
    return {letter for symbol in symbols for letter in _LETTER.findall(_plain(symbol))}


def note_points_without_letter(
    template: Template, examples: Iterable[Solution]
) -> Iterator[Message]:
    """A remark for each point that a formula of the statement consists of, and no letter of the
    figures of these instances. Raises TemplateError as `sketch` does.
    """
    hints = mark_question(template, template.asked())
    for example in examples if template.scheme.has_mechanism else ():
        shown = _list_letters(example, hints)
        for point in _find_named_points(template):
            symbol = write_point_symbol(point)
            if not {_plain(symbol), _plain(hints.labels.get(point) or symbol)} & shown:
                yield Message("template.no-letter", point=point)


def _list_letters(example: Solution, hints: FigureHints) -> set[str]:
    scene = sketch(example.assembly.mechanism.map(float), hints)
    return {_plain(label.symbol) for label in scene.labels}


def _find_named_points(template: Template) -> Iterator[str]:
    named = set(_list_formulas(template))
    for point in template.scheme.points:
        if _plain(write_point_symbol(point)) in named:
            yield point


def _list_formulas(template: Template) -> list[str]:
    texts = template.words.statement.texts
    return [_plain(formula) for text in texts for formula in _FORMULA.findall(text)]


def _plain(symbol: str) -> str:
    """O_{1} is O_1."""
    return symbol.replace("{", "").replace("}", "")
