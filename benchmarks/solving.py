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
CRANK = [
    {"r": r, "k": "sqrt(3)", "phi": phi, "omega": "7", "alpha": "5"}
    for r, phi in (("1/5", "60"), ("1/4", "30"), ("3/10", "45"), ("2/5", "120"))
]
CRANK_AT_ODD_ANGLES = [
    {**values, "phi": phi}
    for values, phi in zip(CRANK, ("37.42", "61.3", "17.77", "143.9"), strict=True)
]
ROCKER = [
    {"l": "1/2", "theta": theta, "psi": psi, "omega": "-2", "eps": "1", "v_B": "3/5", "a_B": "1"}
    for theta, psi in (("30", "90"), ("60", "90"))
]
Symbols = dict[str, sp.Symbol]
Rates = dict[sp.Symbol, sp.Expr]


def figures() -> Iterator[Figure]:
    """The slider-crank and the slotted rocker, exact; and the same by certified balls."""
    yield Figure(
        "slider-crank: v_B, omega_AB, alpha_AB, a_B",
        seconds(ours("slider-crank", CRANK), 200),
        seconds(slider_crank_by_sympy(CRANK), 7),
        PROMISE,
    )
    yield Figure(
        "slotted rocker, two drivers: omega, alpha, v_rel, a_cor",
        seconds(ours("slotted-rocker-and-slider-two-drivers", ROCKER), 200),
        seconds(slotted_rocker_by_sympy(ROCKER), 7),
        PROMISE,
    )
    yield Figure(
        "slider-crank at 37.42 degrees (40 certified digits)",
        seconds(ours("slider-crank", CRANK_AT_ODD_ANGLES), 200),
        seconds(slider_crank_by_sympy(CRANK_AT_ODD_ANGLES, evaluate=True), 7),
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


def solve(equations: sp.Matrix, unknowns: list[sp.Symbol]) -> Rates:
    """The only solution of equations whose left sides are given, by unknown."""
    found: Rates = sp.solve(list(equations), unknowns, dict=True)[0]
    return found


def read_values(at: Symbols, given: dict[str, str], angles: tuple[str, ...]) -> Rates:
    """What the letters are worth, angles in radians."""
    return {
        at[name]: sp.sympify(text, rational=True) * (sp.pi / 180 if name in angles else 1)
        for name, text in given.items()
    }


def slider_crank_by_sympy(
    instances: list[dict[str, str]], evaluate: bool = False
) -> Callable[[], object]:
    """The script an instructor would write for the slider-crank."""
    turn = cycle(instances)

    def script() -> object:
        given = next(turn)
        at = {name: sp.Symbol(name, positive=True) for name in given}
        velocities, accelerations = solve_slider_crank(at)
        values = read_values(at, given, ("phi",))
        return settled(velocities, values, evaluate) + settled(accelerations, values, evaluate)

    return script


def solve_slider_crank(at: Symbols) -> tuple[Rates, Rates]:
    """Velocities and accelerations of the slider-crank in letters."""
    r, k, phi, omega = (at[name] for name in ("r", "k", "phi", "omega"))
    w, e, v, a = sp.symbols("omega_AB alpha_AB v_B a_B")
    crank = sp.Matrix([r * sp.cos(phi), r * sp.sin(phi)])
    rod = sp.Matrix([r * sp.sqrt(k**2 - sp.sin(phi) ** 2), -r * sp.sin(phi)])
    velocities = solve(cross(-omega, crank) + cross(w, rod) - sp.Matrix([v, 0]), [w, v])
    of_crank = cross(-at["alpha"], crank) - omega**2 * crank
    of_rod = cross(e, rod) - velocities[w] ** 2 * rod
    return velocities, solve(of_crank + of_rod - sp.Matrix([a, 0]), [e, a])


def slotted_rocker_by_sympy(instances: list[dict[str, str]]) -> Callable[[], object]:
    """The script an instructor would write for the slotted rocker; velocities are put into the
    accelerations as numbers, for with symbols `simplify` runs for minutes.
    """
    turn = cycle(instances)

    def script() -> object:
        given = next(turn)
        at = {name: sp.Symbol(name) for name in (*given, "d", "v_rel")}
        velocities, accelerations = solve_slotted_rocker(at)
        values = read_values(at, given, ("theta", "psi"))
        values[at["d"]] = (at["l"] * sp.sin(at["theta"]) / sp.sin(at["psi"])).subs(values)
        rates = {
            symbol: sp.simplify(expression.subs(values))
            for symbol, expression in velocities.items()
        }
        asked = {**accelerations, at["v_rel"]: 2 * at["omega"] * at["v_rel"]}
        return rates, settled(asked, {**values, **rates}, False)

    return script


def solve_slotted_rocker(at: Symbols) -> tuple[Rates, Rates]:
    """Velocities and accelerations of the slotted rocker in letters."""
    length, distance, omega, v = (at[name] for name in ("l", "d", "omega", "v_rel"))
    w, e, a = sp.symbols("omega_AB alpha_AB a_rel")
    slot = sp.Matrix([sp.cos(at["psi"]), sp.sin(at["psi"])])
    link = sp.Matrix([-length * sp.cos(at["theta"]), length * sp.sin(at["theta"])])
    arm = distance * slot
    of_slider = sp.Matrix([at["v_B"], 0])
    velocities = solve(of_slider + cross(w, link) - cross(omega, arm) - v * slot, [w, v])
    of_link = sp.Matrix([at["a_B"], 0]) + cross(e, link) - w**2 * link
    of_rocker = cross(at["eps"], arm) - omega**2 * arm + cross(2 * omega, v * slot)
    return velocities, solve(of_link - of_rocker - a * slot, [e, a])
