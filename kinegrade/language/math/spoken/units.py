"""Units in words: metres per second squared."""

from __future__ import annotations

import re
from functools import lru_cache

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.math.tree import Letter, Node, Number, Row, Scripts, Sign
from kinegrade.language.math.units import raise_exponents

_FACTOR = re.compile(r"(?P<mark>[*/]?)(?P<name>[A-Za-z]+|1)(?:\^\{?(?P<power>-?[0-9]+)\}?)?")
_MANY = 2  # any number but one, which a unit in front of "per" takes in English


def find_unit(row: Row) -> str | None:
    r"""The text of the unit that letters spell; None where they spell none.

    >>> find_unit((Letter("m"), Sign("/"), Scripts(Letter("s"), None, 0, (Number("2"),))))
    'm/s^2'
    """
    text = "".join(map(_spell, row))
    return text if _FACTOR.match(text) and _split(text) else None


def _spell(node: Node) -> str:
    match node:
        case Letter(letter):
            return letter
        case Sign("/" | "-" as sign):
            return sign
        case Sign(r"\cdot"):
            return "*"
        case Number(digits):
            return digits
        case Scripts(base, None, 0, upper) if base is not None and upper is not None:
            return f"{_spell(base)}^{''.join(map(_spell, upper))}"
        case _:
            return "?"  # which no unit holds


@lru_cache(maxsize=256)
def speak_unit(unit: str, catalogue: Catalogue, count: int = _MANY) -> str:
    """A unit in words, after one of it or several; one that has no words as it is printed.

    >>> from kinegrade.language import Language
    >>> from kinegrade.language.catalogue import open_catalogue
    >>> speak_unit("m/s^2", open_catalogue(Language("en")))
    'metres per second squared'
    """
    factors = _split(unit)
    if not factors or any(not catalogue.has(f"spoken.unit-{name}") for _, name, _ in factors):
        return raise_exponents(unit)
    above = [(name, power) for mark, name, power in factors if mark != "/" and power > 0]
    below = [(name, abs(power)) for mark, name, power in factors if mark == "/" or power < 0]
    said = [_raise(catalogue, name, power, count) for name, power in above]
    for name, power in below:
        said.append(catalogue.text("spoken.per", unit=_raise_divisor(catalogue, name, power)))
    return " ".join(said)


def _split(unit: str) -> list[tuple[str, str, int]]:
    """The factors of a unit, each with its mark and its power; none for what is no unit."""
    found = list(_FACTOR.finditer(unit))
    if "".join(factor[0] for factor in found) != unit:
        return []
    return [(each["mark"], each["name"], int(each["power"] or 1)) for each in found]


def _raise(catalogue: Catalogue, name: str, power: int, count: int) -> str:
    word = catalogue.text(f"spoken.unit-{name}", count=count)
    match power:
        case 1:
            return word
        case 2:  # one word in German: Quadratmeter
            return catalogue.text("spoken.square", unit=word.lower())
        case _:
            return catalogue.text("spoken.power-of-unit", unit=word, power=str(power))


def _raise_divisor(catalogue: Catalogue, name: str, power: int) -> str:
    word = catalogue.text(f"spoken.unit-{name}", count=1)
    match power:
        case 1:
            return word
        case 2:
            return catalogue.text("spoken.divisor-square", unit=word)
        case _:
            return catalogue.text("spoken.divisor-power", unit=word, power=str(power))
