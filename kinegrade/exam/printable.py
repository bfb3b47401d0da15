"""Whether the texts of a template can be printed: all that papers may show, in every language,
whatever is asked.

`kinegrade check` calls it, so that the author finds an unfinished formula before papers are made.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kinegrade.errors import TypesetError
from kinegrade.exam.formula import formula
from kinegrade.exam.markup import line, prose
from kinegrade.exam.typst import TypstPress
from kinegrade.language import LANGUAGES, Language
from kinegrade.problem.slots import Slot, pieces, slots_in_formulas
from kinegrade.problem.statement import specimens
from kinegrade.problem.template import Template

Writer = Callable[[str, str], str]  # takes a text and its place, gives Typst code


def printing_faults(template: Template) -> list[str]:
    """What keeps texts of a template from being printed, each with its place; empty where nothing
    does.
    """
    faults: list[str] = []
    codes: dict[str, str] = {}
    for where, text, written in _texts(template):
        try:
            codes[where] = written(text, where)
        except TypesetError as error:
            faults += error.problems
    return list(dict.fromkeys([*faults, *_refused(codes), *_unfilled(template)]))


def _refused(codes: dict[str, str]) -> list[str]:
    """The typesetter's complaints about codes, given by their places: all are tried at once, and
    one by one only if that is refused.
    """
    press = TypstPress()
    try:
        press.require_printable("\n".join(codes.values()), "texts")
    except TypesetError:
        faults: list[str] = []
        for where, code in codes.items():
            try:
                press.require_printable(code, where)
            except TypesetError as error:
                faults += error.problems
        return faults
    return []


def _unfilled(template: Template) -> Iterator[str]:
    """Slots where nothing is filled in: they would be printed with their braces."""
    for language in LANGUAGES:
        for where, text in _lines(template, language):
            inside = slots_in_formulas(text)
            for slot in pieces(text):
                if isinstance(slot, Slot) and slot not in inside:
                    yield (
                        f"{where}: {{{{ {slot.name} }}}}: nothing is filled in here: "
                        "write it out, or put it into the statement"
                    )


def _texts(template: Template) -> Iterator[tuple[str, str, Writer]]:
    """Every text with its place in the template and what writes it."""
    for name, parameter in template.parameters.items():
        yield f"parameters.{name}.symbol", parameter.symbol, _symbol
    for name, ask in template.asks.items():
        yield f"asks.{name}.symbol", ask.symbol, _symbol
    for language in LANGUAGES:
        for where, text in specimens(template, language):
            yield where, text, _prose
        for where, text in _lines(template, language):
            yield where, text, _line


def _lines(template: Template, language: Language) -> Iterator[tuple[str, str]]:
    """The texts of one line with their places."""
    yield f"title.{language}", template.about.title.in_language(language)
    for name, parameter in template.parameters.items():
        yield f"parameters.{name}.means.{language}", parameter.means.in_language(language)
    for name, ask in template.asks.items():
        yield f"asks.{name}.means.{language}", ask.means.in_language(language)
        yield f"asks.{name}.sign.{language}", ask.sign.in_language(language)


def _symbol(latex: str, where: str) -> str:
    return f"#[${formula(latex, where)}$]"


def _prose(markdown: str, where: str) -> str:
    return f"#{prose(markdown, where)}"


def _line(markdown: str, where: str) -> str:
    return f"#{line(markdown, where)}"
