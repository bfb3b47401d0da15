"""The class report: one self-contained HTML page, in English or Chinese.

`class_report` is called by the command line. The page has no scripts and no links, and the layout
engine escapes every text in it. The same marks give the same bytes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from math import isnan
from typing import Any

from markupsafe import Markup

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.class_tally import ClassTally, tally
from kinegrade.grading.equal_hardness import (
    ENOUGH,
    ParameterTrend,
    Third,
    compare_groups,
    find_parameter_trends,
)
from kinegrade.grading.html_layout import load_layout
from kinegrade.grading.item_statistics import (
    Summary,
    find_discriminations,
    find_facilities,
    find_reliability,
    make_histogram,
    summarise,
)
from kinegrade.grading.math_html import write_symbol_html
from kinegrade.grading.plots import (
    write_bar,
    write_box_plot,
    write_histogram_plot,
    write_stacked_bar,
)
from kinegrade.grading.report_words import ReportWords, choose_report_words
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import COMPLAINTS
from kinegrade.question_numbers import find_bank_number

_Page = dict[str, Any]  # the values a layout reads
_HARD, _EASY, _FLAT = 0.3, 0.9, 0.1
_SIGNIFICANT = 0.05
_MOST_COMPLAINTS, _MOST_TRENDS = 200, 8
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
    counts, words = tally(marks, exam), choose_report_words(language)
    page: _Page = {
        "words": words,
        "exam": exam.head,
        "heads": [words.numbered.format(find_bank_number(name)) for name in exam.questions],
        "answered": len(counts.answered),
        "silent": [f"{each.name} ({each.student})" for each in counts.silent],
        "roster": len(counts.answered) + len(counts.silent),
        "enough": ENOUGH,
        "complaints": marks.complaints(),
        "complaints_file": COMPLAINTS.name,
        "most_complaints": _MOST_COMPLAINTS,
    }
    figures = summarise(counts.percents)
    if figures is not None:
        page |= {
            **_totals_part(counts, figures, words),
            "asks": list(_ask_rows(counts, wording, words)),
            "legend": _legend(counts, words),
            "losses": list(_loss_rows(counts, wording, words)),
            **_hardness_part(counts, exam, wording, words),
        }
    return load_layout("class_report.html").render(page)


def _totals_part(counts: ClassTally, figures: Summary, words: ReportWords) -> _Page:
    """The distribution of the totals: figures and a plot."""
    out_of = max(each.out_of for each in counts.answered)
    alpha = find_reliability(counts.points)
    cards = [
        (_percent(figures.mean), words.mean),
        (_percent(figures.median), words.median),
        ("–" if figures.sd is None else _percent(figures.sd), words.sd),
        (f"{_percent(figures.lower)} – {_percent(figures.upper)}", words.quartiles),
        (f"{_percent(figures.minimum)} – {_percent(figures.maximum)}", words.span),
        (_decimal(alpha), words.reliability),
    ]
    plot = write_histogram_plot(
        make_histogram(counts.percents),
        figures,
        words.percent_axis,
        words.students,
        words.marks_on_axis,
    )
    return {
        "cards": cards,
        "distribution": plot,
        "out_of": words.of_points.format(f"{float(out_of):g}"),
    }


def _ask_rows(counts: ClassTally, wording: Wording, words: ReportWords) -> Iterator[_Page]:
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
        question = column.split(".")[0]
        yield {
            "question": words.numbered.format(find_bank_number(question)),
            "title": wording.titles.get(question, ""),
            "first": place == 0 or counts.columns[place - 1].split(".")[0] != question,
            "symbol": _symbol_of(column, wording),
            "meaning": wording.meanings.get(column, ""),
            "points": f"{counts.out_of[place]:g}",
            "facility": _share_text(facility),
            "bar": write_bar(facility or 0.0, "column", _share_text(facility), 70.0, track=True),
            "discrimination": _decimal(discrimination),
            "answers": _verdict_bar(verdicts, words),
            "verdicts": _verdict_text(verdicts, words),
            "note": _note(facility, discrimination, len(counts.answered), words),
        }


def _symbol_of(column: str, wording: Wording) -> Markup:
    """The symbol of an ask, or its name where no symbol is known."""
    known = wording.symbols.get(column)
    return Markup.escape(column.split(".", 1)[1]) if known is None else write_symbol_html(known)


def _verdict_bar(verdicts: Counter[str], words: ReportWords) -> Markup:
    """All answers to an ask as a single bar."""
    whole = verdicts.total()
    parts = [
        (_SHADES.get(verdict, "shade5"), count / whole) for verdict, count in _in_order(verdicts)
    ]
    return write_stacked_bar(parts, _verdict_text(verdicts, words))


def _verdict_text(verdicts: Counter[str], words: ReportWords) -> str:
    """How often each verdict was given."""
    return ", ".join(
        f"{words.verdicts.get(verdict, verdict)}\u00a0{count}"
        for verdict, count in _in_order(verdicts)
    )


def _in_order(verdicts: Counter[str]) -> list[tuple[str, int]]:
    """Verdicts with their counts, right answers first, unknown verdicts last."""
    known = [verdict for verdict in _VERDICTS if verdicts[verdict]]
    return [
        (verdict, verdicts[verdict])
        for verdict in (*known, *sorted(set(verdicts) - set(_VERDICTS)))
    ]


def _legend(counts: ClassTally, words: ReportWords) -> list[tuple[str, str]]:
    """The shades of the verdicts that occur."""
    occurring = sum(counts.verdicts.values(), Counter[str]())
    return [
        (_SHADES.get(verdict, "shade5"), words.verdicts.get(verdict, verdict))
        for verdict, _ in _in_order(occurring)
    ]


def _note(
    facility: float | None, discrimination: float | None, students: int, words: ReportWords
) -> str:
    """What is worth a look, in words; a correlation within two standard errors of zero counts as
    none.
    """
    notes = []
    if facility is not None and facility < _HARD:
        notes.append(words.hard)
    if facility is not None and facility > _EASY:
        notes.append(words.easy)
    if discrimination is not None and discrimination < _FLAT:
        notes.append(words.negative if discrimination < -2 / students**0.5 else words.flat)
    return "; ".join(notes)


def _loss_rows(counts: ClassTally, wording: Wording, words: ReportWords) -> Iterator[_Page]:
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
                "reason": _reason_text(reason, wording, words),
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
                "question": words.numbered.format(find_bank_number(question)),
                "title": wording.titles.get(question, ""),
                "rows": rows,
            }


def _by_question(counts: ClassTally) -> Mapping[str, Counter[str]]:
    """The reasons of all asks of a question together."""
    found: dict[str, Counter[str]] = {}
    for column in counts.columns:
        found.setdefault(column.split(".")[0], Counter()).update(counts.losses[column])
    return found


def _reason_text(reason: str, wording: Wording, words: ReportWords) -> str:
    """A reason in words: the sentence for a known mistake, or the words for a hint or a verdict."""
    return wording.mistakes.get(reason) or words.reasons.get(reason) or reason


def _hardness_part(
    counts: ClassTally, exam: ExamFolder, wording: Wording, words: ReportWords
) -> _Page:
    """Whether papers were equally hard: versions compared with each other, or drawn numbers
    compared with points.
    """
    enough = len(counts.answered) >= ENOUGH
    part: _Page = {"enough_students": enough, "versions": (), "trends": (), "verdict_on_papers": ""}
    if any(counts.versions):
        return part | _versions_part(counts, exam, wording, words, enough)
    shares = {question: counts.share(question) for question in exam.questions}
    trends = find_parameter_trends(counts.parameters, shares) if enough else ()
    if not enough:
        verdict = words.too_few.format(ENOUGH)
    elif not trends:
        verdict = words.same_papers
    else:
        clear = trends[0].adjusted < _SIGNIFICANT
        verdict = (
            f"{words.trends.format(len(trends))} {words.trend_found if clear else words.no_trend}"
        )
    rows = [_trend_row(trend, wording, words) for trend in trends[:_MOST_TRENDS]]
    return part | {"trends": rows, "verdict_on_papers": verdict}


def _versions_part(
    counts: ClassTally, exam: ExamFolder, wording: Wording, words: ReportWords, enough: bool
) -> _Page:
    """The versions of an exam compared with each other."""
    letters = sorted(set(counts.versions))
    percents = {
        letter: [
            value
            for value, version in zip(counts.percents, counts.versions, strict=True)
            if version == letter
        ]
        for letter in letters
    }
    groups = [(letter, figures) for letter in letters if (figures := summarise(percents[letter]))]
    test = compare_groups(counts.points.sum(axis=1), counts.versions) if enough else None
    verdict = words.too_few.format(ENOUGH) if not enough else ""
    if test is not None:
        measured = words.test_of_versions.format(
            _decimal(test.statistic), _p_text(test.p), f"{test.permutations:,}"
        )
        verdict = (
            f"{measured} {words.versions_differ if test.p < _SIGNIFICANT else words.versions_alike}"
        )
    rows = [
        {
            "letter": letter,
            "figures": figures,
            "mean": _percent(figures.mean),
            "sd": "–" if figures.sd is None else _percent(figures.sd),
            "questions": [_version_share(counts, letter, question) for question in exam.questions],
        }
        for letter, figures in groups
    ]
    names = [(f"{words.version} {letter} ({figures.count})", figures) for letter, figures in groups]
    return {
        "versions": rows,
        "version_plot": write_box_plot(names, words.percent_axis, words.hardness),
        "verdict_on_papers": verdict,
    }


def _version_share(counts: ClassTally, letter: str, question: str) -> str:
    """The facility of a question in one version."""
    members = [place for place, version in enumerate(counts.versions) if version == letter]
    share = float(counts.share(question)[members].mean())
    return _share_text(None if isnan(share) else share)


def _trend_row(trend: ParameterTrend, wording: Wording, words: ReportWords) -> _Page:
    """One drawn number, and how points vary with it."""
    known = wording.parameters.get((trend.question, trend.parameter))
    thirds = [(_share_text(third.share), _span_text(third), third.count) for third in trend.thirds]
    return {
        "question": words.numbered.format(find_bank_number(trend.question)),
        "symbol": write_symbol_html(known) if known else trend.parameter,
        "thirds": thirds,
        "correlation": _decimal(trend.correlation),
        "p": _p_text(trend.test.p),
        "adjusted": _p_text(trend.adjusted),
    }


def _span_text(third: Third) -> str:
    """The range of a third, from its lowest to its highest number."""
    return " … ".join(
        dict.fromkeys(f"{bound:g}".replace("-", "−") for bound in (third.lowest, third.highest))
    )


def _percent(value: float) -> str:
    """A percentage with one decimal."""
    return f"{value:.1f} %"


def _share_text(share: float | None) -> str:
    """A share as a whole percentage; a dash for None."""
    return "–" if share is None else f"{100 * share:.0f} %"


def _decimal(value: float | None) -> str:
    """Two decimals with a minus sign; a dash for None."""
    return "–" if value is None else f"{value:.2f}".replace("-0.00", "0.00").replace("-", "−")


def _p_text(p: float) -> str:
    """A p-value as it is printed."""
    return "< 0.001" if p < 0.001 else f"{p:.3f}"
