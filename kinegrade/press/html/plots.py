"""Plots as SVG for an HTML page: no scripts, no embedded fonts; the page's CSS gives the shades.

Lengths are pixels at the plot's natural width. All text is escaped.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from typing import assert_never

from markupsafe import Markup

from kinegrade.press.class_charts import Bar, BoxPlot, Histogram, HistogramPlot, StackedBar, Summary
from kinegrade.press.class_sheet import Plot

_WIDTH = 640.0
_LEFT, _RIGHT = 44.0, 12.0


@dataclass(frozen=True)
class _Axis:
    """Maps percentages to pixels."""

    left: float = _LEFT
    width: float = _WIDTH - _LEFT - _RIGHT

    def at(self, percent: float) -> float:
        """The position of a value from 0 to 100."""
        return self.left + self.width * min(max(percent, 0.0), 100.0) / 100


def write_plot(plot: Plot) -> Markup:
    """A plot as an SVG element."""
    match plot:
        case HistogramPlot():
            return _write_histogram(plot)
        case BoxPlot():
            return _write_boxes(plot)
        case Bar():
            return _write_bar(plot)
        case StackedBar():
            return _write_stacked_bar(plot)
        case _:
            assert_never(plot)


def _write_histogram(plot: HistogramPlot) -> Markup:
    """Columns; a triangle marks the median, below it a circle the mean, as the two are often
    equal.
    """
    distribution, figures = plot.histogram, plot.figures
    top, height, axis = 22.0, 150.0, _Axis()
    base, most = top + height, max(1, *distribution.counts)
    parts = list(_write_columns(distribution, axis, base, height / most))
    parts += _write_levels(most, axis, base, height)
    parts.append(_write_line(axis.left, base, axis.left + axis.width, base, "axis"))
    parts += [
        _write_text(axis.at(edge), base + 16, f"{edge:g}", "middle") for edge in distribution.edges
    ]
    median, mean = axis.at(figures.median), axis.at(figures.mean)
    parts.append(f'<path class="mark" d="M{median:.1f} {base + 20:.1f}l5 9h-10z"/>')
    parts.append(f'<circle class="mark" cx="{mean:.1f}" cy="{base + 37:.1f}" r="3.6" fill="none"/>')
    parts.append(_write_text(axis.left + axis.width, base + 58, plot.across, "end"))
    parts.append(_write_text(axis.left, base + 58, plot.marks, "start"))
    parts.append(_write_text(4, 11, plot.upward, "start"))
    return _write_svg(_WIDTH, base + 64, parts, plot.across)


def _write_boxes(plot: BoxPlot) -> Markup:
    """For each group a box from the lower to the upper quartile, a bar at the median, a circle
    below it at the mean.
    """
    row, axis = 38.0, _Axis(110.0, _WIDTH - 110.0 - _RIGHT)
    base = row * len(plot.groups) + 6
    parts = [
        part
        for edge in range(0, 101, 20)
        for part in (
            _write_line(axis.at(edge), 2, axis.at(edge), base, "grid"),
            _write_text(axis.at(edge), base + 16, str(edge), "middle"),
        )
    ]
    for place, (name, figures) in enumerate(plot.groups):
        parts += _write_box(name, figures, axis, row * place + 20)
    parts.append(_write_text(axis.left + axis.width, base + 34, plot.across, "end"))
    return _write_svg(_WIDTH, base + 40, parts, plot.label)


def _write_stacked_bar(plot: StackedBar) -> Markup:
    width, start, bars = 170.0, 0.0, []
    for shade, share in plot.parts:
        bars.append(
            f'<rect class="{escape(shade)}" x="{start:.1f}" y="0" width="{share * width:.1f}" '
            'height="13"/>'
        )
        start += share * width
    return _write_svg(width, 13, bars, plot.label)


def _write_bar(plot: Bar) -> Markup:
    width, share = plot.width, plot.share
    length = max(1.0 if share else 0.0, min(share, 1.0) * width)
    track = f'<rect class="track" x="0" y="0" width="{width:g}" height="12"/>'
    part = f'<rect class="{escape(plot.shade)}" x="0" y="0" width="{length:.1f}" height="12"/>'
    return _write_svg(width, 12, [track, part] if plot.track else [part], plot.label)


def _write_columns(
    distribution: Histogram, axis: _Axis, base: float, scale: float
) -> Iterator[str]:
    for left, right, count in zip(
        distribution.edges, distribution.edges[1:], distribution.counts, strict=False
    ):
        start, end = axis.at(left), axis.at(right)
        yield (
            f'<rect class="column" x="{start + 1:.1f}" y="{base - count * scale:.1f}" '
            f'width="{end - start - 2:.1f}" height="{count * scale:.1f}"/>'
        )
        if count:
            yield _write_text((start + end) / 2, base - count * scale - 4, str(count), "middle")


def _write_levels(most: int, axis: _Axis, base: float, height: float) -> Iterator[str]:
    """Counts along the left edge, at round steps."""
    step = next(
        step
        for power in range(8)
        for step in (10**power, 2 * 10**power, 5 * 10**power)
        if 5 * step >= most
    )
    for count in range(0, most + 1, step):
        yield _write_text(axis.left - 8, base - height * count / most + 4, str(count), "end")


def _write_box(name: str, figures: Summary, axis: _Axis, middle: float) -> list[str]:
    lower, upper, median = axis.at(figures.lower), axis.at(figures.upper), axis.at(figures.median)
    return [
        _write_text(axis.left - 10, middle + 4, name, "end"),
        _write_line(axis.at(figures.minimum), middle, axis.at(figures.maximum), middle, "axis"),
        f'<rect class="box" x="{lower:.1f}" y="{middle - 9:.1f}" '
        f'width="{max(1.0, upper - lower):.1f}" height="18"/>',
        _write_line(median, middle - 9, median, middle + 9, "median"),
        f'<circle class="mark" cx="{axis.at(figures.mean):.1f}" cy="{middle + 14.5:.1f}" r="3.6" '
        'fill="none"/>',
    ]


def _write_line(x1: float, y1: float, x2: float, y2: float, shade: str) -> str:
    return f'<line class="{shade}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>'


def _write_text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(text)}</text>'


def _write_svg(width: float, height: float, parts: Sequence[str], label: str) -> Markup:
    head = (
        f'<svg viewBox="0 0 {width:g} {height:g}" width="{width:g}" height="{height:g}" role="img"'
    )
    # Texts are escaped
    return Markup(f'{head} aria-label="{escape(label)}">{"".join(parts)}</svg>')
