"""The figures of the class report in digits, with the decimal mark of its language."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message
from kinegrade.press.class_sheet import Trend
from kinegrade.reports.classes.equal_hardness import ParameterTrend, Third

_NONE = "–"  # in place of a figure that cannot be given
_LEAST = 0.001  # p-values below are not told apart


def write_percent(value: float, catalogue: Catalogue) -> str:
    """A percentage with one decimal."""
    return catalogue.write(Message("grammar.percent", number=Decimal(f"{value:.1f}")))


def write_share(share: float | None, catalogue: Catalogue) -> str:
    """A share as a whole percentage; a dash for None."""
    if share is None:
        return _NONE
    return catalogue.write(Message("grammar.percent", number=Decimal(f"{100 * share:.0f}")))


def write_deviation(sd: float | None, catalogue: Catalogue) -> str:
    """A standard deviation as a percentage; a dash for None."""
    return _NONE if sd is None else write_percent(sd, catalogue)


def write_decimal(value: float | None, catalogue: Catalogue) -> str:
    """Two decimals with a minus sign; a dash for None."""
    if value is None:
        return _NONE
    rounded = Decimal(f"{value:.2f}") or Decimal("0.00")  # never -0.00
    return catalogue.write_number(rounded).replace("-", "−")


def write_plain(value: float, catalogue: Catalogue) -> str:
    """A number as short as it can be written to six digits."""
    return catalogue.write_number(Decimal(f"{value:g}")).replace("-", "−")


def write_trend(trend: ParameterTrend, thirds: Sequence[Third], catalogue: Catalogue) -> Trend:
    """What a trend comes to, with its thirds as they are shown."""
    return Trend(
        tuple(_write_third(third, catalogue) for third in thirds),
        write_decimal(trend.correlation, catalogue),
        write_p(trend.test.p, catalogue),
        write_p(trend.adjusted, catalogue),
    )


def _write_third(third: Third, catalogue: Catalogue) -> tuple[str, str, int]:
    """The share of the points in a third, its lowest and highest number, and its size."""
    bounds = [write_plain(bound, catalogue) for bound in (third.lowest, third.highest)]
    return write_share(third.share, catalogue), " … ".join(dict.fromkeys(bounds)), third.count


def write_p(p: float, catalogue: Catalogue) -> str:
    """A p-value as it is printed."""
    if p < _LEAST:
        return catalogue.write(Message("report.p-below", number=Decimal(str(_LEAST))))
    return catalogue.write_number(Decimal(f"{p:.3f}"))
