"""The arms of rotations: distances of two points by the statement's symbol, or by their letters
where they have to be worked out first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.expressions.tree import Call, Expression, Name, Operation, find_names, walk
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.vector import AxisName
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import AXES, OTHER, ZERO, Symbol
from kinegrade.worked.formulas.equation import Equation, drop_repetition, equate
from kinegrade.worked.formulas.exactness import list_parts
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import join_letters, name_coordinate, read_symbol
from kinegrade.worked.positions.algebra import TWO, is_negated
from kinegrade.worked.positions.instance import METRE, Instance, make_instance
from kinegrade.worked.positions.leaning_lengths import measure_along
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import vanishes


def name_length(start: str, end: str, case: Case) -> Symbol:
    """The distance of two points: as the figure names it, else OA; always the same letters."""
    stated = find_stated_length(start, end, case)
    letters = join_letters(map(case.naming.letter, (start, end)))
    return stated or case.findings.arms.get(frozenset((start, end)), letters)


def find_stated_length(start: str, end: str, case: Case) -> Symbol | None:
    """The symbol of the statement for the distance of two points: their letters, what the figure
    writes between them, or the given at which one is placed from the other.
    """
    for ends in ((start, end), (end, start)):
        letters = join_letters(map(case.naming.letter, ends))
        if letters.row in case.named_rows:
            return letters
    for one in case.template.figure.lengths:
        if one.along is None and not one.signed and {one.start, one.end} == {start, end}:
            return read_symbol(one.symbol)
    radius = _find_radius(start, end, case)
    stated = case.symbols[radius.name] if isinstance(radius, Name) else None
    stated = stated or _find_rolling_radius(start, end, case)
    opposite = _find_opposite_side(start, end, case)
    return stated or (find_stated_length(*opposite, case) if opposite else None)


def find_length_tree(start: str, end: str, case: Case) -> Expression | None:
    """The given distance of two points as an expression: that at which one is placed from the
    other, or a given of their symbol; None where none is given.
    """
    radius = _find_radius(start, end, case)
    if radius is not None:
        return radius.right if is_negated(radius) else radius
    symbol, given = find_stated_length(start, end, case), case.symbols
    named = (*case.template.parameters, *case.template.scheme.lengths)
    found = (name for name in named if symbol is not None and given[name].looks_like(symbol))
    name = next(found, None)
    return None if name is None else Name(name)


def _find_opposite_side(start: str, end: str, case: Case) -> tuple[str, str] | None:
    """The side of a parallelogram across from that between two points, of which one completes it:
    C = B + D - A.
    """
    for step in case.construction:
        match step.tree:
            case Operation("-", Operation("+", Name(first), Name(second)), Name(corner)):
                for beside, across in ((first, second), (second, first)):
                    if {start, end} == {step.point, beside}:
                        return across, corner
            case _:
                continue
    return None


def introduce_lengths(ends: Iterable[tuple[str, str]], case: Case) -> Iterator[Equation]:
    """How distances that no symbol of the statement names follow from it, each told once."""
    for start, end in ends:
        pair = frozenset((start, end))
        if pair in case.findings.arms or find_stated_length(start, end, case):
            continue
        found = _state_length(start, end, case)
        if found is not None:
            yield from _state_level(start, end, found, case)
            yield found
            case.findings.arms[pair] = join_letters(map(case.naming.letter, (start, end)))


def find_arms(parts: Iterable[Part]) -> Iterator[tuple[str, str]]:
    """The ends of the arms that the magnitudes of parts are stated by."""
    for part in parts:
        if part.term is not None and not vanishes(part):
            turns, circles = part.term.kind == "rotation", part.term.kind == "arc"
            if turns or (circles and part.part == "n"):
                yield part.base, part.point


def _state_length(start: str, end: str, case: Case) -> Equation | None:
    """OA = r_1 + r_2 where the point is placed so, else by coordinates; None where these are found
    by neither.
    """
    instance = make_instance(case)
    tree = (
        _find_radius(start, end, case)
        or _find_half(start, end, case)
        or measure_along(start, end, instance)
        or _measure_distance(start, end, instance)
    )
    if tree is None:
        return None
    symbol = join_letters(map(case.naming.letter, (start, end)))
    value = state_quantity(instance.quantity(instance.value(tree), METRE))
    return Equation(symbol, drop_repetition(instance.worked_out(symbol, tree), value))


def _state_level(start: str, end: str, length: Equation, case: Case) -> Iterator[Equation]:
    """y_D - y_B = 0 before a distance by the other coordinates alone, where two points lie on a
    parallel to an axis at this instant, though not as they are placed.
    """
    told = {part for link in length.links for part in list_parts(link.right)}
    names = {axis: _name_coordinates(axis, (start, end), case) for axis in AXES}
    other = next((axis for axis in AXES if not told & {*names[axis]}), None)
    if other is None or not told & {*names[OTHER[other]]}:
        return
    instance = make_instance(case)
    pair = instance.axes.pair(Operation("-", Name(start), Name(end)))
    apart = pair[PLACES[other]] if pair else None
    if not isinstance(apart, Operation) or is_negated(apart):  # one is zero, and told
        return
    if not instance.sign(apart):
        symbols = instance.formula(apart)
        yield Equation(symbols, (*instance.worked_out(symbols, apart), *equate(ZERO)))


def _name_coordinates(axis: AxisName, ends: tuple[str, str], case: Case) -> tuple[Symbol, Symbol]:
    first, second = (name_coordinate(axis, case.naming.letter(point)) for point in ends)
    return first, second


def _measure_distance(start: str, end: str, instance: Instance) -> Expression | None:
    """The distance by the differences of coordinates; None where these are not found."""
    pair = instance.axes.pair(Operation("-", Name(end), Name(start)))
    return None if pair is None else instance.measure(pair)


def _find_radius(start: str, end: str, case: Case) -> Expression | None:
    """The distance at which one point is placed from the other, a sum or product of givens."""
    for step in case.construction:
        for call in walk(step.tree):
            match call:
                case Call(function="polar" | "circle", arguments=(Name(centre), radius, *_)):
                    if {step.point, centre} == {start, end} and _is_given(radius, case):
                        return radius.right if is_negated(radius) else radius
                case _:
                    continue
    return None


def _find_rolling_radius(start: str, end: str, case: Case) -> Symbol | None:
    """The given radius of a body that rolls, between its centre and a point of its rim."""
    points, given = case.motion.points, case.symbols
    for relation in case.motion.frames.relations:
        roll = find_rolling(relation.source)
        circle = None if roll is None else case.template.scheme.joints[roll.joint].circle
        if roll is None or circle is None or roll.circle.centre not in (start, end):
            continue
        _, radius = circle.arguments
        far = (points[end] - points[start]).squared() if {start, end} <= {*points} else 0
        if isinstance(radius, Name) and not double(far - roll.circle.radius**2):
            return given[radius.name]
    return None


def _find_half(start: str, end: str, case: Case) -> Expression | None:
    """Half of a given length between two points, of which one is the first or the second point, and
    the other one their midpoint.
    """
    given = case.symbols
    for step in case.construction:
        match step.tree:
            case Call(function="midpoint", arguments=(Name(first), Name(second))):
                whole = find_stated_length(first, second, case)
                if whole is None or {start, end} not in ({step.point, first}, {step.point, second}):
                    continue
                for name in case.template.parameters:
                    if given[name].looks_like(whole):
                        return Operation("/", Name(name), TWO)
            case _:
                continue
    return None


def _is_given(length: Expression, case: Case) -> bool:
    """Whether a length is a sum or product of givens, or of lengths named by the template."""
    plain = not any(isinstance(part, Call) for part in walk(length))
    given = {*case.template.parameters, *case.template.scheme.lengths}
    return plain and set(find_names(length)) <= given
