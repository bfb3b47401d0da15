"""Why a vector makes the angle with an axis by which it is projected: what its line makes with that
of the axis, and that one of them is normal to its line.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from kinegrade.language.math.tree import Letter, Row, Sign, Space
from kinegrade.language.message import Listing, Message, Text
from kinegrade.worked.case import Case
from kinegrade.worked.deductions.oblique_lines import (
    ObliqueLine,
    direct_lines,
    draw_line,
    find_line,
    measure_corner,
    name_corner,
)
from kinegrade.worked.findings import Pair
from kinegrade.worked.formulas.atoms import Symbol, VectorSymbol
from kinegrade.worked.formulas.formula import Formula, Sum
from kinegrade.worked.formulas.measures import bearing
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.positions.marked_angles import find_marked_parallel
from kinegrade.worked.vectors.angle_sums import explain_sums, tell_sum
from kinegrade.worked.vectors.components import find_heading as find_piece_heading
from kinegrade.worked.vectors.projection import Projection
from kinegrade.worked.vectors.slopes.cosines import Cosine, find_cosine
from kinegrade.worked.vectors.slopes.directions import find_term_ends
from kinegrade.worked.vectors.stage import Stage, find_axis, find_share_cosine
from kinegrade.worked.vectors.table.tracks import find_heading
from kinegrade.worked.vectors.vectors import name_part

_RIGHT, _HALF = 90.0, 180.0
_CLOSE = 1e-6  # degrees
_X, _Y = Symbol((Letter("x"),)), Symbol((Letter("y"),))
AXIS_NAMES = {0.0: Message("solution.projection-x"), 90.0: Message("solution.projection-y")}


@dataclass(frozen=True)
class _Leaning:
    """A vector aslant to the axis of a projection: its symbol and direction, the cosine with which
    it counts, and the lines of both; None for the line of one that lies along x or y.
    """

    case: Case
    vector: VectorSymbol
    heading: float
    axis: float
    cosine: Cosine
    line: ObliqueLine | None
    base: ObliqueLine | None

    @property
    def lines(self) -> tuple[ObliqueLine, ...]:
        """The lines whose angles make up that of the projection."""
        return tuple(line for line in (self.line, self.base) if line is not None)

    @property
    def key(self) -> Pair:
        """What tells the pair of lines from others; the axes count as one line."""
        return frozenset(frozenset(line.ends or line.letters.print()) for line in self.lines)

    @property
    def turns(self) -> tuple[bool, bool]:
        """Whether the vector, and whether the axis, is normal to its line."""
        vector = self.line is not None and self.line.is_across(self.heading)
        return vector, self.base is not None and self.base.is_across(self.axis)

    def find_reason(self) -> Message:
        """What the lines make with one another, or the only one with an axis."""
        case = self.case
        first, *others = self.lines
        if not others:
            axis = AXIS_NAMES[first.named.quarters % 2 * _RIGHT]
            line, angle = case.text(_add_stated(first, case)), self._tell_acute(complement=False)
            return Message("solution.line-makes", line=line, angle=angle, axis=axis)
        turned = self.turns[0] != self.turns[1]
        complement = turned == (self.cosine.function == "cos")
        size = abs(self._measure_angle(complement=complement))
        less = _HALF if size > _HALF else 0.0  # no two directions make more: one line from its end
        corner = measure_corner(first, others[0], case)
        if corner is not None and abs(corner - (size - less)) > _CLOSE:
            letters = case.text(name_corner(first, others[0], case))
            angle = self._tell_supplement(complement=complement, less=less)
            return Message("solution.corner-angle", corner=letters, angle=angle)
        lines = direct_lines(first, others[0], size - less, case)
        names = zip(("first", "second"), (case.text(line) for line in lines), strict=True)
        angle = self._tell_angle(complement=complement, less=less)
        return Message("solution.between-lines", **dict(names), angle=angle)

    def state(self, others: Sequence[VectorSymbol]) -> Message:
        """The angle with the axis of the vector, and of others along it."""
        angle = self._tell_acute(complement=self.cosine.function == "sin")
        vectors = self._name_vectors((self.vector, *others))
        return Message(
            "solution.vectors-make",
            vectors=self.case.text(vectors),
            angle=angle,
            axis=self._name_axis(),
            count=1 + len(others),
        )

    def _tell_angle(self, *, complement: bool, less: float = 0.0) -> str:
        """The angle of the cosine, worked out where it is a sum that has not been, or what it
        differs from a right angle by; either `less` so many degrees.
        """
        case, angle = self.case, self.cosine.angle
        if not complement and not less:
            return tell_sum(self.cosine, case) or f"${case.text(angle)}$"
        if complement and self._measure_angle(complement=True) >= 0:
            return f"${case.text(state_angle(_RIGHT) - angle)}$"
        return f"${case.text(angle - state_angle(less + _RIGHT * complement))}$"

    def _tell_supplement(self, *, complement: bool, less: float) -> str:
        """What that angle falls short of two right angles by: the angle of a triangle at the corner
        of two of its sides, where the lines make the exterior one.
        """
        case, angle = self.case, self.cosine.angle
        if complement and self._measure_angle(complement=True) >= 0:
            return f"${case.text(angle + state_angle(_RIGHT))}$"
        return f"${case.text(state_angle(_HALF + less + _RIGHT * complement) - angle)}$"

    def _tell_acute(self, *, complement: bool) -> str:
        """The same, where the angle is obtuse by what it differs from one or two half turns: two
        lines make no more than a right angle.
        """
        less = _RIGHT * complement
        turns = round((self.cosine.value - less) / _HALF)
        if not turns:
            return self._tell_angle(complement=complement)
        left, angle = state_angle(turns * _HALF + less), self.cosine.angle
        acute = left - angle if self.cosine.value < turns * _HALF + less else angle - left
        return f"${self.case.text(acute)}$"

    def _measure_angle(self, *, complement: bool) -> float:
        """The angle of the cosine in degrees, or what it falls short of a right angle by."""
        return _RIGHT - self.cosine.value if complement else self.cosine.value

    def _name_vectors(self, vectors: Sequence[VectorSymbol]) -> Symbol:
        """Vectors with the line along or normal to which they are."""
        row = join_plainly(vectors)
        if self.line is None:
            other = _Y if round(self.heading / _RIGHT) % 2 else _X
            return Symbol((*row, Sign(r"\parallel"), *other.print()))
        if self.line.ends is None:
            return Symbol(row)
        sign = Sign(r"\perp" if self.line.is_across(self.heading) else r"\parallel")
        return Symbol((*row, sign, *self.line.letters.print()))

    def _name_axis(self) -> Text:
        if self.base is None:
            return AXIS_NAMES[self.axis % _HALF]
        letters = self.case.text(self.base.letters)
        normal = self.base.is_across(self.axis)
        return Message("solution.across-line", line=letters) if normal else f"${letters}$"


def join_plainly(symbols: Sequence[VectorSymbol]) -> Row:
    """Symbols one after another: v_a, v_A."""
    first, *others = (one.print() for one in symbols)
    return (*first, *(node for row in others for node in (Sign(","), Space(" "), *row)))


def _add_stated(line: ObliqueLine, case: Case) -> Formula:
    """The letters of a line, with those of the line, normal to it or parallel, whose angle with an
    axis the figure marks in its place.
    """
    marked = find_marked_parallel(line.ends, line.named.angle, case) if line.ends else None
    if marked is None:
        return line.letters
    other = join_letters(map(case.naming.letter, marked.ends))
    sign = Sign(r"\perp" if marked.across else r"\parallel")
    return Symbol((*line.letters.print(), sign, *other.print()))


def explain_angles(stage: Stage, projection: Projection) -> Iterator[Message]:
    """The angles of the vectors of a projection with its axis, as far as no projection before has
    told what their lines make with one another, and the sums that are left to be worked out.
    """
    case, new = stage.case, dict[Pair, list[_Leaning]]()
    leaning = tuple(_list_leaning(stage, projection))
    for one in leaning:
        if one.key not in case.findings.leaning:
            new.setdefault(one.key, []).append(one)
    told = {key: found for key, found in new.items() if not _is_seen(found)}
    case.findings.leaning.update(told)
    if told:
        angles = Listing(tuple(map(_join, told.values())), "semicolon")
        yield Message("solution.angles", angles=angles)
    yield from explain_sums((one.cosine for one in leaning), case)


def _is_seen(found: list[_Leaning]) -> bool:
    """Whether only one named angle is needed, of a vector along a line with an axis; a sum of some
    is nowhere drawn.
    """
    summed = isinstance(found[0].cosine.angle, Sum)
    return len(found[0].lines) == 1 and not summed and not any(any(one.turns) for one in found)


def _join(found: Sequence[_Leaning]) -> Message:
    """What two lines make with one another, and what follows for the vectors, for those along one
    another together.
    """
    reason, alike = found[0].find_reason(), dict[tuple[float, bool], list[_Leaning]]()
    for one in found:
        if any(one.turns):
            alike.setdefault((one.heading % _HALF, one.line is None), []).append(one)
    following = tuple(
        first.state([one.vector for one in others]) for first, *others in alike.values()
    )
    if not following:
        return reason
    told, *further = following
    for clause in further:
        told = Message("solution.vectors-make-both", first=told, next=clause)
    return Message("solution.so", reason=reason, following=told)


def _list_leaning(stage: Stage, projection: Projection) -> Iterator[_Leaning]:
    """The vectors of a projection that are aslant to its axis by named angles."""
    case, axis, reference = stage.case, find_axis(projection, stage.case), projection.reference
    base = find_line(reference, projection, case) if reference else None
    if axis is None:
        return
    for share in projection.shares:
        pieces = stage.find_pieces(projection, share)
        for piece in pieces:
            heading, direction = find_piece_heading(piece, case), bearing(piece.positive)
            ends = find_term_ends(piece.term, case) if piece.term else None
            vector = replace(piece.symbol, bold=True)
            line = draw_line(ends, direction, case) if ends else None
            cosine = find_cosine(heading, axis) if heading else None
            if cosine is not None:
                yield _Leaning(case, vector, direction, projection.axis, cosine, line, base)
        cosine = find_share_cosine(projection, share, case) if share.angle and not pieces else None
        if cosine is not None:
            vector = name_part(projection.equation, share.part, case, bold=True)
            direction = bearing(find_heading(share.part))
            line = find_line(share.part, projection, case)
            yield _Leaning(case, vector, direction, projection.axis, cosine, line, base)
