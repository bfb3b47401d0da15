"""The last columns of marks.csv: reasons, mistakes and rules, most of them sentences filled in with
numbers.

Called by `answer_lines`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from kinegrade.files.csv_writing import encode, neutralise, write_csv_cell
from kinegrade.grading.fast.bounds import Places
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.line_columns import LineColumns, Texts
from kinegrade.grading.fast.number_texts import tabulate_numbers
from kinegrade.grading.fast.reasons import Sentence, read_cells
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Text
from kinegrade.marks_folder.layout import BY_POLICY, NAMES_BETWEEN


def add_reasons(lines: LineColumns, judged: JudgedBlock, words: Catalogue) -> None:
    """Adds the ends of lines: the texts of sentences, and between them their numbers."""
    every_way = 2 * judged.said + judged.to_figures
    counts = np.bincount(every_way)
    said = np.flatnonzero(counts)
    ways = (np.cumsum(counts > 0) - 1)[every_way]  # counted among those that there are
    ends = [_read_end(judged, way) for way in said.tolist()]
    begins, which = _list_begins(judged, ends, ways, words)
    lines.add(begins, which)
    for hole in range(max((len(end.order) for end in ends), default=0)):
        lines.add_plain(_write_numbers(judged, ends, ways, hole))
        lines.add([end.behind(hole) for end in ends], ways)


class _End(NamedTuple):
    """The end of a line: the texts between which numbers stand, and which numbers these are; none
    where no sentence is said.
    """

    texts: tuple[bytes, ...] = (b"",)
    order: tuple[int, ...] = ()

    def behind(self, hole: int) -> bytes:
        """The text behind a number, nothing where there is no such number."""
        return self.texts[hole + 1] if hole < len(self.order) else b""


def _read_end(judged: JudgedBlock, way: int) -> _End:
    """The end of the lines in which a sentence is said in one of its two ways."""
    said, to_figures = divmod(way, 2)
    if not said:
        return _End()
    return _make_end(judged.language, judged.sentences[said], bool(to_figures))


@lru_cache(maxsize=4096)
def _make_end(language: Language, sentence: Sentence, to_figures: bool) -> _End:
    form = read_cells(language, sentence).choose(to_figures=to_figures)
    end = _write_end(sentence.mistakes, by_policy=sentence.by_policy)
    *texts, last = form.texts
    return _End((*map(encode, texts), encode(last + end)), form.order)


def _list_begins(
    judged: JudgedBlock, ends: Sequence[_End], ways: Places, words: Catalogue
) -> tuple[list[bytes], Places]:
    """The beginnings of sentences, and all of what is no sentence: the distinct texts, and the
    number of that of each answer.
    """
    texts = [end.texts[0] for end in ends]
    numbers: dict[bytes, int] = {}
    known: dict[tuple[int, tuple[str, ...], bool], int] = {}
    which = ways.copy()
    for place in np.flatnonzero(judged.said == 0).tolist():
        reason, mistakes = judged.reason(place), judged.find_mistakes(place)
        by_policy = bool(judged.by_policy[place])
        alike = id(reason), mistakes, by_policy  # as of all answers that say the same wrong
        if alike not in known:
            end = _write_end(mistakes, by_policy=by_policy)
            text = encode(_write_reason(reason, words) + end)
            known[alike] = len(texts) + numbers.setdefault(text, len(numbers))
        which[place] = known[alike]
    return [*texts, *numbers], which


def _write_numbers(judged: JudgedBlock, ends: Sequence[_End], ways: Places, hole: int) -> Texts:
    """The numbers at one place of the sentences."""
    stated = [end.order[hole] if hole < len(end.order) else -1 for end in ends]
    which = np.array(stated, dtype=np.intp)[ways]
    chosen = np.flatnonzero(which >= 0)
    written = tabulate_numbers(judged.stated[which[chosen], chosen])
    if len(chosen) == len(ways):
        return written
    texts = np.zeros(len(ways), dtype=written.dtype)
    texts[chosen] = written
    return texts


def _write_reason(reason: Text, words: Catalogue) -> str:
    """Most are sentences of letters with a comma: they need quotation marks, and nothing else."""
    if isinstance(reason, str) and reason[:1].isalpha() and "," in reason and '"' not in reason:
        return f'"{reason}"'
    return write_csv_cell(neutralise(words.write(reason)))


def _write_end(mistakes: Sequence[str], *, by_policy: bool) -> str:
    """Mistakes and rule, and the end of the line."""
    rule = BY_POLICY if by_policy else ""
    return f",{_write_names(tuple(mistakes))},{rule}\n"


@lru_cache(maxsize=1024)
def _write_names(mistakes: tuple[str, ...]) -> str:
    return write_csv_cell(neutralise(NAMES_BETWEEN.join(mistakes)))
