"""What is wrong with the letters of lengths in a printed picture: one beside its bar that is nearer
to something else, so that a reader takes it for the length of that, or close to the letter of a
rate.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from shapely import LineString, Point
from shapely.geometry.base import BaseGeometry

from kinegrade.problem.template.hints import Length
from tests.figures.svg_shapes import Letters, Picture

BESIDE = 2.5  # millimetres from its line within which a letter stands beside it
ITS_OWN = 1.0  # millimetres about a line that are its own
OF_LINK = 2.2, 0.8  # millimetres about a line, and share of some ink in it that is its own
ALONG, AT_DIMENSION = 7.0, 1.6  # millimetres from a line to a dimension line, from that to a letter
AT_END = 1.2  # millimetres between a letter and the end of its leader
RATES, FRACTION = "vaωα", 1.5  # first letters of rates, and millimetres from one to a length
CLEARLY = 0.3  # millimetres by which a letter may not be nearer to something else


def find_ownership_flaws(
    picture: Picture, points: Mapping[str, Point], lengths: Sequence[Length]
) -> list[str]:
    """What is wrong with the letters of lengths between marked points, in words."""
    texts = {_write_text(length) for length in lengths}
    rates = [each for each in picture.letters if each.text[0] in RATES and each.text not in texts]
    owned = [
        flaw
        for length in lengths
        if length.along is None and {length.start, length.end} <= {*points}
        for flaw in _find_flaws_of(picture, length, points)
    ]
    return [*owned, *_find_fractions(picture, texts, rates)]


def _find_fractions(
    picture: Picture, texts: Collection[str], rates: Sequence[Letters]
) -> Iterator[str]:
    """The letters of lengths that stand at that of a rate, as a divisor would."""
    for each in picture.letters:
        for rate in rates:
            if each.text in texts and each.box.distance(rate.box) < FRACTION:
                yield f"{each.text} stands at {rate.text}, as in a fraction"


def _write_text(length: Length) -> str:
    return re.sub(r"[^A-Za-z0-9]", "", length.symbol)


def _find_flaws_of(picture: Picture, length: Length, points: Mapping[str, Point]) -> Iterator[str]:
    own = LineString([points[length.start], points[length.end]])
    text = _write_text(length)
    letters = [each for each in picture.letters if each.text == text]
    nearest = min(letters, key=lambda each: each.box.distance(own), default=None)
    if nearest and nearest.box.distance(own) < BESIDE and not _has_leader(nearest, own, picture):
        mine, other = _measure(nearest, own, picture.ink)
        if other < mine - CLEARLY:
            yield f"{text} stands nearer to something else than to its own line"


def _has_leader(letters: Letters, own: LineString, picture: Picture) -> bool:
    """Whether a thin line leads from a letter to its line, or the letter stands at a dimension
    line along that.
    """
    along = own.buffer(ALONG, cap_style="square")
    if any(
        line.within(along)
        and line.length > own.length / 2
        and own.buffer(ITS_OWN).disjoint(line)
        and line.distance(letters.box) < AT_DIMENSION
        for line in picture.lines
    ):
        return True
    return any(
        min(ends, key=letters.box.distance).distance(letters.box) < AT_END
        and min(ends, key=own.distance).distance(own) < ITS_OWN
        for line in picture.lines
        if not line.within(own.buffer(ITS_OWN))
        for ends in [[Point(at) for at in line.coords]]
    )


def _measure(letters: Letters, own: LineString, ink: Sequence[BaseGeometry]) -> tuple[float, float]:
    """The distance of a letter from its line or link, and from anything else."""
    about, link = own.buffer(ITS_OWN), own.buffer(OF_LINK[0])
    mine, other = letters.box.distance(own), 99.0
    for each in ink:
        if each.intersection(link).area > OF_LINK[1] * each.area:
            mine = min(mine, letters.box.distance(each))
        else:
            rest = each.difference(about)
            other = min(other, letters.box.distance(rest)) if not rest.is_empty else other
    return mine, other
