"""The class report: how the class did, and what it says about the asks, as the press prints it.

The same marks give the same bytes.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Message
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import COMPLAINTS
from kinegrade.press.class_charts import HistogramPlot, Summary
from kinegrade.press.class_sheet import ClassFigures, ClassSheet
from kinegrade.press.html.class_report import write_class_report
from kinegrade.reports.classes.asks import list_asks, list_legend
from kinegrade.reports.classes.by_hand import list_hand_lines
from kinegrade.reports.classes.equal_hardness import ENOUGH
from kinegrade.reports.classes.figures import (
    write_decimal,
    write_deviation,
    write_percent,
    write_plain,
)
from kinegrade.reports.classes.grades import count_grades, rank_students
from kinegrade.reports.classes.hardness import judge_hardness
from kinegrade.reports.classes.item_statistics import find_reliability, make_histogram, summarise
from kinegrade.reports.classes.losses import list_losses
from kinegrade.reports.classes.parts import list_parts
from kinegrade.reports.classes.tally import ClassTally, tally
from kinegrade.reports.classes.words import name_question

_MOST_COMPLAINTS = 200


def class_report(
    marks: MarksFolder,
    exam: ExamFolder,
    wording: Wording,
    language: Language,
    *,
    ranks: bool = False,
) -> str:
    """The page for a marks folder, with the exam folder it was made from, and with the `ranks` of
    the students if they are wanted. Raises TableError, ExamError.
    """
    sheet, catalogue = make_class_sheet(marks, exam, wording, language), open_catalogue(language)
    if marks.subtracted:
        less = Message("report.subtracted", count=len(marks.subtracted))
        sheet = replace(sheet, counted=f"{sheet.counted} {catalogue.write(less)}")
    if sheet.figures is not None:
        totals, scale = marks.totals, marks.scale
        passed, grades = ("", ()) if scale is None else count_grades(totals, scale, catalogue)
        listed = rank_students(totals, catalogue) if ranks else ()
        figures = replace(sheet.figures, passed=passed, grades=grades, ranks=listed)
        sheet = replace(sheet, figures=figures)
    return write_class_report(sheet)


def make_class_sheet(
    marks: MarksFolder, exam: ExamFolder, wording: Wording, language: Language
) -> ClassSheet:
    """What stands on the page. Raises TableError, ExamError."""
    counts, catalogue, head = tally(marks, exam), open_catalogue(language), exam.head
    answered, silent = len(counts.answered), len(counts.silent)
    counted = Message("report.counted", answered=answered, roster=answered + silent)
    complaints = marks.complaints()
    count = len(complaints)
    more = Message("report.more-complaints", most=_MOST_COMPLAINTS, all=count, file=COMPLAINTS.name)
    figures = summarise(counts.percents)
    return ClassSheet(
        language,
        head.course,
        head.title,
        head.date,
        catalogue.write(counted),
        catalogue.write(Message("report.silent", count=silent)) if silent else "",
        0 < answered < ENOUGH,
        tuple(name_question(question, catalogue) for question in exam.questions),
        None
        if figures is None
        else _make_figures(
            counts, figures, exam, marks=marks, wording=wording, catalogue=catalogue
        ),
        complaints[:_MOST_COMPLAINTS],
        count,
        catalogue.write(more) if count > _MOST_COMPLAINTS else "",
    )


def _make_figures(
    counts: ClassTally,
    figures: Summary,
    exam: ExamFolder,
    *,
    marks: MarksFolder,
    wording: Wording,
    catalogue: Catalogue,
) -> ClassFigures:
    maxima = {float(each.out_of) for each in counts.answered}
    bounds = dict.fromkeys(write_plain(each, catalogue) for each in (min(maxima), max(maxima)))
    out_of = " … ".join(bounds)
    return ClassFigures(
        _write_maximum(out_of, exam, marks, catalogue),
        _list_cards(counts, figures, exam, catalogue),
        HistogramPlot(
            make_histogram(counts.percents),
            figures,
            catalogue.text("report.percent-axis"),
            catalogue.text("report.page.students"),
            catalogue.text("report.marks-on-axis"),
        ),
        tuple(list_asks(counts, exam.head.bonus, wording, catalogue)),
        tuple(list_legend(counts, catalogue)),
        tuple(list_losses(counts, wording, catalogue)),
        judge_hardness(counts, exam, wording, catalogue),
        list_parts(counts, counts.groups, exam, catalogue) if len(set(counts.groups)) > 1 else (),
        by_hand=tuple(list_hand_lines(marks, wording, catalogue)),
    )


def _write_maximum(points: str, exam: ExamFolder, marks: MarksFolder, catalogue: Catalogue) -> str:
    """How many points there are; of those marked so far, where others are still to be marked by
    hand; and how many come on top of them.
    """
    head, still_open = exam.head, {each.question for each in marks.open}
    by_hand = sum(
        (each.points for each in head.by_hand if each.question in still_open and not each.bonus),
        Fraction(0),
    )
    said = Message("report.of-points", points=points)
    if by_hand:
        others = write_plain(float(by_hand), catalogue)
        said = Message("report.of-marked-points", points=points, others=others)
    if head.bonus_points:
        more = write_plain(float(head.bonus_points), catalogue)
        said = Message("report.and-bonus", points=said, bonus=more)
    return catalogue.write(said)


def _list_cards(
    counts: ClassTally, figures: Summary, exam: ExamFolder, catalogue: Catalogue
) -> tuple[tuple[str, str], ...]:
    """The distribution of the totals in figures."""
    spread = _write_span(figures.lower, figures.upper, catalogue)
    span = _write_span(figures.minimum, figures.maximum, catalogue)
    alike = len({each.out_of for each in counts.answered}) == 1  # else papers differ in weight
    alpha = find_reliability(counts.merge_alternatives(exam.head.choices)) if alike else None
    return (
        (write_percent(figures.mean, catalogue), catalogue.text("report.page.mean")),
        (write_percent(figures.median, catalogue), catalogue.text("report.median")),
        (write_deviation(figures.sd, catalogue), catalogue.text("report.page.sd")),
        (spread, catalogue.text("report.quartiles")),
        (span, catalogue.text("report.span")),
        (write_decimal(alpha, catalogue), catalogue.text("report.reliability")),
    )


def _write_span(lowest: float, highest: float, catalogue: Catalogue) -> str:
    return f"{write_percent(lowest, catalogue)} – {write_percent(highest, catalogue)}"
