r"""Symbols of points, coordinates and quantities as formulas.

The letters come from templates and their notation as LaTeX math, which is read here once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

from msgspec.structs import replace

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Accent, Letter, Lettering, Row, Scripts, Sign
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName
from kinegrade.problem.template.notation import write_point_symbol, write_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.formulas.atoms import Symbol

PI = Symbol((Letter("pi"),))
INFINITY = Symbol((Sign(r"\infty"),))
_WHERE = Message("typesetting.place-worked-solution")


@lru_cache(maxsize=4096)
def read_symbol(latex: str) -> Symbol:
    """The symbol that a template gives in LaTeX math. Raises TypesetError for what is no math."""
    return Symbol(read_math(latex, _WHERE))


@lru_cache(maxsize=4096)
def name_quantity(name: str) -> Symbol:
    """The symbol of a quantity by its name in templates, "l_1"."""
    return PI if name == "pi" else read_symbol(write_symbol(name))


@lru_cache(maxsize=4096)
def name_point(name: str) -> Symbol:
    """The letter of a point by its name in templates, "O1"."""
    return read_symbol(write_point_symbol(name))


def collect_symbols(template: Template) -> Mapping[str, Symbol]:
    """The symbols of everything that a template's expressions may name."""
    return {
        **{name: name_point(name) for name in template.scheme.points},
        **{name: name_quantity(name) for name in template.scheme.lengths},
        **{name: name_quantity(name) for name in template.scheme.steps},
        **{name: read_symbol(one.symbol) for name, one in template.parameters.items()},
        "pi": PI,
    }


def name_coordinate(axis: AxisName, point: Symbol) -> Symbol:
    """x_A or y_A."""
    return Symbol((Scripts(Letter(axis), point.row, 0, None),))


def index_letter(letter: str, lower: Row) -> Symbol:
    """A letter with an index."""
    return Symbol((Scripts(Letter(letter), lower, 0, None),))


def begins_with_letter(symbol: Symbol, letter: str) -> bool:
    """Whether a symbol is a letter with or without an index, or begins so."""
    first = symbol.row[0]
    return (first.base if isinstance(first, Scripts) else first) == Letter(letter)


def replace_letter(symbol: Symbol, letter: str) -> Symbol:
    """A symbol with another letter at its beginning: alpha_1 for omega_1."""
    first, *others = symbol.row
    if isinstance(first, Scripts):
        return Symbol((replace(first, base=Letter(letter)), *others))
    return Symbol((Letter(letter), *others))


def name_component(letter: str, axis: AxisName) -> Symbol:
    """u_x or u_y."""
    return Symbol((Scripts(Letter(letter), (Letter(axis),), 0, None),))


def name_vector(letter: str) -> Symbol:
    """A vector by its letter, in bold."""
    return Symbol((Lettering("boldsymbol", (Letter(letter),)),))


def join_letters(points: Iterable[Symbol]) -> Symbol:
    """The distance AB of two points, or the direction from one to the other."""
    row = tuple(node for point in points for node in point.row)
    last = row[-1]
    return Symbol(row, isinstance(last, Scripts) and last.lower is not None)


def draw_arrow(points: Iterable[Symbol]) -> Symbol:
    """The vector from one point to another."""
    return Symbol((Accent("overrightarrow", join_letters(points).row),))


def name_angle(*parts: Symbol) -> Symbol:
    """The angle between two directions."""
    first, second = (part.row for part in parts)
    inside: Row = (*first, Sign(","), *second)
    return Symbol((Sign(r"\angle"), Sign("("), *inside, Sign(")")))


def name_corner(points: Iterable[Symbol]) -> Symbol:
    """The angle at the second of three points, from the first to the third."""
    return Symbol((Sign(r"\angle"), *join_letters(points).row))


def prime(point: Symbol) -> Symbol:
    """The letter of the point that coincides with a point: B', and O'_1 for O_1."""
    first, *others = point.row
    if isinstance(first, Scripts):
        return Symbol((replace(first, primes=first.primes + 1), *others))
    return Symbol((Scripts(first, None, 1, None), *others))
