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
    kruskal_wallis,
    parameter_trends,
)
from kinegrade.grading.html_layout import layout
from kinegrade.grading.item_statistics import (
    Summary,
    discriminations,
    facilities,
    histogram,
    reliability,
    summary,
)
from kinegrade.grading.math_html import symbol_html
from kinegrade.grading.plots import bar, box_plot, histogram_plot, stacked_bar
from kinegrade.grading.report_words import ReportWords, report_words_of
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import COMPLAINTS
from kinegrade.question_numbers import bank_number

Page = dict[str, Any]  # the values a layout reads
HARD, EASY, FLAT = 0.3, 0.9, 0.1
SIGNIFICANT = 0.05
MOST_COMPLAINTS, MOST_TRENDS = 200, 8
VERDICTS = (
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
LAST = ("unexplained", "wrong unit", "unreadable", "blank")  # the least informative reasons
SHADES = {verdict: f"shade{place}" for place, verdict in enumerate(VERDICTS)}


def class_report(marks: MarksFolder, exam: ExamFolder, wording: Wording, language: Language) -> str:
    """The page for a marks folder, with the exam folder it was made from. Raises TableError,
    ExamError.
    """
    counts, words = tally(marks, exam), report_words_of(language)
    page: Page = {
        "words": words,
        "exam": exam.head,
        "heads": [words.numbered.format(bank_number(name)) for name in exam.questions],
        "answered": len(counts.answered),
        "silent": [f"{each.name} ({each.student})" for each in counts.silent],
        "roster": len(counts.answered) + len(counts.silent),
        "enough": ENOUGH,
        "complaints": marks.complaints(),
        "complaints_file": COMPLAINTS.name,
        "most_complaints": MOST_COMPLAINTS,
    }
    figures = summary(counts.percents)
    if figures is not None:
        page |= {
            **totals_part(counts, figures, words),
            "asks": list(ask_rows(counts, wording, words)),
            "legend": legend(counts, words),
            "losses": list(loss_rows(counts, wording, words)),
            **hardness_part(counts, exam, wording, words),
        }
    return layout("class_report.html").render(page)


def totals_part(counts: ClassTally, figures: Summary, words: ReportWords) -> Page:
    """The distribution of the totals: figures and a plot."""
    out_of = max(each.out_of for each in counts.answered)
    alpha = reliability(counts.points)
    cards = [
        (percent(figures.mean), words.mean),
        (percent(figures.median), words.median),
        ("–" if figures.sd is None else percent(figures.sd), words.sd),
        (f"{percent(figures.lower)} – {percent(figures.upper)}", words.quartiles),
        (f"{percent(figures.minimum)} – {percent(figures.maximum)}", words.span),
        (decimal(alpha), words.reliability),
    ]
    plot = histogram_plot(
        histogram(counts.percents), figures, words.percent_axis, words.students, words.marks_on_axis
    )
    return {
        "cards": cards,
        "distribution": plot,
        "out_of": words.of_points.format(f"{float(out_of):g}"),
    }


def ask_rows(counts: ClassTally, wording: Wording, words: ReportWords) -> Iterator[Page]:
    """One table line for each ask."""
    shares, correlations = facilities(counts.points, counts.out_of), discriminations(counts.points)
    for place, column in enumerate(counts.columns):
        facility, discrimination, verdicts = (
            shares[place],
            correlations[place],
            counts.verdicts[column],
        )
        question = column.split(".")[0]
        yield {
            "question": words.numbered.format(bank_number(question)),
            "title": wording.titles.get(question, ""),
            "first": place == 0 or counts.columns[place - 1].split(".")[0] != question,
            "symbol": symbol_of(column, wording),
            "meaning": wording.meanings.get(column, ""),
            "points": f"{counts.out_of[place]:g}",
            "facility": share_text(facility),
            "bar": bar(facility or 0.0, "column", share_text(facility), 70.0, track=True),
            "discrimination": decimal(discrimination),
            "answers": verdict_bar(verdicts, words),
            "verdicts": verdict_text(verdicts, words),
            "note": note(facility, discrimination, len(counts.answered), words),
        }


def symbol_of(column: str, wording: Wording) -> Markup:
    """The symbol of an ask, or its name where no symbol is known."""
    known = wording.symbols.get(column)
    return Markup.escape(column.split(".", 1)[1]) if known is None else symbol_html(known)


def verdict_bar(verdicts: Counter[str], words: ReportWords) -> Markup:
    """All answers to an ask as a single bar."""
    whole = verdicts.total()
    parts = [
        (SHADES.get(verdict, "shade5"), count / whole) for verdict, count in in_order(verdicts)
    ]
    return stacked_bar(parts, verdict_text(verdicts, words))


def verdict_text(verdicts: Counter[str], words: ReportWords) -> str:
    """How often each verdict was given."""
    return ", ".join(
        f"{words.verdicts.get(verdict, verdict)}\u00a0{count}"
        for verdict, count in in_order(verdicts)
    )


def in_order(verdicts: Counter[str]) -> list[tuple[str, int]]:
    """Verdicts with their counts, right answers first, unknown verdicts last."""
    known = [verdict for verdict in VERDICTS if verdicts[verdict]]
    return [
        (verdict, verdicts[verdict]) for verdict in (*known, *sorted(set(verdicts) - set(VERDICTS)))
    ]


def legend(counts: ClassTally, words: ReportWords) -> list[tuple[str, str]]:
    """The shades of the verdicts that occur."""
    occurring = sum(counts.verdicts.values(), Counter[str]())
    return [
        (SHADES.get(verdict, "shade5"), words.verdicts.get(verdict, verdict))
        for verdict, _ in in_order(occurring)
    ]


def note(
    facility: float | None, discrimination: float | None, students: int, words: ReportWords
) -> str:
    """What is worth a look, in words; a correlation within two standard errors of zero counts as
    none.
    """
    notes = []
    if facility is not None and facility < HARD:
        notes.append(words.hard)
    if facility is not None and facility > EASY:
        notes.append(words.easy)
    if discrimination is not None and discrimination < FLAT:
        notes.append(words.negative if discrimination < -2 / students**0.5 else words.flat)
    return "; ".join(notes)


def loss_rows(counts: ClassTally, wording: Wording, words: ReportWords) -> Iterator[Page]:
    """For each question the reasons why points were lost, the most frequent first."""
    most = max(
        (reasons.most_common(1)[0][1] for reasons in by_question(counts).values() if reasons),
        default=1,
    )
    for question, reasons in by_question(counts).items():
        ordered = sorted(
            reasons.items(), key=lambda reason: (reason[0] in LAST, -reason[1], reason[0])
        )
        rows = [
            {
                "reason": reason_text(reason, wording, words),
                "count": count,
                "bar": bar(count / most, "faint" if reason in LAST else "column", str(count)),
                "asks": [
                    (symbol_of(column, wording), counts.losses[column][reason])
                    for column in counts.columns
                    if column.startswith(f"{question}.") and counts.losses[column][reason]
                ],
            }
            for reason, count in ordered
        ]
        if rows:
            yield {
                "question": words.numbered.format(bank_number(question)),
                "title": wording.titles.get(question, ""),
                "rows": rows,
            }


def by_question(counts: ClassTally) -> Mapping[str, Counter[str]]:
    """The reasons of all asks of a question together."""
    found: dict[str, Counter[str]] = {}
    for column in counts.columns:
        found.setdefault(column.split(".")[0], Counter()).update(counts.losses[column])
    return found


def reason_text(reason: str, wording: Wording, words: ReportWords) -> str:
    """A reason in words: the sentence for a known mistake, or the words for a hint or a verdict."""
    return wording.mistakes.get(reason) or words.reasons.get(reason) or reason


def hardness_part(
    counts: ClassTally, exam: ExamFolder, wording: Wording, words: ReportWords
) -> Page:
    """Whether papers were equally hard: versions compared with each other, or drawn numbers
    compared with points.
    """
    enough = len(counts.answered) >= ENOUGH
    part: Page = {"enough_students": enough, "versions": (), "trends": (), "verdict_on_papers": ""}
    if any(counts.versions):
        return part | versions_part(counts, exam, wording, words, enough)
    shares = {question: counts.share(question) for question in exam.questions}
    trends = parameter_trends(counts.parameters, shares) if enough else ()
    if not enough:
        verdict = words.too_few.format(ENOUGH)
    elif not trends:
        verdict = words.same_papers
    else:
        clear = trends[0].adjusted < SIGNIFICANT
        verdict = (
            f"{words.trends.format(len(trends))} {words.trend_found if clear else words.no_trend}"
        )
    rows = [trend_row(trend, wording, words) for trend in trends[:MOST_TRENDS]]
    return part | {"trends": rows, "verdict_on_papers": verdict}


def versions_part(
    counts: ClassTally, exam: ExamFolder, wording: Wording, words: ReportWords, enough: bool
) -> Page:
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
    groups = [(letter, figures) for letter in letters if (figures := summary(percents[letter]))]
    test = kruskal_wallis(counts.points.sum(axis=1), counts.versions) if enough else None
    verdict = words.too_few.format(ENOUGH) if not enough else ""
    if test is not None:
        measured = words.test_of_versions.format(
            decimal(test.statistic), p_text(test.p), f"{test.permutations:,}"
        )
        verdict = (
            f"{measured} {words.versions_differ if test.p < SIGNIFICANT else words.versions_alike}"
        )
    rows = [
        {
            "letter": letter,
            "figures": figures,
            "mean": percent(figures.mean),
            "sd": "–" if figures.sd is None else percent(figures.sd),
            "questions": [version_share(counts, letter, question) for question in exam.questions],
        }
        for letter, figures in groups
    ]
    names = [(f"{words.version} {letter} ({figures.count})", figures) for letter, figures in groups]
    return {
        "versions": rows,
        "version_plot": box_plot(names, words.percent_axis, words.hardness),
        "verdict_on_papers": verdict,
    }


def version_share(counts: ClassTally, letter: str, question: str) -> str:
    """The facility of a question in one version."""
    members = [place for place, version in enumerate(counts.versions) if version == letter]
    share = float(counts.share(question)[members].mean())
    return share_text(None if isnan(share) else share)


def trend_row(trend: ParameterTrend, wording: Wording, words: ReportWords) -> Page:
    """One drawn number, and how points vary with it."""
    known = wording.parameters.get((trend.question, trend.parameter))
    thirds = [(share_text(third.share), span_text(third), third.count) for third in trend.thirds]
    return {
        "question": words.numbered.format(bank_number(trend.question)),
        "symbol": symbol_html(known) if known else trend.parameter,
        "thirds": thirds,
        "correlation": decimal(trend.correlation),
        "p": p_text(trend.test.p),
        "adjusted": p_text(trend.adjusted),
    }


def span_text(third: Third) -> str:
    """The range of a third, from its lowest to its highest number."""
    return " … ".join(
        dict.fromkeys(f"{bound:g}".replace("-", "−") for bound in (third.lowest, third.highest))
    )


def percent(value: float) -> str:
    """A percentage with one decimal."""
    return f"{value:.1f} %"


def share_text(share: float | None) -> str:
    """A share as a whole percentage; a dash for None."""
    return "–" if share is None else f"{100 * share:.0f} %"


def decimal(value: float | None) -> str:
    """Two decimals with a minus sign; a dash for None."""
    return "–" if value is None else f"{value:.2f}".replace("-0.00", "0.00").replace("-", "−")


def p_text(p: float) -> str:
    """A p-value as it is printed."""
    return "< 0.001" if p < 0.001 else f"{p:.3f}"
