"""The part of the class report on what was predicted: whether papers that their numbers made harder
did lose more points, by question and on the whole.

A predicted difficulty is a combination of all numbers of a paper (`students.difficulty`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message
from kinegrade.press.class_sheet import PredictedHardness, PredictionLine
from kinegrade.reports.classes.equal_hardness import (
    SIGNIFICANT,
    ParameterTrend,
    Third,
    find_parameter_trends,
)
from kinegrade.reports.classes.figures import write_decimal, write_trend
from kinegrade.reports.classes.item_statistics import Points
from kinegrade.reports.classes.tally import ClassTally
from kinegrade.reports.classes.words import name_question

_WHOLE = ""  # in place of a question: the whole paper


def judge_predictions(counts: ClassTally, catalogue: Catalogue) -> PredictedHardness | None:
    """What is said of predictions; None where there are none, or they are the same for all."""
    predicted, lost = _list_predictions(counts)
    trends = find_parameter_trends({(name, ""): row for name, row in predicted.items()}, lost)
    if not trends:
        return None
    order = [*predicted]
    return PredictedHardness(
        catalogue.write(Message("report.predicted", conclusion=_judge(trends))),
        tuple(
            _describe(trend, predicted[trend.question], catalogue)
            for trend in sorted(trends, key=lambda trend: order.index(trend.question))
        ),
    )


def _list_predictions(counts: ClassTally) -> tuple[dict[str, Points], dict[str, Points]]:
    """Predicted points and the share of points lost, by question; of several questions also on the
    whole.
    """
    predicted: dict[str, Points] = dict(counts.difficulties)
    lost = {question: 1 - counts.share(question) for question in predicted}
    if len(predicted) > 1:
        asked = [np.where(np.isnan(lost[name]), 0.0, row) for name, row in predicted.items()]
        predicted[_WHOLE] = np.sum(asked, axis=0)
        lost[_WHOLE] = counts.lost
    return predicted, lost


def _judge(trends: Sequence[ParameterTrend]) -> Message:
    """The conclusion from the clearest trend, which stands first."""
    if trends[0].adjusted >= SIGNIFICANT:
        return Message("report.prediction-not-seen")
    held = trends[0].correlation > 0
    return Message("report.prediction-held" if held else "report.prediction-reversed")


def _describe(trend: ParameterTrend, predicted: Points, catalogue: Catalogue) -> PredictionLine:
    known = predicted[np.isfinite(predicted)]
    mean, spread = (write_decimal(float(each), catalogue) for each in (known.mean(), known.std()))
    whole = trend.question == _WHOLE
    return PredictionLine(
        catalogue.text("report.whole-paper") if whole else name_question(trend.question, catalogue),
        f"{mean} ± {spread}",
        write_trend(trend, [*map(_show_third, trend.thirds)], catalogue),
    )


def _show_third(third: Third) -> Third:
    """A third by the share of points that were kept, as facilities are."""
    lowest, highest = round(third.lowest, 2), round(third.highest, 2)
    return Third(lowest, highest, third.count, 1 - third.share)
