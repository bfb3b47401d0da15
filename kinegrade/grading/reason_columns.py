"""The last columns of marks.csv: reasons, mistakes and rules, most of them sentences filled in with
numbers.

Called by `answer_lines`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np

from kinegrade.files.csv_writing import encode, neutralise, write_csv_cell
from kinegrade.grading.fast.bounds import Places
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.line_columns import LineColumns, Texts
from kinegrade.grading.fast.number_texts import tabulate_numbers
from kinegrade.grading.fast.reasons import Form, read_cells
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Text
from kinegrade.marks_folder.layout import BY_POLICY, NAMES_BETWEEN


def add_reasons(lines: LineColumns, judged: JudgedBlock, words: Catalogue) -> None:
    """Adds the ends of lines: the texts of sentences, and between them their numbers."""
    ways = 2 * judged.said + judged.to_figures
    forms = _read_forms(judged, ways)
    begins, which = _list_begins(judged, forms, ways, words)
    lines.add(begins, which)
    for hole in range(max((len(form.order) for form in forms.values()), default=0)):
        lines.add_plain(_write_numbers(judged, forms, ways, hole))
        behind = [
            encode(forms[way].texts[hole + 1])
            if way in forms and hole < len(forms[way].order)
            else b""
            for way in range(2 * len(judged.sentences))
        ]
        lines.add(behind, ways)


def _read_forms(judged: JudgedBlock, ways: Places) -> Mapping[int, Form]:
    """The forms of the sentences that are said, with the end of the line behind each."""
    found: dict[int, Form] = {}
    for way in np.flatnonzero(np.bincount(ways)).tolist():
        said, to_figures = divmod(way, 2)
        if said:
            sentence = judged.sentences[said]
            forms = read_cells(judged.language, sentence)
            form = forms.choose(to_figures=bool(to_figures))
            end = _write_end(sentence.mistakes, by_policy=sentence.by_policy)
            found[way] = Form((*form.texts[:-1], form.texts[-1] + end), form.order)
    return found


def _list_begins(
    judged: JudgedBlock, forms: Mapping[int, Form], ways: Places, words: Catalogue
) -> tuple[list[bytes], Places]:
    """The beginnings of sentences, and all of what is no sentence: the distinct texts, and the
    number of that of each answer.
    """
    begins = {way: encode(form.texts[0]) for way, form in forms.items()}
    texts = [begins.get(way, b"") for way in range(2 * len(judged.sentences))]
    numbers: dict[bytes, int] = {}
    which = ways.copy()
    for place in np.flatnonzero(judged.said == 0).tolist():
        end = _write_end(judged.find_mistakes(place), by_policy=bool(judged.by_policy[place]))
        text = encode(_write_reason(judged.reason(place), words) + end)
        which[place] = len(texts) + numbers.setdefault(text, len(numbers))
    return [*texts, *numbers], which


def _write_numbers(
    judged: JudgedBlock, forms: Mapping[int, Form], ways: Places, hole: int
) -> Texts:
    """The numbers at one place of the sentences."""
    stated = np.full(2 * len(judged.sentences), -1, dtype=np.intp)
    for way, form in forms.items():
        if hole < len(form.order):
            stated[way] = form.order[hole]
    which = stated[ways]
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
