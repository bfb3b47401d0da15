"""What a paper and an answer cost by the size of the class, as a picture for the documentation.

    python -m benchmarks.class_plot docs/pictures/class-costs.svg

measures `generate` for a paper and `grade` for an answer, and draws both over sizes on a scale of
powers of ten. It is time of the processor, of one process; of marking it is the best of three runs.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.class_sizes import measure
from benchmarks.large_class import COLUMNS, write_class
from benchmarks.marking import ours

PAPERS = (10, 100, 1000)
ANSWERS = (10_000, 100_000, 1_000_000)
RUNS = 3
WIDTH, HEIGHT = 300, 170  # of a panel, in points
LEFT, BELOW, ABOVE, BETWEEN = 40, 34, 24, 30


@dataclass(frozen=True)
class Panel:
    """Costs by size: what is counted, and in which unit."""

    title: str
    sizes: Sequence[int]
    costs: Sequence[float]


def measure_papers(sizes: Sequence[int]) -> Panel:
    """Milliseconds for a paper, beyond what the program takes to start and to read its bank."""
    with TemporaryDirectory() as name:
        costs = [measure(Path(name), size) for size in (1, *sizes)]
    alone, *more = [each.seconds for each in costs]
    each_paper = [1e3 * (cost - alone) / (size - 1) for cost, size in zip(more, sizes, strict=True)]
    return Panel("milliseconds a paper, by papers", sizes, each_paper)


def measure_answers(sizes: Sequence[int]) -> Panel:
    """Microseconds for an answer, all of `grade`."""
    costs = []
    for size in sizes:
        with TemporaryDirectory() as name:
            students = size // len(COLUMNS)
            write_class(Path(name), students, 0.0)
            costs.append(1e6 * min(ours(Path(name), students) for _ in range(RUNS)))
    return Panel("microseconds an answer, by answers", sizes, costs)


def draw(panels: Sequence[Panel]) -> str:
    """The panels side by side, as SVG."""
    width = len(panels) * (WIDTH + LEFT + BETWEEN)
    height = ABOVE + HEIGHT + BELOW
    parts = [
        f'<g transform="translate({LEFT + place * (WIDTH + LEFT + BETWEEN)} {ABOVE})">'
        + "".join(draw_panel(panel))
        + "</g>"
        for place, panel in enumerate(panels)
    ]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        f'font-family="sans-serif" font-size="11">\n'
        f'<rect width="{width}" height="{height}" fill="white"/>\n'
        + "\n".join(parts)
        + "\n</svg>\n"
    )


def draw_panel(panel: Panel) -> Iterator[str]:
    """The axes with their numbers, and a point for each size."""
    first, last = floor(log10(min(panel.sizes))), ceil(log10(max(panel.sizes)))
    step = choose_step(max(panel.costs))
    top = step * ceil(1.1 * max(panel.costs) / step)
    yield f'<text x="0" y="-10" font-weight="bold">{panel.title}</text>'
    for power in range(first, last + 1):
        across = WIDTH * (power - first) / (last - first)
        yield f'<path d="M{across:.1f} 0V{HEIGHT}" stroke="#ddd"/>'
        yield f'<text x="{across:.1f}" y="{HEIGHT + 16}" text-anchor="middle">{10**power:,}</text>'
    for number in range(round(top / step) + 1):
        up = HEIGHT * (1 - number * step / top)
        yield f'<path d="M0 {up:.1f}H{WIDTH}" stroke="#ddd"/>'
        yield f'<text x="-6" y="{up + 4:.1f}" text-anchor="end">{number * step:g}</text>'
    points = [
        (WIDTH * (log10(size) - first) / (last - first), HEIGHT * (1 - cost / top))
        for size, cost in zip(panel.sizes, panel.costs, strict=True)
    ]
    line = " ".join(f"{across:.1f},{up:.1f}" for across, up in points)
    yield f'<polyline points="{line}" fill="none" stroke="#1a5fb4" stroke-width="1.5"/>'
    for across, up in points:
        yield f'<circle cx="{across:.1f}" cy="{up:.1f}" r="3.5" fill="#1a5fb4"/>'


def choose_step(most: float) -> float:
    """A round step with which at most six lines reach `most`.

    >>> choose_step(0.19), choose_step(7), choose_step(230)
    (0.05, 2, 50)
    """
    power = 10.0 ** floor(log10(most / 5))
    return next(times * power for times in (1, 2, 5, 10) if most / (times * power) <= 5)


def main() -> None:
    """Measure, print the figures and write the picture."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.class_plot")
    parser.add_argument("picture", type=Path)
    parser.add_argument("--papers", nargs="+", type=int, default=PAPERS)
    parser.add_argument("--answers", nargs="+", type=int, default=ANSWERS)
    options = parser.parse_args()
    panels = [measure_papers(options.papers), measure_answers(options.answers)]
    for panel in panels:
        print(panel.title)
        for size, cost in zip(panel.sizes, panel.costs, strict=True):
            print(f"{size:>10,} {cost:8.2f}")
    options.picture.write_text(draw(panels), encoding="utf-8")


if __name__ == "__main__":
    main()
