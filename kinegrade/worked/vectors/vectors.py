"""The symbols of an equation's vectors: v_a, v_e, v_r and a_Cor in a composition of motions, v_BA,
a_BA^n and a_BA^t about a base point.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, assert_never

from kinegrade.language.math.tree import Letter, Lettering, Number, Row, Sign
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import name_place
from kinegrade.worked.formulas.atoms import Symbol, VectorSymbol
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import NEGLIGIBLE
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.unlettered import find_translating_body
from kinegrade.worked.vectors.known_vectors import find_path_term, is_stated_negative
from kinegrade.worked.vectors.relatives import find_relative, index_relative

LETTERS: Mapping[Level, Literal["v", "a"]] = {"velocity": "v", "acceleration": "a"}
UNITS: Mapping[tuple[Level, bool], str] = {  # by whether it is a rotation
    ("velocity", False): "m/s",
    ("acceleration", False): "m/s^2",
    ("velocity", True): "rad/s",
    ("acceleration", True): "rad/s^2",
}


def name_part(
    equation: VectorEquation, part: Part, case: Case, *, bold: bool = False
) -> VectorSymbol:
    """The letter of a part with its subscript; in bold the vector."""
    lower = _find_subscript(equation, part, case)
    return VectorSymbol(LETTERS[equation.level], lower, part.part, "", bold)


def name_by_role(role: str, level: Level, number: Row, *, bold: bool = False) -> VectorSymbol:
    """The vector of a composition by its role: "a", "e", "r" or "Cor", and its number."""
    lower = (Lettering("mathrm", tuple(map(Letter, role))), *number)
    return VectorSymbol(LETTERS[level], lower, bold=bold)


def name_coriolis(number: Row, *, bold: bool = False) -> VectorSymbol:
    """The Coriolis acceleration: never a_C, which is the acceleration of a point C."""
    return name_by_role("Cor", "acceleration", number, bold=bold)


def name_point_vector(point: str, level: Level, case: Case) -> VectorSymbol:
    """The velocity or acceleration of a point; of one without a letter on the paper that of its
    body, with no index where the letter alone is the given one.
    """
    body = find_translating_body(point, case)
    if body is None:
        return VectorSymbol(LETTERS[level], case.naming.letter(point).row)
    alone = VectorSymbol(LETTERS[level], ())
    symbols = case.symbols
    given = any(symbols[name].row == alone.print() for name in case.template.parameters)
    return alone if given else VectorSymbol(LETTERS[level], case.naming.letters(body))


def _find_subscript(equation: VectorEquation, part: Part, case: Case) -> Row:
    """The subscript of a part: a, e, r, Cor in a composition (numbered where there are two), else
    the points.
    """
    match part.role:
        case "transport":
            number = number_composition(equation, part, case)
            return name_by_role("e", equation.level, number).lower
        case "relative":
            number = number_composition(equation, part, case)
            return name_by_role("r", equation.level, number).lower
        case "coriolis":
            return name_coriolis(number_composition(equation, part, case)).lower
        case "absolute" if is_composed(equation, part):
            return name_by_role("a", equation.level, ()).lower
        case "absolute":
            return (*name_place(part, case).row, *_find_axis(part))
        case "rotation":
            return (*name_place(part, case).row, *case.naming.letter(part.base).row)
        case _:
            assert_never(part.role)


def _find_axis(part: Part) -> Row:
    """x or y for a component of a free point's motion."""
    kind = part.term.rate.kind if part.term else None
    match kind:
        case "free-x":
            return (Sign(","), Letter("x"))
        case "free-y":
            return (Sign(","), Letter("y"))
        case "turning" | "sliding" | "circling" | "added-x" | "added-y" | None:
            return ()
        case _:
            assert_never(kind)


def is_composed(equation: VectorEquation, part: Part) -> bool:
    """Whether a part is the absolute motion of the only composition: alone on its side, the other
    one opposite.
    """
    side, other = (
        (equation.left, equation.right)
        if part in equation.left
        else (equation.right, equation.left)
    )
    whole = {(one.role, one.point) for one in side} == {("absolute", part.point)}
    return whole and equation.among == 1 and any(one in other for one in equation.compositions)


def number_composition(equation: VectorEquation, part: Part, case: Case) -> Row:
    """The number of a part's composition where there are several, else what tells it from other
    relative motions of the problem.
    """
    motion = next(
        find_relative(one.term)
        for one in equation.compositions
        if one.composition == part.composition and one.term is not None
    )
    if equation.among > 1:
        number = (Number(str(equation.first + part.composition + 1)),)
        return case.findings.relatives.setdefault(motion, number)
    return index_relative(motion, case)


_STATED = ("absolute", "relative")  # the roles of what an earlier step may have found


def name_value(equation: VectorEquation, part: Part, case: Case) -> Formula:
    """What stands for a part in equations: the algebraic value of an unknown one, the magnitude of
    a known one, between bars where its letter has a negative value.
    """
    letters = name_part(equation, part, case)
    if part.unknown is not None:
        return letters
    stated = part.role in _STATED and part.part != "n" and not is_composed(equation, part)
    term = part.term or find_path_term(part.together, case)
    negative = stated and term is not None and is_stated_negative(term, case, equation.level)
    return abs(letters) if negative or case.findings.is_negative(letters) else letters


def vanishes(part: Part) -> bool:
    """Whether a known part is zero at this instant."""
    return part.unknown is None and abs(float(part.value.x)) + abs(float(part.value.y)) < NEGLIGIBLE


def name_arm(part: Part, case: Case) -> Symbol:
    """The radius at which a part turns, "AB"; the fixed or base point comes first."""
    return join_letters(map(case.naming.letter, (part.base, part.point)))
