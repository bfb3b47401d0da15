"""Several rows of one student, put into the order in which they were handed in."""

from __future__ import annotations

import pytest

from kinegrade.grading.sheets.attempts import find_unordered, order_attempts
from kinegrade.grading.sheets.entry import Entry


def make_entries(*times: str) -> tuple[Entry, ...]:
    """Rows sent at these times, each with another answer."""
    return tuple(Entry(line, (str(line),), submitted=time) for line, time in enumerate(times, 2))


@pytest.mark.parametrize(
    "times",
    [
        ("05.11.2026 10:02", "05.11.2026 09:00"),
        ("5/11/2026 10:02:00", "4/10/2026 11:00:00"),
        ("05.11.2026 09:00", "2026-01-02 10:00"),
    ],
)
def test_a_date_whose_day_is_not_certain_may_say_which_was_first(times: tuple[str, ...]) -> None:
    several = make_entries(*times)
    assert not list(find_unordered({"7": several}))
    assert [entry.line for entry in order_attempts(several)] == [3, 2]


@pytest.mark.parametrize(
    "times",
    [
        ("05.11.2026 10:02", "06.10.2026 09:00"),  # in June or in October
        ("05.11.2026 10:02", "13.11.2026 09:00"),  # of which one can be read in one order alone
        ("05.11.2026 10:02", "05.11.2026 10:02"),
        ("05.11.2026 10:02", "yesterday"),
    ],
)
def test_rows_stay_where_the_readings_of_dates_differ(times: tuple[str, ...]) -> None:
    several = make_entries(*times)
    (told,) = find_unordered({"7": several})
    assert told.line == 2
    assert order_attempts(several) == several
