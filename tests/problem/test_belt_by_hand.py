"""The crossed belt on a turning arm, worked out by hand as positions at the time t and
differentiated.
"""

from __future__ import annotations

import pytest
from mpmath import diff, exp, mp, mpf, radians

import kinegrade

GIVEN = (
    {"r1": "0.2", "r2": "0.16", "l": "0.7", "phi": 30, "omega1": 8, "omega0": 2, "alpha0": 4},
    {"r1": "0.1", "r2": "0.24", "l": "0.5", "phi": 225, "omega1": 3, "omega0": "5.5", "alpha0": 8},
    {"r1": "0.3", "r2": "0.08", "l": "0.9", "phi": 90, "omega1": 12, "omega0": 1, "alpha0": 2},
)


@pytest.mark.parametrize("given", GIVEN, ids=lambda given: f"phi {given['phi']}")
def test_the_crossed_belt_by_positions(given: dict[str, str | int]) -> None:
    answers = kinegrade.template("crossed-belt-drive").solve(**given)
    with mp.workdps(40):
        r1, r2, length, phi, omega1, omega0, alpha0 = map(mpf, given.values())

        def arm(t: mpf) -> mpf:
            """How far the arm has turned."""
            return omega0 * t + alpha0 * t**2 / 2

        def wheel(t: mpf) -> mpf:
            """How far II has turned: with the arm, and backwards by the belt that I winds on."""
            return arm(t) - r1 * (omega1 * t - arm(t)) / r2

        def place(t: mpf) -> mpf:
            """B in the complex plane, whose real axis lies along the x axis."""
            along = exp(1j * radians(phi))
            return along * (length * exp(1j * arm(t)) + r2 * 1j * exp(1j * wheel(t)))

        expected = {
            "omega_II": diff(wheel, 0),
            "alpha_II": diff(wheel, 0, 2),
            "omega_r": diff(wheel, 0) - omega0,
            "v_B": abs(diff(place, 0)),
            "a_B": abs(diff(place, 0, 2)),
        }
        assert set(expected) == set(answers)
        for ask, value in expected.items():
            assert answers[ask].value == pytest.approx(float(value), rel=1e-12), ask
