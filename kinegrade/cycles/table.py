"""A cycle as a table: a row for each position, for whoever calculates on."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from kinegrade.cycles.centrodes import find_poled_bodies, trace_centrodes
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.graph import convert_displacements
from kinegrade.cycles.rounding import find_scales
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.mechanics.ground import GROUND
from kinegrade.motion.path import Array
from kinegrade.motion.placing import find_carriers
from kinegrade.numbers.units import read_unit
from kinegrade.problem.pole_names import name_poles

_DIGITS = 12


def write_table(cycle: Cycle) -> str:
    """The input's displacement in degrees or m, the coordinates of moving points in m, those of
    velocity poles in the plane and, by where the body is at the instant, in the body, and the asks
    in their units; a cell is empty where there is no value, or one beyond all bounds.
    """
    path = cycle.path
    placement, scales = path.place(cycle.moved), find_scales(path)
    unit = "deg" if path.input.is_angle else "m"
    moved = scales.clear(convert_displacements(path, placement.moved), read_unit(unit))
    columns = [(f"input ({unit})", moved)]

    def add_place(name: str, place: Iterable[Array]) -> None:
        for axis, values in zip("xy", place, strict=True):
            columns.append((f"{axis}_{name} (m)", scales.clear(values, read_unit("m"))))

    mechanism = placement.frames.mechanism
    moving = [name for name, body in find_carriers(mechanism).items() if body != GROUND]
    for name in moving:
        add_place(name, mechanism.points[name])
    poles = name_poles(find_poled_bodies(path), cycle.solution.template)
    for each in trace_centrodes(placement, tuple(poles)):
        pole = poles[each.body]
        add_place(pole, each.fixed)
        add_place(f"{pole}_{each.body}", each.moving)
    columns += [(f"{each.ask.name} ({each.ask.unit.text})", each.values) for each in cycle.curves]
    shape = placement.moved.shape
    cells = [[_write(float(number)) for number in np.broadcast_to(v, shape)] for _, v in columns]
    return write_csv_text([name for name, _ in columns], list(zip(*cells, strict=True)))


def _write(number: float) -> str:
    return f"{number:.{_DIGITS}g}" if np.isfinite(number) else ""
