"""Plots of the class report: marks stand apart, even where median and mean are one."""

from __future__ import annotations

import re

from kinegrade.press.class_charts import BoxPlot, Histogram, HistogramPlot, Summary
from kinegrade.press.html.plots import write_plot

EQUAL = Summary(40, 50.0, 12.0, 0.0, 40.0, 50.0, 60.0, 100.0)


def test_median_and_mean_of_a_histogram_do_not_overlap() -> None:
    histogram = Histogram((0.0, 50.0, 100.0), (20, 20))
    svg = write_plot(HistogramPlot(histogram, EQUAL, "across", "upward", "marks"))
    triangle = re.search(r'd="M([\d.]+) ([\d.]+)l5 9h-10z"', svg)
    circle = re.search(r'cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"', svg)
    assert triangle is not None
    assert circle is not None
    assert triangle[1] == circle[1]
    assert float(triangle[2]) + 9 < float(circle[2]) - float(circle[3])
    words = [
        float(y) for y in re.findall(r'<text x="[\d.]+" y="([\d.]+)"[^>]*>(?:marks|across)', svg)
    ]
    assert min(words) - 12 > float(circle[2]) + float(circle[3])


def test_the_mean_of_a_box_stands_clear_of_its_box_and_of_the_next_row() -> None:
    svg = write_plot(BoxPlot((("A", EQUAL), ("B", EQUAL)), "across", "label"))
    boxes = [float(y) for y in re.findall(r'<rect class="box" x="[\d.]+" y="([\d.]+)"', svg)]
    circles = [float(y) for y in re.findall(r'cy="([\d.]+)" r="3.6"', svg)]
    assert boxes[0] + 18 < circles[0] - 3.6
    assert circles[0] + 3.6 < boxes[1]
