"""In large print an equation that is too wide gets more lines, not smaller letters."""

from __future__ import annotations

from itertools import chain

import pytest

from kinegrade.language.math.plain import write_plain_row
from kinegrade.language.math.reading import read_math
from kinegrade.press.solutions.equations import arrange_equations, measure_display
from kinegrade.worked.document import Display

ROOM = 22.0  # em, about as large print has
SUM = r"0.4\,\unit{m/s^2}\cdot\sin 60^\circ + 0.06\,\unit{m/s^2}\cdot\cos 60^\circ - 0.7\,\unit{m/s^2}"
WIDE = {
    "fraction": rf"a &= \frac{{{SUM}}}{{\sin 60^\circ}} = 3\,\unit{{m/s^2}}",
    "fraction with two long sides": rf"a &= \frac{{{SUM}}}{{{SUM}}}",
    "root": rf"v_B &= \sqrt{{{SUM}}}",
    "fraction in a bracket": rf"\psi &= \arccos\left(\frac{{{SUM}}}{{2\,\unit{{m/s^2}}}}\right)",
    "long left side": rf"a_B\cos\psi + \frac{{{SUM}}}{{2}} &= \frac{{{SUM}}}{{3}}",
    "after a sign": rf"a &= b - \frac{{{SUM}}}{{\sin 60^\circ}}",
}


@pytest.mark.parametrize("latex", WIDE.values(), ids=WIDE)
def test_what_is_too_wide_is_folded(latex: str) -> None:
    display = measure_display(Display((read_math(latex, ""),)))
    assert [group for group in arrange_equations(display, ROOM) if not group.fits]
    groups = arrange_equations(display, ROOM, folds=True)
    assert [group for group in groups if not group.fits] == []
    written = "".join(map(write_plain_row, chain.from_iterable(group.rows for group in groups)))
    whole = write_plain_row(read_math(latex.replace("&", ""), ""))
    assert "".join(written.replace(";", "").split()) == "".join(whole.split())


def test_a_remark_goes_to_a_row_of_its_own() -> None:
    latex = (
        r"\omega_{AB} &\approx 0.123\,\unit{rad/s}\quad\text{(counter-clockwise about } C\text{)}"
    )
    display = measure_display(Display((read_math(latex, ""),)))
    (group,) = arrange_equations(display, 20.0, folds=True)
    assert group.fits
    assert len(group.rows) == 2


def test_what_fits_is_left_as_it_is() -> None:
    display = measure_display(Display((read_math(r"a &= \frac{b + c}{d}", ""),)))
    assert arrange_equations(display, ROOM, folds=True) == arrange_equations(display, ROOM)
