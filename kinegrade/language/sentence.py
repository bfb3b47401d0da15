"""A message as a sentence among formulas."""

from __future__ import annotations

import re

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message

# Texts, as few languages need them, and a range of thousands takes long to compile
_CHINESE_START = r"^([\u4e00-\u9fff])"
_LATIN_CHINESE = r"(?<=[0-9A-Za-z])(?=[\u4e00-\u9fff])|(?<=[\u4e00-\u9fff])(?=[0-9A-Za-z])"
_CHINESE_END = r"([\u4e00-\u9fff])$"


def write_sentence(message: Message, language: Language) -> str:
    """What a message says, with spaces between Chinese words and formulas."""
    text = open_catalogue(language).write(message)
    return text if text.isascii() else _space_formulas(text)


def _space_formulas(text: str) -> str:
    """A space wherever a Chinese character stands next to a formula, a Latin letter or a digit.

    >>> _space_formulas("投影到$x$轴（$y$ 轴除外），齿轮 II在第2步")
    '投影到 $x$ 轴（$y$ 轴除外），齿轮 II 在第 2 步'
    """
    words = text.split("$")[::2]
    formulas = text.split("$")[1::2]
    spaced = [re.sub(_CHINESE_END, r"\1 ", one) for one in words[:-1]] + words[-1:]
    spaced[1:] = [re.sub(_CHINESE_START, r" \1", one) for one in spaced[1:]]
    spaced = [re.sub(_LATIN_CHINESE, " ", one) for one in spaced]
    joined = (f"{before}${formula}$" for before, formula in zip(spaced, formulas, strict=False))
    return "".join(joined) + spaced[-1]
