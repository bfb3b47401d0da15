"""The charts on the report on a class, free of any typesetter."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Summary:
    """A distribution in figures; `sd` divides by n - 1 and is None for a single value. Quartiles
    interpolate linearly.
    """

    count: int
    mean: float
    sd: float | None
    minimum: float
    lower: float
    median: float
    upper: float
    maximum: float


@dataclass(frozen=True)
class Histogram:
    """Counts between edges; a value on an edge counts to the right, on the last edge in the last
    bin.
    """

    edges: tuple[float, ...]
    counts: tuple[int, ...]


@dataclass(frozen=True)
class HistogramPlot:
    """Columns of students over percentages of the points, with marks at the median and the mean."""

    histogram: Histogram
    figures: Summary
    across: str
    upward: str
    marks: str


@dataclass(frozen=True)
class BoxPlot:
    """The distribution of the percentages of each group, by its name."""

    groups: tuple[tuple[str, Summary], ...]
    across: str
    label: str


@dataclass(frozen=True)
class Bar:
    """A share from 0 to 1; a track shows the length of 1. Shades are names of the style sheet."""

    share: float
    shade: str
    label: str
    width: float = 260.0
    track: bool = False


@dataclass(frozen=True)
class StackedBar:
    """Shares that add up to at most 1, each with its shade."""

    parts: tuple[tuple[str, float], ...]
    label: str
