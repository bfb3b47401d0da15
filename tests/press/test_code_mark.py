"""The code's mark is the QR code that the standard prescribes, in few pieces."""

from __future__ import annotations

import pytest
import segno

from kinegrade.press.code_mark import PATTERN, make_code_mark


@pytest.mark.parametrize("code", ["F7H0-CV5F", "A", '#read("x")$y$', "K7Q2-9FHM-" * 9])
def test_the_runs_are_the_dark_modules(code: str) -> None:
    mark = make_code_mark(code)
    dark = {(run.x + step, run.y) for run in mark.runs for step in range(run.length)}
    matrix = segno.make(code, error="m", micro=False, mask=PATTERN).matrix
    assert dark == {
        (x, y) for y, row in enumerate(matrix) for x, module in enumerate(row) if module
    }
    assert mark.size == len(matrix)


def test_the_three_corners_are_marked_and_runs_do_not_touch() -> None:
    mark = make_code_mark("F7H0-CV5F")
    assert mark.size == 21
    tops = [(run.x, run.length) for run in mark.runs if run.y == 0]
    assert tops[0] == (0, 7)
    assert tops[-1] == (14, 7)
    assert [
        (one, other)
        for one, other in zip(mark.runs, mark.runs[1:], strict=False)
        if one.y == other.y and not (one.x + one.length < other.x)
    ] == []
