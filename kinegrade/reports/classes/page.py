"""The class report: one self-contained HTML page.

`class_report` is called by the command line. The page has no scripts and no links, and the layout
engine escapes every text in it. The same marks give the same bytes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.tables import Complaint
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Listing, Message, list_plainly, list_statements
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import COMPLAINTS
from kinegrade.press.html.filled_page import load_layout
from kinegrade.press.html.short_texts import write_symbol_html
from kinegrade.question_numbers import find_bank_number
from kinegrade.reports.classes.equal_hardness import ENOUGH
from kinegrade.reports.classes.figures import (
    write_decimal,
    write_deviation,
    write_percent,
    write_plain,
    write_share,
)
from kinegrade.reports.classes.hardness import make_hardness_part
from kinegrade.reports.classes.item_statistics import (
    Summary,
    find_discriminations,
    find_facilities,
    find_reliability,
    make_histogram,
    summarise,
)
from kinegrade.reports.classes.plots import write_bar, write_histogram_plot, write_stacked_bar
from kinegrade.reports.classes.tally import ClassTally, tally
from kinegrade.reports.classes.words import describe_reason, name_verdict

_Page = dict[str, Any]  # the values a layout reads
_HARD, _EASY, _FLAT = 0.3, 0.9, 0.1
_MOST_COMPLAINTS = 200
_VERDICTS = (
    "right",
    "accepted",
    "follow-through",
    "void",
    "mistake",
    "wrong",
    "wrong unit",
    "unreadable",
    "blank",
)  # in the order of the segments of a bar
_LAST = ("unexplained", "wrong unit", "unreadable", "blank")  # the least informative reasons
_SHADES = {verdict: f"shade{place}" for place, verdict in enumerate(_VERDICTS)}


def class_report(marks: MarksFolder, exam: ExamFolder, wording: Wording, language: Language) -> str:
    """The page for a marks folder, with the exam folder it was made from. Raises TableError,
    ExamError.
    """
    counts, catalogue = tally(marks, exam), open_catalogue(language)
    page: _Page = {
        "words": catalogue.raw("report", "page."),
        "tag": catalogue.text("language.tag"),
        "exam": exam.head,
        "heads": [_name_question(question, catalogue) for question in exam.questions],
        **_make_head(counts, catalogue),
        **_make_complaints_part(marks.complaints(), catalogue),
    }
    figures = summarise(counts.percents)
    if figures is not None:
        page |= {
            **_totals_part(counts, figures, catalogue),
            "asks": list(_ask_rows(counts, wording, catalogue)),
            "legend": _legend(counts, catalogue),
            "losses": list(_loss_rows(counts, wording, catalogue)),
            **make_hardness_part(counts, exam, wording, catalogue),
        }
    return load_layout("class_report.html").render(page)


def _name_question(question: str, catalogue: Catalogue) -> str:
    return catalogue.write(Message("report.numbered", number=find_bank_number(question)))


def _make_head(counts: ClassTally, catalogue: Catalogue) -> _Page:
    """How many answered."""
    answered, silent = len(counts.answered), len(counts.silent)
    counted = Message("report.counted", answered=answered, roster=answered + silent)
    return {
        "answered": answered,
        "few": 0 < answered < ENOUGH,
        "counted": catalogue.write(counted),
        "silent": catalogue.write(Message("report.silent", count=silent)) if silent else "",
    }


def _make_complaints_part(complaints: Sequence[Complaint], catalogue: Catalogue) -> _Page:
    """The first complaints of grade, and where the others are."""
    count = len(complaints)
    more = Message("report.more-complaints", most=_MOST_COMPLAINTS, all=count, file=COMPLAINTS.name)
    return {
        "complaints": complaints[:_MOST_COMPLAINTS],
        "number_of_complaints": count,
        "more_complaints": catalogue.write(more) if count > _MOST_COMPLAINTS else "",
    }


def _totals_part(counts: ClassTally, figures: Summary, catalogue: Catalogue) -> _Page:
    """The distribution of the totals: figures and a plot."""
    out_of = max(each.out_of for each in counts.answered)
    alpha = find_reliability(counts.points)
    spread = _write_span(figures.lower, figures.upper, catalogue)
    span = _write_span(figures.minimum, figures.maximum, catalogue)
    cards = [
        (write_percent(figures.mean, catalogue), catalogue.text("report.page.mean")),
        (write_percent(figures.median, catalogue), catalogue.text("report.median")),
        (write_deviation(figures.sd, catalogue), catalogue.text("report.page.sd")),
        (spread, catalogue.text("report.quartiles")),
        (span, catalogue.text("report.span")),
        (write_decimal(alpha, catalogue), catalogue.text("report.reliability")),
    ]
    plot = write_histogram_plot(
        make_histogram(counts.percents),
        figures,
        catalogue.text("report.percent-axis"),
        catalogue.text("report.page.students"),
        catalogue.text("report.marks-on-axis"),
    )
    points = write_plain(float(out_of), catalogue)
    return {
        "cards": cards,
        "distribution": plot,
        "out_of": catalogue.write(Message("report.of-points", points=points)),
    }


def _write_span(lowest: float, highest: float, catalogue: Catalogue) -> str:
    return f"{write_percent(lowest, catalogue)} – {write_percent(highest, catalogue)}"


def _ask_rows(counts: ClassTally, wording: Wording, catalogue: Catalogue) -> Iterator[_Page]:
    """One table line for each ask."""
    shares, correlations = (
        find_facilities(counts.points, counts.out_of),
        find_discriminations(counts.points),
    )
    for place, column in enumerate(counts.columns):
        facility, discrimination, verdicts = (
            shares[place],
            correlations[place],
            counts.verdicts[column],
        )
        question, share = column.split(".")[0], write_share(facility, catalogue)
        yield {
            "question": _name_question(question, catalogue),
            "title": wording.titles.get(question, ""),
            "first": place == 0 or counts.columns[place - 1].split(".")[0] != question,
            "symbol": _symbol_of(column, wording),
            "meaning": wording.meanings.get(column, ""),
            "points": write_plain(float(counts.out_of[place]), catalogue),
            "facility": share,
            "bar": write_bar(facility or 0.0, "column", share, 70.0, track=True),
            "discrimination": write_decimal(discrimination, catalogue),
            "answers": _verdict_bar(verdicts, catalogue),
            "verdicts": _verdict_text(verdicts, catalogue),
            "note": catalogue.write(_note(facility, discrimination, len(counts.answered))),
        }


def _symbol_of(column: str, wording: Wording) -> Markup:
    """The symbol of an ask, or its name where no symbol is known."""
    known = wording.symbols.get(column)
    return Markup.escape(column.split(".", 1)[1]) if known is None else write_symbol_html(known)


def _verdict_bar(verdicts: Counter[str], catalogue: Catalogue) -> Markup:
    """All answers to an ask as a single bar."""
    whole = verdicts.total()
    parts = [
        (_SHADES.get(verdict, "shade5"), count / whole) for verdict, count in _in_order(verdicts)
    ]
    return write_stacked_bar(parts, _verdict_text(verdicts, catalogue))


def _verdict_text(verdicts: Counter[str], catalogue: Catalogue) -> str:
    """How often each verdict was given."""
    return catalogue.write(
        list_plainly(
            Message("report.verdict-count", verdict=name_verdict(verdict), number=count)
            for verdict, count in _in_order(verdicts)
        )
    )


def _in_order(verdicts: Counter[str]) -> list[tuple[str, int]]:
    """Verdicts with their counts, right answers first, unknown verdicts last."""
    known = [verdict for verdict in _VERDICTS if verdicts[verdict]]
    return [
        (verdict, verdicts[verdict])
        for verdict in (*known, *sorted(set(verdicts) - set(_VERDICTS)))
    ]


def _legend(counts: ClassTally, catalogue: Catalogue) -> list[tuple[str, str]]:
    """The shades of the verdicts that occur."""
    occurring = sum(counts.verdicts.values(), Counter[str]())
    return [
        (_SHADES.get(verdict, "shade5"), catalogue.write(name_verdict(verdict)))
        for verdict, _ in _in_order(occurring)
    ]


def _note(facility: float | None, discrimination: float | None, students: int) -> Listing:
    """What is worth a look; a correlation within two standard errors of zero counts as none."""
    notes: list[Message] = []
    if facility is not None and facility < _HARD:
        notes.append(Message("report.hard"))
    if facility is not None and facility > _EASY:
        notes.append(Message("report.easy"))
    if discrimination is not None and discrimination < _FLAT:
        negative = discrimination < -2 / students**0.5
        notes.append(Message("report.negative" if negative else "report.flat"))
    return list_statements(notes)


def _loss_rows(counts: ClassTally, wording: Wording, catalogue: Catalogue) -> Iterator[_Page]:
    """For each question the reasons why points were lost, the most frequent first."""
    most = max(
        (reasons.most_common(1)[0][1] for reasons in _by_question(counts).values() if reasons),
        default=1,
    )
    for question, reasons in _by_question(counts).items():
        ordered = sorted(
            reasons.items(), key=lambda reason: (reason[0] in _LAST, -reason[1], reason[0])
        )
        rows = [
            {
                "reason": catalogue.write(describe_reason(reason, wording)),
                "count": count,
                "bar": write_bar(
                    count / most, "faint" if reason in _LAST else "column", str(count)
                ),
                "asks": [
                    (_symbol_of(column, wording), counts.losses[column][reason])
                    for column in counts.columns
                    if column.startswith(f"{question}.") and counts.losses[column][reason]
                ],
            }
            for reason, count in ordered
        ]
        if rows:
            yield {
                "question": _name_question(question, catalogue),
                "title": wording.titles.get(question, ""),
                "rows": rows,
            }


def _by_question(counts: ClassTally) -> Mapping[str, Counter[str]]:
    """The reasons of all asks of a question together."""
    found: dict[str, Counter[str]] = {}
    for column in counts.columns:
        found.setdefault(column.split(".")[0], Counter()).update(counts.losses[column])
    return found
