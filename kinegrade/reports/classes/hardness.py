"""The part of the class report on whether papers were equally hard: versions compared with each
other, or drawn numbers compared with points.

`class_report` calls it; `equal_hardness` has the tests.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan
from typing import Any

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message, Text
from kinegrade.press.html.short_texts import write_symbol_html
from kinegrade.question_numbers import find_bank_number
from kinegrade.reports.classes.equal_hardness import (
    ENOUGH,
    ParameterTrend,
    Third,
    compare_groups,
    find_parameter_trends,
)
from kinegrade.reports.classes.figures import (
    write_decimal,
    write_deviation,
    write_p,
    write_percent,
    write_plain,
    write_share,
)
from kinegrade.reports.classes.item_statistics import Summary, summarise
from kinegrade.reports.classes.plots import write_box_plot
from kinegrade.reports.classes.tally import ClassTally

_Page = dict[str, Any]  # the values a layout reads
_SIGNIFICANT = 0.05
_MOST_TRENDS = 8
_TOO_FEW = Message("report.too-few", enough=ENOUGH)


def make_hardness_part(
    counts: ClassTally, exam: ExamFolder, wording: Wording, catalogue: Catalogue
) -> _Page:
    """What the layout shows of it."""
    if any(counts.versions):
        return _make_versions_part(counts, exam, catalogue)
    enough = len(counts.answered) >= ENOUGH
    shares = {question: counts.share(question) for question in exam.questions}
    trends = find_parameter_trends(counts.parameters, shares) if enough else ()
    return {
        "versions": (),
        "trends": [_make_trend_row(trend, wording, catalogue) for trend in trends[:_MOST_TRENDS]],
        "verdict_on_papers": catalogue.write(_judge_trends(trends) if enough else _TOO_FEW),
    }


def _judge_trends(trends: Sequence[ParameterTrend]) -> Message:
    if not trends:
        return Message("report.same-papers")
    clear = trends[0].adjusted < _SIGNIFICANT
    conclusion = Message("report.trend-found") if clear else Message("report.no-trend")
    return Message("report.trends", numbers=len(trends), conclusion=conclusion)


def _make_trend_row(trend: ParameterTrend, wording: Wording, catalogue: Catalogue) -> _Page:
    """One drawn number, and how points vary with it."""
    known = wording.parameters.get((trend.question, trend.parameter))
    number = find_bank_number(trend.question)
    return {
        "question": catalogue.write(Message("report.numbered", number=number)),
        "symbol": write_symbol_html(known) if known else trend.parameter,
        "thirds": [_write_third(third, catalogue) for third in trend.thirds],
        "correlation": write_decimal(trend.correlation, catalogue),
        "p": write_p(trend.test.p, catalogue),
        "adjusted": write_p(trend.adjusted, catalogue),
    }


def _write_third(third: Third, catalogue: Catalogue) -> tuple[str, str, int]:
    """The share of the points in a third, its lowest and highest number, and its size."""
    bounds = [write_plain(bound, catalogue) for bound in (third.lowest, third.highest)]
    return write_share(third.share, catalogue), " … ".join(dict.fromkeys(bounds)), third.count


def _make_versions_part(counts: ClassTally, exam: ExamFolder, catalogue: Catalogue) -> _Page:
    """The versions of an exam compared with each other."""
    groups = _summarise_versions(counts)
    names = [(_name_version(letter, figures, catalogue), figures) for letter, figures in groups]
    axis, label = catalogue.text("report.percent-axis"), catalogue.text("report.page.hardness")
    return {
        "versions": [
            _make_version_row(letter, figures, catalogue)
            | {"questions": _write_version_shares(counts, letter, exam, catalogue)}
            for letter, figures in groups
        ],
        "version_plot": write_box_plot(names, axis, label),
        "trends": (),
        "verdict_on_papers": catalogue.write(_judge_versions(counts, catalogue)),
    }


def _summarise_versions(counts: ClassTally) -> list[tuple[str, Summary]]:
    """The totals of each version that somebody had, by its letter."""
    percents: dict[str, list[float]] = {letter: [] for letter in sorted(set(counts.versions))}
    for value, letter in zip(counts.percents, counts.versions, strict=True):
        percents[letter].append(value)
    found = ((letter, summarise(values)) for letter, values in percents.items())
    return [(letter, figures) for letter, figures in found if figures]


def _name_version(letter: str, figures: Summary, catalogue: Catalogue) -> str:
    return catalogue.write(Message("report.version-of", letter=letter, students=figures.count))


def _make_version_row(letter: str, figures: Summary, catalogue: Catalogue) -> _Page:
    return {
        "letter": letter,
        "figures": figures,
        "mean": write_percent(figures.mean, catalogue),
        "sd": write_deviation(figures.sd, catalogue),
    }


def _write_version_shares(
    counts: ClassTally, letter: str, exam: ExamFolder, catalogue: Catalogue
) -> list[str]:
    """The facility of each question in one version."""
    members = [place for place, version in enumerate(counts.versions) if version == letter]
    shares = [float(counts.share(question)[members].mean()) for question in exam.questions]
    return [write_share(None if isnan(share) else share, catalogue) for share in shares]


def _judge_versions(counts: ClassTally, catalogue: Catalogue) -> Text:
    if len(counts.answered) < ENOUGH:
        return _TOO_FEW
    test = compare_groups(counts.points.sum(axis=1), counts.versions)
    if test is None:
        return ""
    differ = test.p < _SIGNIFICANT
    return Message(
        "report.test-of-versions",
        statistic=write_decimal(test.statistic, catalogue),
        p=write_p(test.p, catalogue),
        permutations=test.permutations,
        conclusion=Message("report.versions-differ" if differ else "report.versions-alike"),
    )
