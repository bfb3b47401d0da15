"""The nodes of a formula in the words of one language, not yet tidied into a line."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import assert_never

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.math.letters import GREEK, name_sign
from kinegrade.language.math.spacing import is_spaced
from kinegrade.language.math.spoken.shape import is_label, is_one, is_product
from kinegrade.language.math.spoken.units import find_unit, speak_unit
from kinegrade.language.math.tree import (
    Accent,
    AccentName,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    SpaceName,
    Style,
    Text,
    Unit,
    split_row,
)
from kinegrade.language.math.units import raise_exponents

_DECIMAL_COMMA = Sign("{,}")
_SIGNS_OF_NUMBERS = (Sign("+"), Sign("-"))


def say(words: Catalogue, row: Row) -> str:
    """A row in words, not yet tidied."""
    said = ""
    for place, node in enumerate(row):
        glued = place > 0 and _DECIMAL_COMMA in (node, row[place - 1])
        said += ("" if glued else " ") + _say_at(words, row, place)
    return said


def _say_at(words: Catalogue, row: Row, place: int) -> str:
    node, unit = row[place], _find_unit_at(row, place)
    if unit is not None:
        return speak_unit(unit, words, count=_count(row, place))
    if isinstance(node, Sign) and node in _SIGNS_OF_NUMBERS and not is_spaced(row, place):
        return words.text(f"spoken.unary-{name_sign(node.latex)}")
    return _say_node(words, node)


def _say_node(words: Catalogue, node: Node) -> str:
    match node:
        case Letter(letter):
            return _say_letter(words, letter)
        case Number(digits):
            return digits
        case Sign(latex):
            return _say_sign(words, latex)
        case Function(function):
            return words.text(f"spoken.function-{function}")
        case Text(text):
            return raise_exponents(text)
        case Unit(text):
            return speak_unit(text, words)
        case Space(space):
            return _say_space(words, space)
        case LineBreak():
            return words.text("spoken.line-end")
        case Mark():
            return ""
        case Scripts():
            return _say_scripts(words, node)
        case _:
            return _say_rows(words, node)


def _say_letter(words: Catalogue, letter: str) -> str:
    if letter not in GREEK:
        return letter
    plain = words.text(f"spoken.letter-{letter.lower().removeprefix('var')}")
    return words.text("spoken.capital", letter=plain) if letter[0].isupper() else plain


def _say_sign(words: Catalogue, latex: str) -> str:
    is_decimal = latex == _DECIMAL_COMMA.latex
    return "," if is_decimal else words.text(f"spoken.sign-{name_sign(latex)}")


def _say_space(words: Catalogue, space: SpaceName) -> str:
    """Wide room stands between statements: a pause."""
    match space:
        case "quad" | "qquad":
            return words.text("spoken.pause")
        case "," | ";" | ":" | "!" | " ":
            return ""
        case _:
            assert_never(space)


def _say_rows(
    words: Catalogue, node: Group | Quotient | Root | Lettering | Accent | Fenced | Environment
) -> str:
    match node:
        case Group(row):
            return say(words, row)
        case Quotient(_, above, below):
            return _say_quotient(words, above, below)
        case Root(radicand, degree):
            return _say_root(words, radicand, degree)
        case Lettering(style, row):
            return _say_lettering(words, style, row)
        case Accent(accent, row):
            return _say_accent(words, accent, row)
        case Fenced(left, row, right):
            return _say_fenced(words, left, row, right)
        case Environment(_, row):
            return words.text("spoken.line-end").join(
                say(words, line) for line in split_row(row, LineBreak)
            )
        case _:
            assert_never(node)


def _say_quotient(words: Catalogue, above: Row, below: Row) -> str:
    is_short = is_product(above) and is_one(below)
    return words.text(
        "spoken.quotient" if is_short else "spoken.long-quotient",
        above=say(words, above),
        below=say(words, below),
    )


def _say_root(words: Catalogue, radicand: Row, degree: Row | None) -> str:
    said = say(words, radicand)
    if degree is not None:
        return words.text("spoken.other-root", degree=say(words, degree), radicand=said)
    return words.text("spoken.root" if is_one(radicand) else "spoken.long-root", radicand=said)


def _say_lettering(words: Catalogue, style: Style, row: Row) -> str:
    """Upright letters are a word; a bold letter is a vector."""
    match style:
        case "mathrm" if all(isinstance(node, Letter) for node in row):
            letters = [node.name for node in row if isinstance(node, Letter)]
            return "".join(_say_letter(words, letter) for letter in letters)
        case "mathrm" | "mathit":
            return say(words, row)
        case "mathbf" | "boldsymbol":
            is_word = all(isinstance(node, Letter) for node in row)
            return words.text("spoken.vector" if is_word else "spoken.bold", row=say(words, row))
        case _:
            assert_never(style)


def _say_accent(words: Catalogue, accent: AccentName, row: Row) -> str:
    match accent:
        case "boxed":
            return say(words, row)
        case "vec" | "overrightarrow":
            return words.text("spoken.vector", row=say(words, row))
        case "bar" | "overline":
            return words.text("spoken.accent-bar", row=say(words, row))
        case "hat" | "widehat":
            return words.text("spoken.accent-hat", row=say(words, row))
        case "tilde" | "dot" | "ddot" | "underbrace":
            return words.text(f"spoken.accent-{accent}", row=say(words, row))
        case _:
            assert_never(accent)


def _say_fenced(words: Catalogue, left: str, row: Row, right: str) -> str:
    said = say(words, row)
    match left, right:
        case "|", "|":
            return words.text(
                "spoken.magnitude" if is_one(row) else "spoken.long-magnitude", row=said
            )
        case _:
            return f"{_say_bracket(words, left)} {said} {_say_bracket(words, right)}"


def _say_bracket(words: Catalogue, bracket: str) -> str:
    return "" if bracket == "." else _say_sign(words, bracket)


@lru_cache(maxsize=2048)  # symbols with their indices, which formulas have again and again
def _say_scripts(words: Catalogue, node: Scripts) -> str:
    return " ".join(_list_scripts(words, node))


def _list_scripts(words: Catalogue, node: Scripts) -> Iterator[str]:
    if node.base is not None:
        said = _say_node(words, node.base)
        is_many = isinstance(node.base, Group) and not is_one(node.base.row)
        yield words.text("spoken.group", row=said) if is_many else said
    yield from (words.text("spoken.sign-prime") for _ in range(node.primes))
    if node.lower is not None:
        said = say(words, node.lower)
        yield said if is_label(node.lower) else words.text("spoken.index", row=said)
    if node.upper is not None:
        yield _say_raised(words, node.base, node.upper)


def _say_raised(words: Catalogue, base: Node | None, upper: Row) -> str:
    match upper:
        case (Sign(r"\circ"),):
            count = 1 if base == Number("1") else 2
            return speak_unit("deg", words, count=count)
        case (Number("2"),):
            return words.text("spoken.squared")
        case (Number("3"),):
            return words.text("spoken.cubed")
        case (Lettering("mathrm", _),):
            return words.text("spoken.label-above", row=say(words, upper))
        case _:
            is_short = is_one(upper) or (upper[:1] == (Sign("-"),) and is_one(upper[1:]))
            return words.text(
                "spoken.power" if is_short else "spoken.long-power", row=say(words, upper)
            )


def _count(row: Row, place: int) -> int:
    """1 where a unit follows the number 1 alone, which takes the singular."""
    before = [node for node in row[:place] if not isinstance(node, Space)]
    return 1 if before[-1:] == [Number("1")] else 2


def _find_unit_at(row: Row, place: int) -> str | None:
    """A unit, or one that upright letters spell after a thin space."""
    match row[place]:
        case Unit(text):
            return text
        case Lettering("mathrm", letters) if place > 0 and row[place - 1] == Space(","):
            return find_unit(letters)
        case _:
            return None
