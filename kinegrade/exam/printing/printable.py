"""Whether the texts of a template can be printed: all that papers may show, in every language,
whatever is asked.

`kinegrade check` calls it, so that the author finds an unfinished formula before papers are made.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kinegrade.errors import Problem, TypesetError
from kinegrade.files.fields.place import key_path
from kinegrade.language import ENGLISH
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.language.message import Fault, Location, Message
from kinegrade.language.prose.typst import write_line, write_prose
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.statement import list_statement_languages, write_specimens
from kinegrade.problem.template.slots import find_slots, find_slots_in_formulas
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import list_lines

_Writer = Callable[[str, str], str]  # takes a text and its place, gives Typst code


def find_printing_faults(template: Template) -> list[Problem]:
    """What keeps texts of a template from being printed, each with its place; empty where nothing
    does.
    """
    faults: list[Problem] = []
    codes: dict[str, str] = {}
    for where, text, written in _list_texts(template):
        try:
            codes[where] = written(text, where)
        except TypesetError as error:
            faults += error.faults
    return list(dict.fromkeys([*faults, *_find_refused(codes), *_find_unfilled(template)]))


def _find_refused(codes: dict[str, str]) -> list[Problem]:
    """The typesetter's complaints about codes, given by their places: all are tried at once, and
    one by one only if that is refused.
    """
    press = TypstPress()
    try:
        press.require_printable("\n".join(codes.values()), "texts")
    except TypesetError:
        faults: list[Problem] = []
        for where, code in codes.items():
            try:
                press.require_printable(code, where)
            except TypesetError as error:
                faults += error.faults
        return faults
    return []


def _find_unfilled(template: Template) -> Iterator[Fault]:
    """Slots where nothing is filled in: they would be printed with their braces."""
    for place, translated in list_lines(template):
        for where, text in translated.list_written(place):
            inside = find_slots_in_formulas(text)
            for slot in find_slots(text):
                if slot not in inside:
                    what = Message("exam.slot-not-filled", name=slot.name)
                    yield Fault(key_path(where), what)


def _list_texts(template: Template) -> Iterator[tuple[str, str, _Writer]]:
    """Every text with its place in the template and what writes it."""
    for name, parameter in template.parameters.items():
        yield f"parameters.{name}.symbol", parameter.symbol, _write_symbol
    for name, ask in template.asks.items():
        yield f"asks.{name}.symbol", ask.symbol, _write_symbol
    for language in list_statement_languages(template):
        for where, text in write_specimens(template, language):
            yield key_path(where), text, _write_prose
    for place, translated in list_lines(template):
        for where, text in translated.list_written(place):
            yield key_path(where), text, _write_line


def _write_symbol(latex: str, where: Location) -> str:
    return f"#[${write_typst_math(latex, where)}$]"


def _write_prose(markdown: str, where: Location) -> str:
    return f"#{write_prose(markdown, where, ENGLISH)}"


def _write_line(markdown: str, where: Location) -> str:
    return f"#{write_line(markdown, where, ENGLISH)}"
