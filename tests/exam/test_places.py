"""Places of a class: given by student id, and kept for ever."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.setting.places import assign_places

IDS = st.lists(
    st.text("0123456789ab", min_size=1, max_size=6), min_size=1, max_size=12, unique=True
)


@given(IDS, st.randoms())
def test_everyone_has_a_place_whatever_the_order_of_the_roster(
    ids: list[str], chance: st.Random
) -> None:
    places = assign_places(ids, "spring", {})
    assert list(places.values()) == list(range(len(ids)))
    assert set(places) == set(ids)
    chance.shuffle(ids)
    assert assign_places(ids, "spring", {}) == places


@given(IDS, IDS)
def test_who_has_a_place_keeps_it_and_others_come_after(old: list[str], new: list[str]) -> None:
    kept = assign_places(old, "spring", {})
    places = assign_places(new, "spring", kept)
    assert places.items() >= kept.items()
    late = set(new) - set(old)
    assert sorted(places[student] for student in late) == list(
        range(len(old), len(old) + len(late))
    )
    assert {each: places[each] - len(old) for each in late} == assign_places(late, "spring", {})


def test_a_gap_is_not_filled_as_its_paper_may_be_printed() -> None:
    assert assign_places(["late"], "spring", {"a": 0, "c": 2}) == {"a": 0, "c": 2, "late": 3}


def test_another_secret_gives_other_places() -> None:
    ids = [str(number) for number in range(30)]
    assert list(assign_places(ids, "spring", {})) != list(assign_places(ids, "autumn", {}))


def test_full_width_digits_are_the_same_id() -> None:
    plain = list(assign_places(["007", *"abcdefgh"], "spring", {}))
    wide = list(assign_places(["\uff10\uff10\uff17", *"abcdefgh"], "spring", {}))
    assert wide.index("\uff10\uff10\uff17") == plain.index("007")
