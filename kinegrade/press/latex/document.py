r"""LaTeX sources, put together with PyLaTeX: the style `kinegrade.sty` holds the look, these the
content.

A body is one student's sheet; a document is a preamble with one body or with those of a whole
class. Comment lines that begin with two percent signs say which paper and question follows: faults
are named by them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from pylatex import Command, Document, NoEscape, Package
from pylatex.base_classes import Arguments, Environment, Options

from kinegrade.language import Language
from kinegrade.language.catalogue import PLACE, open_catalogue
from kinegrade.language.math.latex_text import write_plain, write_signed, write_unit
from kinegrade.press.sheet import PaperSize

_PLACES = ("page", "pages")  # of the fixed words: what the style gives them, in this order
_SIZE_OPTIONS: Mapping[PaperSize, tuple[str, ...]] = {"a4": (), "letter": ("letter",)}


class _Block(Environment):  # type: ignore[misc]  # pylatex has no types
    """An environment of the style."""

    content_separator = "\n"


def write_document(
    bodies: Iterable[str],
    language: Language,
    size: PaperSize,
    words: Mapping[str, str],
    fonts: str,
) -> str:
    """A whole LaTeX source; `words` holds the fixed words, `fonts` is the folder of the Chinese
    fonts.
    """
    whole = Document(
        documentclass="article",
        fontenc=None,
        inputenc=None,
        lmodern=False,
        textcomp=False,
        page_numbers=False,
        indent=True,
        microtype=False,
    )
    names = open_catalogue(language)
    script, hyphenation = names.text("language.page.script"), names.text("language.hyphenation")
    chosen = [script, hyphenation, *_SIZE_OPTIONS[size]]
    whole.packages.append(Package("kinegrade", options=chosen))
    whole.preamble.extend(_write_word(name, text) for name, text in words.items())
    whole.preamble.append(Command("chinesefonts", NoEscape(fonts)))
    whole.preamble.append(Command("documentlanguage", NoEscape(names.text("language.tag"))))
    whole.extend(NoEscape(body) for body in bodies)
    return str(whole.dumps())


def write_title(title: str) -> str:
    r"""The command that gives a file its title, as plain text.

    >>> write_title("Ω")
    '\\documenttitle{FEFF03A9}'
    """
    return write_command("documenttitle", f"FEFF{title.encode('utf-16-be').hex().upper()}")


def write_command(name: str, *arguments: str) -> str:
    r"""A LaTeX command with its arguments, which are LaTeX already.

    >>> print(write_command("ask", "v_B", "speed"))
    \ask{v_B}{speed}
    """
    return str(Command(name, Arguments(*map(NoEscape, arguments))).dumps())


def write_environment(name: str, lines: Iterable[str], *arguments: str, least: int = 0) -> str:
    """An environment of the style around lines that are LaTeX already, as are its arguments; one
    that has a `least` number of pages takes it as an option.
    """
    options = Options(least) if least else None
    block = _Block(options=options, arguments=Arguments(*map(NoEscape, arguments)))
    block.latex_name = name
    block.extend(map(NoEscape, lines))
    return str(block.dumps())


def write_value(decimal: str, unit: str) -> str:
    """A number with its unit, if it has one."""
    shown = "" if unit == "1" else write_unit(unit)
    space = "" if shown in ("", "°") else r"\,"
    return f"{write_signed(decimal)}{space}{shown}"


def _write_word(name: str, text: str) -> Command:
    """The fixed words as commands: `\\wordpage{1}{3}` where there are places for numbers."""
    pieces = PLACE.split(text)
    plain, places = pieces[::3], pieces[1::3]
    numbers = [_PLACES.index(place) + 1 for place in places]
    filled = [
        f"#{number}{write_plain(piece)}" for number, piece in zip(numbers, plain[1:], strict=True)
    ]
    return Command(
        "newcommand",
        NoEscape("\\word" + name.replace("-", "").replace("_", "")),
        Options(max(numbers)) if numbers else None,
        extra_arguments=NoEscape(write_plain(plain[0]) + "".join(filled)),
    )
