"""The parts of a class, such as versions of the exam or groups of the roster, each with its totals
and how it did in each question.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language.catalogue import Catalogue
from kinegrade.press.class_charts import Summary
from kinegrade.press.class_sheet import PartLine
from kinegrade.reports.classes.figures import write_deviation, write_percent, write_share
from kinegrade.reports.classes.item_statistics import summarise
from kinegrade.reports.classes.tally import ClassTally


def list_parts(
    counts: ClassTally, names: Sequence[str], exam: ExamFolder, catalogue: Catalogue
) -> tuple[PartLine, ...]:
    """A line for each part; `names` says to which one each student belongs who answered."""
    return tuple(
        PartLine(
            name or catalogue.text("report.no-part"),
            figures.count,
            write_percent(figures.mean, catalogue),
            write_deviation(figures.sd, catalogue),
            _write_shares(counts, [each == name for each in names], exam, catalogue),
        )
        for name, figures in summarise_parts(counts, names)
    )


def summarise_parts(counts: ClassTally, names: Sequence[str]) -> list[tuple[str, Summary]]:
    """The totals of each part to which somebody belongs, by its name."""
    percents: dict[str, list[float]] = {name: [] for name in sorted(set(names))}
    for value, name in zip(counts.percents, names, strict=True):
        percents[name].append(value)
    found = ((name, summarise(values)) for name, values in percents.items())
    return [(name, figures) for name, figures in found if figures]


def _write_shares(
    counts: ClassTally, members: Sequence[bool], exam: ExamFolder, catalogue: Catalogue
) -> tuple[str, ...]:
    """The facility of each question in one part."""
    places = [place for place, member in enumerate(members) if member]
    shares = [counts.share(question)[places] for question in exam.questions]
    known = [share[~np.isnan(share)] for share in shares]
    return tuple(
        write_share(float(each.mean()) if len(each) else None, catalogue) for each in known
    )
