"""Which columns of a gradebook belong to one item, and what each of them holds, whatever the
language of the headers.

Moodle writes "title (word)" above the columns of an item, side by side: points, per cent, a letter,
and last the feedback. The words are in the language of the person who downloaded the file, so they
are not relied on: a word means the same in the whole file, and all the cells below it show what
that is. Known words settle what the cells leave open. `item_groups` is called by `item_columns`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, assert_never

from kinegrade.files.cell_text import trim
from kinegrade.lms.grades.cells import CellTable
from kinegrade.lms.grades.dialect import ItemKind, ItemWords

Content = Literal["numbers", "shares", "texts", "dashes", "nothing"]
_HEADER = re.compile(r"(?P<title>.*\S)\s*[(（\[【](?P<word>[^()（）\[\]【】]+)[)）\]】]", re.DOTALL)
_NUMBER = re.compile(r"-?[0-9\s]*[0-9](?:[.,][0-9]+)?")
_SHARE = re.compile(r"-?[0-9\s]*[0-9](?:[.,][0-9]+)?\s*[%％]")
_PARTICIPANT = re.compile(r"(\D+?)\s*[0-9]+")
_DIGIT = re.compile(r"[0-9]")
_DASH = "-"  # stands for a missing grade; the cell of missing feedback is empty
_LONGEST_LETTER = 3


@dataclass(frozen=True, slots=True)
class GroupColumn:
    """A column of an item: its place, the word in brackets in its header, and what it holds.

    "text" is a letter or a word of a scale; "open" is a grade whose kind no cell shows.
    """

    place: int
    word: str
    kind: ItemKind


@dataclass(frozen=True, slots=True)
class ItemGroup:
    """Neighbouring columns with the same title; no word occurs twice."""

    title: str
    columns: tuple[GroupColumn, ...]

    def of_kind(self, kind: ItemKind) -> tuple[GroupColumn, ...]:
        """The columns that hold this kind."""
        return tuple(column for column in self.columns if column.kind == kind)


def is_item_header(header: str) -> bool:
    """Whether a header has the shape of an item's.

    >>> is_item_header("Test : Cinématique (Brut)"), is_item_header("Numéro d’identification")
    (True, False)
    """
    return _HEADER.fullmatch(header) is not None


def content_below(table: CellTable, place: int) -> Content:
    """What the cells of a column show: grades may be written only where they are grades or still
    empty.
    """
    return _content(_cells(table, place))


def item_groups(table: CellTable, keys: Collection[int], known: ItemWords) -> tuple[ItemGroup, ...]:
    """The items of a gradebook; `keys` are the places of the columns that identify the student."""
    headers = [
        (place, found["title"], trim(found["word"]))
        for place, header in enumerate(table.titles)
        if place not in keys and (found := _HEADER.fullmatch(header))
    ]
    groups = list(_neighbours(headers))
    kinds = _kinds(table, groups, known)
    return tuple(
        ItemGroup(title, tuple(GroupColumn(place, word, kinds[word]) for place, word in columns))
        for title, columns in groups
    )


_Group = tuple[str, list[tuple[int, str]]]


def _neighbours(headers: Sequence[tuple[int, str, str]]) -> Iterator[_Group]:
    """Title, places and words of neighbouring columns that share the title and no word."""
    current: _Group | None = None
    last = -1
    for place, title, word in headers:
        words = {other for _, other in current[1]} if current else set()
        if current and title == current[0] and place == last + 1 and word not in words:
            current[1].append((place, word))
        else:
            if current:
                yield current
            current = title, [(place, word)]
        last = place
    if current:
        yield current


def _kinds(table: CellTable, groups: Sequence[_Group], known: ItemWords) -> Mapping[str, ItemKind]:
    """What each word means in this file."""
    order = _in_order(groups)
    kinds: dict[str, ItemKind] = {}
    for word in order:
        cells = [cell for place in _places(groups, word) for cell in _cells(table, place)]
        kinds[word] = _kind(cells, _known_kind(word, known), is_last=_is_last(groups, word))
    if "points" not in kinds.values() and not _is_worksheet(table):
        # Moodle writes points before per cent and letters.
        first = next((word for word in order if kinds[word] == "open"), None)
        if first is not None:
            kinds[first] = "points"
    return kinds


def _is_worksheet(table: CellTable) -> bool:
    """Whether the first column reads "Participant 12": an assignment's worksheet, which has dates
    below headers with brackets.
    """
    found = [_PARTICIPANT.fullmatch(cell) for cell in _cells(table, 0)]
    words = {match[1] for match in found if match}
    return len(words) == 1 and all(found)


def _in_order(groups: Sequence[_Group]) -> list[str]:
    """All words, in order."""
    words: list[str] = []
    for _, columns in groups:
        words += [word for _, word in columns if word not in words]
    return words


def _places(groups: Sequence[_Group], wanted: str) -> list[int]:
    return [place for _, columns in groups for place, word in columns if word == wanted]


def _cells(table: CellTable, place: int) -> list[str]:
    return [trim(row.cells[place].text) for row in table.rows]


def _is_last(groups: Sequence[_Group], word: str) -> bool:
    """Whether a word is the last of several in every group that has it."""
    having = [columns for _, columns in groups if any(word == other for _, other in columns)]
    return all(len(columns) > 1 and columns[-1][1] == word for columns in having)


def _known_kind(word: str, known: ItemWords) -> ItemKind | None:
    return next((kind for kind, words in known.items() if word in words), None)


def _kind(cells: Sequence[str], known: ItemKind | None, *, is_last: bool) -> ItemKind:
    """What a word means by the cells below it; a known word settles what they leave open."""
    content = _content(cells)
    match content:
        case "shares":
            return "feedback" if known == "feedback" else "percentage"
        case "numbers":
            without_dashes = "" in cells and _DASH not in cells
            return known or ("feedback" if is_last and without_dashes else "points")
        case "texts":
            is_comment = known is None and is_last and _are_comments(cells)
            return "feedback" if known == "feedback" or is_comment else "text"
        case "dashes":
            return known or "open"
        case "nothing":
            return known or ("feedback" if is_last else "open")
        case _:
            assert_never(content)


def _are_comments(cells: Sequence[str]) -> bool:
    """Whether texts are comments and not letters or words of a scale: these repeat, and have a dash
    where one is missing.
    """
    if "" in cells or _DASH in cells:
        return "" in cells
    long = [cell for cell in cells if len(cell) > _LONGEST_LETTER]
    return 2 * len(set(long)) > len(cells) or any(_DIGIT.search(cell) for cell in long)


def _content(cells: Sequence[str]) -> Content:
    filled = [cell for cell in cells if cell not in ("", _DASH)]
    if not filled:
        return "dashes" if _DASH in cells else "nothing"
    if all(_SHARE.fullmatch(cell) for cell in filled):
        return "shares"
    return "numbers" if all(_NUMBER.fullmatch(cell) for cell in filled) else "texts"
