"""The contract of `fast.typed_cells` with `typed.answers.read`."""

from __future__ import annotations

from fractions import Fraction
from math import isnan

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.asks import Ask
from kinegrade.grading.fast.bounds import ROUNDING
from kinegrade.grading.fast.typed_cells import CellReader, TypedCells
from kinegrade.grading.typed.answers import Reading, read
from kinegrade.grading.typed.cell_block import ListedCells
from kinegrade.grading.typed.decimal_style import find_file_style

ASKS = (
    Ask("q1", "v_B", "m/s", Fraction(2)),
    Ask("q1", "omega", "rad/s", Fraction(2), "counter-clockwise positive", "ccw"),
    Ask("q2", "ratio", "1", Fraction(1)),
)
PLAIN = st.from_regex(r"[+-]?[0-9]{1,9}(\.[0-9]{1,9})?", fullmatch=True)
ODD = st.sampled_from(
    ["", "-", "1,234", "1.234", "0,5", "2 m/s", "3 kg", "√3", "=1+1", "clockwise 2", "1e3", "?"]
)
ROOT = st.from_regex(r"-?(?:√|sqrt)\(?[0-9]{1,9}(\.[0-9]{1,9})?\)?", fullmatch=True)
UNIT = st.sampled_from(
    ["", " m/s", "cm/s", " km/h", " rpm", " deg/s", " clockwise", " kg", "\u00b2"]
)
WITH_UNIT = st.builds(
    "{}{}".format, st.from_regex(r"-?[0-9]{1,9}([.,][0-9]{1,9})?", fullmatch=True), UNIT
)
CELLS = st.one_of(PLAIN, PLAIN, ODD, ROOT, WITH_UNIT.map(str.strip))
ROWS = st.lists(st.tuples(*[CELLS] * 3), min_size=1, max_size=6)


@given(ROWS, st.sampled_from([None, "comma", "point"]))
def test_cells_are_read_as_one_by_one(rows: list[tuple[str, ...]], declared: str | None) -> None:
    style = find_file_style(rows, declared)  # type: ignore[arg-type]
    cells = CellReader(ASKS, style).cells(ListedCells(rows))
    for row, responses in enumerate(rows):
        for number, (typed, ask) in enumerate(zip(responses, ASKS, strict=True)):
            place = row * len(ASKS) + number
            expected = read(typed, ask.unit, style.of_row(responses), ask.convention, ask.sign)
            assert cells.reading(place) == expected
            assert cells.typed[place] == typed
            assert cells.read_as[place] == expected.read_as
            assert cells.are_filled[place] == bool(typed)
            _require_compared(cells, place, expected)
            if expected.value is None or expected.error:
                assert isnan(cells.values[place])
            else:
                assert cells.values[place] == float(expected.value)


def _require_compared(cells: TypedCells, place: int, expected: Reading) -> None:
    """A number is compared by its double, where that is not exact by one that is as near as what
    is certain allows; decimals of few digits are exact.
    """
    compared = float(cells.compared[place])
    if expected.value is None:
        assert isnan(compared)
        return
    if expected.value == 0 and expected.error:
        assert isnan(compared)
        return
    away = abs(Fraction(compared) - expected.value)
    assert away <= Fraction(ROUNDING) * abs(expected.value) / 2
    if cells.decimals[place]:
        assert not expected.error
        assert Fraction(repr(compared)) == expected.value
