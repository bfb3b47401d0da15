"""What a mechanism consists of on paper, before anything is drawn."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from kinegrade.figure.joints.symbol import Rim, Symbol, find_pins
from kinegrade.figure.joints.table import find_symbols
from kinegrade.figure.mechanism.bars import find_straight_parts
from kinegrade.figure.mechanism.plates import Plate, find_outward_direction
from kinegrade.figure.mechanism.rims import find_rims, order_rims
from kinegrade.figure.mechanism.straight.broad_links import broaden_links
from kinegrade.figure.mechanism.straight.edge_axes import rule_plates
from kinegrade.figure.mechanism.straight.gussets import Corner, find_corners
from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod, find_guided_rack
from kinegrade.figure.mechanism.wheels.arms import Neck, find_necks, find_wheels
from kinegrade.figure.plane import unit
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints


class Anatomy(Struct, frozen=True):
    """A mechanism (millimetres) with what its joints add, its circles and its straight parts.

    `knife_edges` are the fixed points on which the edge of a plate rests, each with the unit vector
    that leaves the plate.
    """

    mechanism: Mechanism
    hints: FigureHints
    symbols: tuple[Symbol, ...]
    rims: tuple[Rim, ...]
    parts: tuple[Part, ...]
    knife_edges: Mapping[str, Vector]
    corners: tuple[Corner, ...]
    necks: tuple[Neck, ...]

    @staticmethod
    def of(mechanism: Mechanism, hints: FigureHints) -> Anatomy:
        """The anatomy of a mechanism with the author's hints."""
        symbols = find_symbols(mechanism, hints.shapes)
        rims = order_rims(find_rims(mechanism, symbols, hints.circles))
        parts = find_straight_parts(mechanism, hints.shapes, symbols, rims)
        parts = broaden_links(parts, mechanism.points, hints.frames)
        parts = rule_plates(parts, mechanism.points, hints.frames)
        pins = find_pins(mechanism, symbols)
        wheels = tuple(find_wheels(mechanism, hints.shapes, symbols, rims))
        necks = tuple(find_necks(wheels, parts))
        edges, corners = _find_knife_edges(symbols, parts), find_corners(parts, symbols, pins)
        return Anatomy(mechanism, hints, symbols, rims, parts, edges, corners, necks)

    @property
    def sleeves(self) -> tuple[Line, ...]:
        """The axes of the sleeves; a knife edge takes the place of one."""
        return tuple(
            symbol.sleeve
            for symbol in self.symbols
            if symbol.sleeve and symbol.point not in self.knife_edges
        )

    @property
    def heads(self) -> Mapping[str, Rod]:
        """The rods that run on a rim with their points, by those points."""
        rods = {part.body: part for part in self.parts if isinstance(part, Rod)}
        return {
            symbol.point: rods[symbol.edge]
            for symbol in self.symbols
            if symbol.point and symbol.edge in rods
        }

    def is_rod(self, symbol: Symbol) -> bool:
        """Whether a joint is the guide of a rod."""
        rods = {part.body for part in self.parts if isinstance(part, Rod)}
        return symbol.guide is not None and symbol.guide.body in rods

    def find_rack(self, symbol: Symbol) -> Bar | None:
        """The rack whose guide a joint is; None where the guide is that of another part."""
        return find_guided_rack(symbol.guide, self.parts) if symbol.guide else None


def _find_knife_edges(symbols: tuple[Symbol, ...], parts: tuple[Part, ...]) -> dict[str, Vector]:
    plates = {part.body: part for part in parts if isinstance(part, Plate)}
    found = {}
    for symbol in symbols:
        for edge in symbol.features:
            if symbol.fixed and symbol.point and edge.body in plates:
                side = find_outward_direction(plates[edge.body], edge.line)
                if side is not None:
                    found[symbol.point] = unit(side)
    return found
