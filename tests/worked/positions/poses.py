"""Sentences and numbers of positions that are told."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kinegrade.language import ENGLISH
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.language.prose.typst import write_prose
from kinegrade.worked.document import Block, Prose
from tests.worked.telling import displayed as lines
from tests.worked.telling import tidy


def sentences(blocks: Iterable[Block]) -> list[str]:
    return [block.text for block in blocks if isinstance(block, Prose)]


def require_printable(blocks: Iterable[Block], where: str) -> None:
    for text in sentences(blocks):
        assert write_prose(text, where, ENGLISH)
    for line in lines(blocks):
        assert line.count("&") == 1
        assert "--" not in line
        assert write_typst_math(line.replace("&", " "), where)


def bare(latex: str) -> str:
    """A formula without brackets."""
    return re.sub(r"\\(?:left|right)|[()]| ", "", tidy(latex))


ROUNDED = re.compile(r"\d\.\d{4}|[1-9]\.\d{3}|\d\d\.\d\d")  # four digits, as all that is rounded
