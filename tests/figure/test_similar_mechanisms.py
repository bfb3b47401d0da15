"""Mechanisms that look alike are one subject, and those that do not are two."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.similar_mechanisms import Subject, normalise_subject
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from tests.figure.mechanisms import slider_crank


def driven(mechanism: Mechanism, factor: float) -> Mechanism:
    """The mechanism with velocities larger by a factor."""
    return replace(
        mechanism,
        drivers=tuple(
            replace(driver, velocity=factor * driver.velocity) for driver in mechanism.drivers
        ),
    )


def shown(mechanism: Mechanism, hints: FigureHints) -> Subject:
    return normalise_subject(mechanism, hints)[0]


def told(hints: FigureHints) -> FigureHints:
    """The hints with the sense of every arrow."""
    return replace(hints, arrows=tuple(replace(arrow, sense="cw") for arrow in hints.arrows))


MECHANISM, HINTS = slider_crank(0.2, 1.75, 60)


def test_size_and_speed_do_not_show_and_shape_does() -> None:
    assert shown(MECHANISM, HINTS) == shown(driven(scale_to_paper(MECHANISM, 3.0), 2.0), HINTS)
    assert shown(MECHANISM, HINTS) != shown(slider_crank(0.2, 1.75, 61)[0], HINTS)


def test_the_sense_of_a_motion_shows_where_an_arrow_follows_it() -> None:
    assert HINTS.arrows
    assert shown(MECHANISM, HINTS) != shown(driven(MECHANISM, -1.0), HINTS)
    assert shown(MECHANISM, told(HINTS)) == shown(driven(MECHANISM, -1.0), told(HINTS))
