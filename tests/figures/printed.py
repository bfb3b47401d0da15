"""The figure that a template prints at a seed, as it is measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from shapely import Point

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import FigureHints
from tests.figures.angle_flaws import find_angle_flaws
from tests.figures.flaws import find_flaws, find_part_flaws
from tests.figures.frame_flaws import find_frame_flaws
from tests.figures.lettered_points import find_letter_flaws
from tests.figures.on_paper import find_points_on_paper
from tests.figures.ownership_flaws import find_ownership_flaws
from tests.figures.radius_flaws import find_radius_flaws
from tests.figures.support_flaws import find_support_flaws
from tests.figures.svg_shapes import Picture, read_picture
from tests.figures.turning_flaws import find_turning_flaws


@dataclass(frozen=True)
class Printed:
    """A picture with its marked points, the mechanism (in metres) that it shows at a scale
    (millimetres for a metre), and what is marked.
    """

    picture: Picture
    points: Mapping[str, Point]
    mechanism: Mechanism
    hints: FigureHints
    scale: float

    def find_all_flaws(self) -> list[str]:
        """Every flaw that is looked for, in words."""
        measured = find_part_flaws(self.picture, self.mechanism, self.hints, self.scale)
        lettered = find_letter_flaws(self.picture, self.points)
        angles = find_angle_flaws(self.picture, self.points, self.hints.angles)
        drawn = find_flaws(self.picture) + find_support_flaws(self.picture)
        drawn += find_radius_flaws(self.picture) + find_turning_flaws(self.picture)
        frames = find_frame_flaws(self.picture, self.points, self.hints.frames)
        owned = find_ownership_flaws(self.picture, self.points, self.hints.lengths)
        return [*drawn, *measured, *lettered, *angles, *frames, *owned]


def read_printed(solution: Solution) -> Printed:
    """The figure of an instance, drawn and read."""
    mechanism = solution.motion.frames.mechanism.map(float)
    return read_sketch(mechanism, mark_question(solution.template, solution.template.asked()))


def read_sketch(mechanism: Mechanism, hints: FigureHints) -> Printed:
    """The figure of a mechanism (in metres), drawn and read."""
    scene = sketch(mechanism, hints)
    picture = read_picture(to_svg(scene))
    points = find_points_on_paper(picture, mechanism, scene.scale)
    return Printed(picture, points, mechanism, hints, scene.scale)
