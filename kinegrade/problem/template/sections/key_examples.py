"""Keys of a template's tables at work: an entry, or a line of one, in which each key stands."""

from __future__ import annotations

from collections.abc import Mapping

KEY_EXAMPLES: Mapping[str, Mapping[str, str]] = {
    "parameter": {
        "unit": 'r = { unit = "mm", draw = [80, 100, 120] }',
        "draw": 'phi = { unit = "deg", draw = "15 .. 75 step 15" }',
        "published": 'r = { unit = "cm", draw = "8 .. 20 step 2", published = "12" }',
        "means": 'r = { unit = "m", draw = [1, 2], means = "..." }',
        "symbol": r"f = { unit = 'deg', draw = [30, 60], symbol = '\varphi' }",
    },
    "input": {
        "motion": 'motion = "OA turns"',
        "velocity": 'velocity = "omega"',
        "acceleration": 'acceleration = "-alpha"',
    },
    "ask": {
        "quantity": 'omega_AB = { quantity = "omega(AB)", unit = "rad/s", sign = "ccw" }',
        "unit": 'n_AB = { quantity = "omega(AB)", unit = "r/min", sign = "ccw" }',
        "means": 'v_D = { quantity = "x(velocity(D))", unit = "m/s", means = "..." }',
        "sign": 'v_B = { quantity = "magnitude(velocity(B))", unit = "m/s", sign = "magnitude" }',
        "points": 'v_B = { quantity = "x(velocity(B))", unit = "m/s", sign = "+x", points = 2 }',
        "vanishes": 'a_B = { quantity = "x(acceleration(B))", unit = "m/s^2", vanishes = true }',
        "cyclic": 'psi = { quantity = "direction(O, B)", unit = "deg", cyclic = true }',
        "symbol": r"u = { quantity = 'x(velocity(B))', unit = 'm/s', symbol = 'v_B^x' }",
    },
    "published": {
        "source": 'source = "5.12"',
        "given": 'given = { r = "12", phi = "50" }',
        "gives": 'gives = { omega_AB = "4.08" }',
    },
    "branch": {
        "right": "meet(circle(A, l), line(O, 0), right)",
        "left": "meet(circle(A, l), line(O, 0), left)",
        "upper": "meet(circle(A, l), circle(D, m), upper)",
        "lower": "meet(circle(A, l), circle(D, m), lower)",
        "counterclockwise": "meet(circle(A, l), circle(D, m), counterclockwise)",
        "clockwise": "meet(circle(A, l), circle(D, m), clockwise)",
    },
}
