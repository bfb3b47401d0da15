"""Instances solved exactly, against the usual sympy script: solve symbolically, substitute,
simplify.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import cycle

import sympy as sp

from benchmarks.figure_of_merit import Figure, seconds
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template

PROMISE = 100


def figures() -> Iterator[Figure]:
    """The slider-crank and the slotted rocker, exact; and the same by certified balls."""
    crank = [
        {"r": r, "k": "sqrt(3)", "phi": phi, "omega": "7", "alpha": "5"}
        for r, phi in (("1/5", "60"), ("1/4", "30"), ("3/10", "45"), ("2/5", "120"))
    ]
    rocker = [
        {
            "l": "1/2",
            "theta": theta,
            "psi": psi,
            "omega": "-2",
            "eps": "1",
            "v_B": "3/5",
            "a_B": "1",
        }
        for theta, psi in (("30", "90"), ("60", "90"))
    ]
    yield Figure(
        "slider-crank: v_B, omega_AB, alpha_AB, a_B",
        seconds(ours("slider-crank", crank), 200),
        seconds(slider_crank_by_sympy(crank), 7),
        PROMISE,
    )
    yield Figure(
        "slotted rocker, two drivers: omega, alpha, v_rel, a_cor",
        seconds(ours("slotted-rocker-and-slider-two-drivers", rocker), 200),
        seconds(slotted_rocker_by_sympy(rocker), 7),
        PROMISE,
    )
    odd = [
        {**values, "phi": phi}
        for values, phi in zip(crank, ("37.42", "61.3", "17.77", "143.9"), strict=True)
    ]
    yield Figure(
        "slider-crank at 37.42 degrees (40 certified digits)",
        seconds(ours("slider-crank", odd), 200),
        seconds(slider_crank_by_sympy(odd, evaluate=True), 7),
        None,
    )


def ours(name: str, instances: list[dict[str, str]]) -> Callable[[], object]:
    """Solve the next instance, as an exam does: the template's own asks, the plan found before."""
    template = load_template(name)
    plan = solve_template(template, instances[0]).motion.plan
    turn = cycle(instances)
    return lambda: solve_template(template, next(turn), template.asked(), plan)


def cross(omega: sp.Expr, arm: sp.Matrix) -> sp.Matrix:
    """omega k x arm."""
    return omega * sp.Matrix([-arm[1], arm[0]])


def settled(
    solution: dict[sp.Symbol, sp.Expr], values: dict[sp.Symbol, sp.Expr], evaluate: bool
) -> list[sp.Expr]:
    """Numbers put in and simplified, or evaluated to 40 digits."""
    numbers = [expression.subs(values) for expression in solution.values()]
    return [number.evalf(40) if evaluate else sp.simplify(number) for number in numbers]


def slider_crank_by_sympy(
    instances: list[dict[str, str]], evaluate: bool = False
) -> Callable[[], object]:
    """The script an instructor would write for the slider-crank."""
    turn = cycle(instances)

    def script() -> object:
        given = next(turn)
        r, k, phi, omega, alpha = sp.symbols("r k phi omega alpha", positive=True)
        w, e, v, a = sp.symbols("omega_AB alpha_AB v_B a_B")
        crank = sp.Matrix([r * sp.cos(phi), r * sp.sin(phi)])
        rod = sp.Matrix([r * sp.sqrt(k**2 - sp.sin(phi) ** 2), -r * sp.sin(phi)])
        velocities = sp.solve(
            list(cross(-omega, crank) + cross(w, rod) - sp.Matrix([v, 0])), [w, v], dict=True
        )[0]
        accelerations = sp.solve(
            list(
                cross(-alpha, crank)
                - omega**2 * crank
                + cross(e, rod)
                - velocities[w] ** 2 * rod
                - sp.Matrix([a, 0])
            ),
            [e, a],
            dict=True,
        )[0]
        values = {
            r: sp.Rational(given["r"]),
            k: sp.sqrt(3),
            phi: sp.Rational(given["phi"]) * sp.pi / 180,
            omega: sp.Integer(given["omega"]),
            alpha: sp.Integer(given["alpha"]),
        }
        return settled(velocities, values, evaluate) + settled(accelerations, values, evaluate)

    return script


def slotted_rocker_by_sympy(instances: list[dict[str, str]]) -> Callable[[], object]:
    """The script an instructor would write for the slotted rocker; velocities are put into the
    accelerations as numbers, for with symbols `simplify` runs for minutes.
    """
    turn = cycle(instances)

    def script() -> object:
        given = next(turn)
        length, distance, theta, psi, omega, eps, v_b, a_b = sp.symbols(
            "l d theta psi omega eps v_B a_B"
        )
        w, e, v, a = sp.symbols("omega_AB alpha_AB v_rel a_rel")
        slot = sp.Matrix([sp.cos(psi), sp.sin(psi)])
        link = sp.Matrix([-length * sp.cos(theta), length * sp.sin(theta)])
        coriolis = cross(2 * omega, v * slot)
        velocities = sp.solve(
            list(sp.Matrix([v_b, 0]) + cross(w, link) - cross(omega, distance * slot) - v * slot),
            [w, v],
            dict=True,
        )[0]
        accelerations = sp.solve(
            list(
                sp.Matrix([a_b, 0])
                + cross(e, link)
                - w**2 * link
                - cross(eps, distance * slot)
                + omega**2 * distance * slot
                - coriolis
                - a * slot
            ),
            [e, a],
            dict=True,
        )[0]
        values = {
            length: sp.Rational(given["l"]),
            theta: sp.Rational(given["theta"]) * sp.pi / 180,
            psi: sp.Rational(given["psi"]) * sp.pi / 180,
            omega: sp.Integer(given["omega"]),
            eps: sp.Integer(given["eps"]),
            v_b: sp.Rational(given["v_B"]),
            a_b: sp.Integer(given["a_B"]),
        }
        values[distance] = (length * sp.sin(theta) / sp.sin(psi)).subs(values)
        rates = {
            symbol: sp.simplify(expression.subs(values))
            for symbol, expression in velocities.items()
        }
        return rates, settled({**accelerations, v: 2 * omega * v}, {**values, **rates}, False)

    return script
