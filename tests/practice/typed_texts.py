"""Answers as people might type them, made up: numbers, formulas, units and senses in all spellings
that the reader knows, and what slips in between.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from kinegrade.grading.typed.sense import SENSE_WORDS
from kinegrade.grading.typed.unit_spelling import list_unit_names
from kinegrade.language.message import Message
from kinegrade.language.spellings import list_spellings

_NAMES = sorted(list_unit_names())
_SENSES = [word for entry in SENSE_WORDS.values() for word in list_spellings(entry)]
_PER, _SQUARED, _SQUARE, _ABOUT, _ROOT = (
    list_spellings(Message(key))
    for key in ("typing.per", "typing.squared", "typing.square", "marking.about", "typing.root")
)
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_WIDE = str.maketrans("0123456789.,-+/()", "０１２３４５６７８９．，－＋／（）")
_POWERS = ("1", "2", "2", "-1", "-2", "0", "3", "-3")
_LINKS = ("/", "/", "*", "·", " ", ".", "", "⋅", " / ", "//")
_BRACKETS = ("(%s)", "[%s]", "（%s）", "【%s】", "{%s}", "1/(%s)")
_GROUPS = (".", ",", "'", " ", "\u2009", "\u202f")
_LABELS = (
    "v_B = ",
    "ω=",
    "|a| = ",
    "ω_AB≈",
    "x: ",
    "v'=",
    "= ",
    "π = ",
    "up = ",
    "+",
    "-",
    "−",
    "– ",
)
_SLIPS = (
    "constructor", "toString", "__proto__", "straße", "ſ", "µ", "º", "˚", "′", '"', "\ufeff",
    "\u3000", "\u00a0", "\t", "½", "²", "∞", "≈", "<", "&", "nan", "Infinity", "0x1F", "e", "_",
    "|", "{", "}", "[", "]", "∙", "⁄", "÷", "٣", "Ⅳ", "一", "‰", "→", "↺", "**", "^", "1/", ";", "!",
)  # fmt: skip


def make_texts(random: Random, count: int) -> list[str]:
    """So many answers."""
    return [_make_text(random) for _ in range(count)]


def _make_text(random: Random) -> str:
    text = _write_value(random)
    if random.random() < 0.75:
        text += random.choice(("", " ", " ", "\u00a0", " * ")) + _write_unit(random)
    if random.random() < 0.1:
        text += random.choice((" ", "", " (", ", ")) + _change_case(random, _SENSES)
    if random.random() < 0.05:
        text = _change_case(random, _SENSES) + random.choice((" ", ": ", " = ", "")) + text
    if random.random() < 0.25:
        text = random.choice(_LABELS) + text
    if random.random() < 0.05:
        text = _change_case(random, _ABOUT) + random.choice((" ", "")) + text
    if random.random() < 0.06:
        text = text.translate(_WIDE)
    return _slip(random, text)


def _slip(random: Random, text: str) -> str:
    """Sometimes something slips in, or is left out."""
    place = random.randrange(len(text))
    share = random.random()
    if share < 0.08:
        return text[:place] + random.choice(_SLIPS) + text[place:]
    return text[:place] + text[place + 1 :] if share < 0.12 else text


def _change_case(random: Random, words: Sequence[str]) -> str:
    word = random.choice(words)
    return random.choice((word, word, word, word.upper(), word.lower(), word.capitalize()))


def _write_value(random: Random) -> str:
    one, other, third = (_write_number(random) for _ in range(3))
    root = random.choice((*_ROOT, "√", "sqrt"))
    if random.random() < 0.6:
        return one
    return random.choice((
        f"{root}{one}", f"{root} ({one})", f"{one}√{other}/{third}", f"√({one}+{other})", f"π/{one}",
        f"{one}π", f"{one} pi/{other}", f"2π*{one}", f"({one}/{other})", f"{one}+√{other}",
        f"{one}*{other}", f"({one})^{other}", f"({one})^2", f"{one}^(1/2)", f"{one}^0,5",
        f"({one}-√3)/2", f"1/({one}-{other})", f"{one}^-3",
    ))  # fmt: skip


def _write_number(random: Random) -> str:
    number = random.choice((
        _write_digits(random), f"{_write_digits(random)}{random.choice('.,')}{_write_digits(random)}",
        _write_groups(random), f"{random.choice('.,')}{_write_digits(random)}",
        f"{_write_digits(random)}{random.choice('.,')}", f"{random.randint(0, 30)}{random.choice('½⅓¼')}",
        f"{random.randint(0, 9)}{random.choice('/÷∕')}{random.randint(0, 9)}",
    ))  # fmt: skip
    power = random.choice(_POWERS)
    ending = random.choice((
        f"e{power}", f"×10^{power}", f"*10**{power}", f" x 10^({power})",
        f"·10{power.translate(_RAISED)}", f"×10^{power.replace('-', '−')}",
    ))  # fmt: skip
    return number + ending if random.random() < 0.2 else number


def _write_digits(random: Random, count: int = 0) -> str:
    return "".join(random.choices("0123456789", k=count or random.choice((1, 1, 2, 3, 3, 4, 6))))


def _write_groups(random: Random) -> str:
    """Thousands, and sometimes decimals."""
    groups = [str(random.randint(1, 999)), _write_digits(random, 3), _write_digits(random, 3)]
    grouped = random.choice(_GROUPS).join(groups[: random.choice((2, 3))])
    return grouped + random.choice(("", ".5", ",25"))


def _write_unit(random: Random) -> str:
    unit = _write_factor(random)
    for _ in range(random.choice((0, 0, 1, 1, 1, 2))):
        per = random.choice(_PER)
        unit += random.choice((*_LINKS, per, f" {per} ")) + _write_factor(random)
    if random.random() < 0.1:
        unit = random.choice(("1/", "/", "*", "1 / ")) + unit
    return random.choice(_BRACKETS) % unit if random.random() < 0.1 else unit


def _write_factor(random: Random) -> str:
    name, power = _change_case(random, _NAMES), random.choice(_POWERS)
    return random.choice((
        name, name, name, f"{name}^{power}", f"{name}**{power}", f"{name}^({power})",
        f"{name}^{{{power}}}", f"{name}{power}", f"{name}{power.translate(_RAISED)}",
        f"{name}{power.replace('-', '−')}", f"{name} {random.choice(_SQUARED)}",
        f"{random.choice(_SQUARE)}{name}",
    ))  # fmt: skip
