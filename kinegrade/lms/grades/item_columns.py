"""Which columns of a downloaded file hold the grades: found where only one is possible, otherwise
named by the instructor.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.errors import Problem, TableError, suggest
from kinegrade.files.cell_text import trim
from kinegrade.language.message import Fault, Message, Part, Quoted, list_plainly
from kinegrade.lms.grades.cells import CellTable
from kinegrade.lms.grades.dialect import Dialect, Download, ExportOptions
from kinegrade.lms.grades.grades import TOTAL, ClassGrades
from kinegrade.lms.grades.item_candidates import ItemColumn, list_candidates, select_points
from kinegrade.lms.grades.item_groups import ItemGroup, content_below, item_groups

_KIND = re.compile(r"^[^:\uff1a]*[:\uff1a]")


@dataclass(frozen=True, slots=True)
class ItemColumns:
    """The column of each item, and the columns of the feedback on the total.

    `feedback` maps each place to whether the column holds the format; it is None where there is no
    feedback column, or several.
    """

    columns: Mapping[str, ItemColumn]
    feedback: Mapping[int, bool] | None


def items_of(grades: ClassGrades, options: ExportOptions) -> tuple[str, ...]:
    """What is exported: the total, or every question."""
    return grades.questions if options.per_question else (TOTAL,)


def item_title(title: str, item: str) -> str:
    """The title of an item: the exam's, with the question behind it.

    >>> item_title("Midterm", ""), item_title("Midterm", "q1")
    ('Midterm', 'Midterm q1')
    """
    return f"{title} {item}" if item else title


def item_columns(
    table: CellTable,
    dialect: Dialect,
    download: Download,
    *,
    grades: ClassGrades,
    keys: Collection[int],
    options: ExportOptions,
) -> ItemColumns:
    """The columns of each item; `keys` are those that identify the student.

    Raises TableError where no column or several columns are possible.
    """
    words = download.item_words
    groups = () if words is None else item_groups(table, keys, words)
    candidates = list_candidates(table, download) if words is None else select_points(table, groups)
    chooser = _Chooser(table, dialect, download, candidates, groups, keys)
    chosen: dict[str, ItemColumn] = {}
    faults: list[Problem] = []
    for item in items_of(grades, options):
        try:
            chosen[item] = chooser.chosen(item, options)
        except TableError as fault:
            faults += fault.faults
    headers = [column.header for column in chosen.values()]
    faults += [
        Fault(table.file, Message("grades.shared-column", header=Quoted(header)))
        for header in sorted(set(headers))
        if headers.count(header) > 1
    ]
    if faults:
        raise TableError(*faults)
    return ItemColumns(chosen, _find_feedback_places(table, download, groups, chosen))


def _find_feedback_places(
    table: CellTable,
    download: Download,
    groups: Sequence[ItemGroup],
    columns: Mapping[str, ItemColumn],
) -> Mapping[int, bool] | None:
    channel = download.channel
    if channel is None or TOTAL not in columns:
        return None
    if download.item_words is not None:
        places = [
            column.place
            for group in groups
            if any(columns[TOTAL].place == column.place for column in group.columns)
            for column in group.of_kind("feedback")
        ]
    else:
        wanted = {shape.format(title=columns[TOTAL].title) for shape in channel.headers}
        places = [place for place, title in enumerate(table.titles) if title in wanted]
    if len(places) != 1:
        return None
    formats = [
        place for place, title in enumerate(table.titles) if title == channel.format_header != ""
    ]
    return {places[0]: False, **dict.fromkeys(formats, True)}


def _drop_kind(title: str) -> str:
    """A title without the activity before it, in any language.

    >>> _drop_kind("Test : Cinématique"), _drop_kind("测验：Quiz 1")
    ('Cinématique', 'Quiz 1')
    """
    return trim(_KIND.sub("", title))


@dataclass(frozen=True, slots=True)
class _Chooser:
    table: CellTable
    dialect: Dialect
    download: Download
    candidates: Sequence[ItemColumn]
    groups: Sequence[ItemGroup]
    keys: Collection[int]

    def chosen(self, item: str, options: ExportOptions) -> ItemColumn:
        """The column of an item: the one named, the one with that title, or, for the total, the
        only one.
        """
        if item in options.columns:
            return self.named(trim(options.columns[item]))
        if not options.title:
            fits = [] if item else self.candidates
            what = (
                Message("grades.for-question", question=item)
                if item
                else Message("grades.to-fill-in")
            )
        else:
            title = item_title(options.title, item)
            fits = [each for each in self.candidates if title in (each.title, each.header)]
            # "Quiz: Midterm (Real)": the kind of activity comes before the title
            if not fits:
                fits = [each for each in self.candidates if _drop_kind(each.title) == title]
            what = Message("grades.called", title=Quoted(title))
        if len(fits) == 1:
            return fits[0]
        way = f"--column {item}=HEADER" if item else "--column HEADER"
        number = Message("grades.number-of-columns", number=len(fits))
        choice = Message(
            "grades.which-column",
            number=number if fits else Message("grades.no-columns"),
            what=what,
            way=way,
            columns=self.listing(),
        )
        raise TableError(Fault(self.table.file, choice))

    def named(self, header: str) -> ItemColumn:
        """The column with that header or title."""
        fits = [each for each in self.candidates if each.header == header] or [
            each for each in self.candidates if each.title == header
        ]
        places = [place for place, title in enumerate(self.table.titles) if title == header]
        if not fits and self.download.any_item:
            fits = [
                ItemColumn(place, header, header, None)
                for place in places
                if self._may_be_named(place)
            ]
        if len(fits) == 1:
            return fits[0]
        raise TableError(Fault(self.table.file, self._explain_none(header, len(fits), places)))

    def _explain_none(self, header: str, count: int, places: Sequence[int]) -> Message:
        """Why no column, or none of several, is the one that was named."""
        shown = Quoted(header)
        if count:
            return Message("grades.columns-alike", number=count, header=shown)
        if places:
            return Message(
                "grades.no-grade-column",
                header=shown,
                system=self.dialect.name,
                columns=self.listing(),
            )
        names = [each.header for each in self.candidates] or self.table.titles
        return Message("grades.no-column", header=shown, hint=suggest(header, names))

    def _may_be_named(self, place: int) -> bool:
        """Whether a column may hold grades in points, judged by its cells and its header."""
        known = {title for key in self.download.keys for title in key.headers}
        others = [
            column.place
            for group in self.groups
            for column in group.columns
            if column.kind not in ("points", "open")
        ]
        return (
            place not in self.keys
            and place not in others
            and self.table.titles[place] not in known
            and content_below(self.table, place) in ("numbers", "dashes", "nothing")
        )

    def listing(self) -> Part:
        """The columns that are possible."""
        if not self.candidates:
            return Message("grammar.no-names")
        return list_plainly(Quoted(each.header) for each in self.candidates)
