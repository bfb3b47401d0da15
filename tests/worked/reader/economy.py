"""What a page finds and does not use, and what it says twice."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Display, Heading, Prose, TermTable
from tests.worked.reader.equations import Line, Said, read_page
from tests.worked.reader.formula_reader import find_symbols, name_symbol
from tests.worked.telling import boxed

_SENTENCE = re.compile(r"(?<=[.:])\s+|(?<=[。：])")
_NUMBER = re.compile(r"\d+(?:(?:[.,]|\{,\})\d+)?")
_COMPONENT = re.compile(r",[xy]\}")
_LONG = 30  # letters below which a sentence may well stand twice


def find_unused(blocks: Sequence[Block]) -> Iterator[str]:
    """The lines of displays whose result no later line, sentence, table or box takes up."""
    answers = {one for row in boxed(blocks) for one in _NUMBER.findall(row)}
    for place, block in enumerate(blocks):
        if not isinstance(block, Display):
            continue
        later = blocks[place + 1 :]
        after = {name for part in read_page(later) for name in _list_symbols(part)}
        said = {one for text in _list_texts(later) for one in _NUMBER.findall(text)}
        lines = [one for one in read_page((block,)) if isinstance(one, Line)]
        for number, line in enumerate(lines):
            below = {name for one in lines[number + 1 :] for name in _list_symbols(one)}
            end = {*_NUMBER.findall(write_row(line.sides[-1].row))} - {"0"} if line.sides else set()
            if _is_unused(line, after | below) and end and not end & (answers | said):
                yield line.text


def _is_unused(line: Line, used: set[str]) -> bool:
    """Whether a symbol is found, and neither it nor the vector of which it is a component used."""
    symbol = name_symbol(line.left)
    whole = _COMPONENT.sub("}", symbol)
    alone = [symbol] == list(find_symbols(line.left))
    return alone and not {symbol, whole, f"|{symbol}|"} & used


def _list_texts(blocks: Sequence[Block]) -> Iterator[str]:
    """The sentences, and the magnitudes in tables: what is found as v_B may stand there as v_a."""
    for block in blocks:
        if isinstance(block, Prose):
            yield block.text
        if isinstance(block, TermTable):
            yield from (term.magnitude for term in block.terms)


def _list_symbols(part: Line | Said) -> Iterator[str]:
    if isinstance(part, Said):
        yield from find_symbols(part.row)
        yield name_symbol(part.row)
        return
    for row in (part.left, *(side.row for side in part.sides)):
        yield from find_symbols(row)


def find_repeated(blocks: Sequence[Block]) -> Iterator[str]:
    """The long sentences that stand twice under a title."""
    said = set[str]()
    for block in blocks:
        if isinstance(block, Heading):
            said.clear()
        if isinstance(block, Prose):
            for sentence in _SENTENCE.split(block.text):
                if len(sentence) > _LONG and sentence in said:
                    yield sentence
                said.add(sentence)
