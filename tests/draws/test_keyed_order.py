"""What a secret decides is addressed: whatever else was looked up, and on any machine, it is the
same.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections import Counter
from hashlib import sha256
from hmac import new as hmac

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.draws.keyed_order import KeyedOrder, address

# The promise for ten years. These lines are never edited.
PROMISED = {
    ("spring", "q1", 12): [5, 7, 0, 4, 2, 8, 11, 10, 3, 1, 9, 6],
    ("spring", "q2", 12): [1, 4, 8, 2, 9, 10, 11, 3, 0, 5, 6, 7],
    # longer than the block of the hash, so that it is hashed first
    ("spring " * 20, "q1", 12): [8, 1, 0, 11, 2, 6, 10, 5, 7, 3, 4, 9],
    ("spring", "q1", 10**40): [
        8465938247918457647261445276548969690992,
        6213844799307575479387127964451870016418,
        5659226532383220092855134442636426402728,
        4151760358248073661212440518227911696575,
        5652614089611621820961500094907342546380,
        7880460854024845708532027577212311222540,
        837703422583242080952701501330178419506,
        4579574755447925828618962288843398593257,
        9070381096294675959148252727608629119867,
        4288930781758084963617918429316358821879,
        4982059893382884361672091267013888272224,
        7631813559115927396458285449774926018293,
    ],
}


def first(secret: str, name: str, size: int) -> list[int]:
    order = KeyedOrder(secret, name, size)
    return [order.at(place) for place in range(min(size, 12))]


def test_a_secret_gives_the_order_that_it_gave_ten_years_ago() -> None:
    assert {key: first(*key) for key in PROMISED} == PROMISED


@given(st.integers(1, 700), st.text(max_size=4), st.text(max_size=4))
def test_an_order_holds_every_number_once(size: int, secret: str, name: str) -> None:
    order = KeyedOrder(secret, name, size)
    assert sorted(map(order.at, range(size))) == list(range(size))


@pytest.mark.parametrize("size", [1, 2, 3, 4, 5, 9, 10, 17, 2**10 - 1, 2**10, 2**10 + 1, 3**7])
def test_an_order_of_an_uneven_size_holds_every_number_once(size: int) -> None:
    order = KeyedOrder("spring", "q1", size)
    assert sorted(map(order.at, range(size))) == list(range(size))


@given(st.integers(200, 10**9))
def test_another_secret_or_name_orders_otherwise(size: int) -> None:
    orders = [first(*key, size) for key in (("a", "q1"), ("b", "q1"), ("a", "q2"))]
    assert orders[0] != orders[1] != orders[2] != orders[0]


def test_every_number_comes_about_equally_often_at_a_place() -> None:
    counts = Counter(KeyedOrder(str(number), "q1", 7).at(0) for number in range(2100))
    chi_square = sum((counts[number] - 300) ** 2 / 300 for number in range(7))
    assert chi_square < 22.5  # 6 degrees of freedom: 99.9 %


def test_all_orders_of_three_come_about_equally_often() -> None:
    counts = Counter(tuple(first(str(number), "q1", 3)) for number in range(1800))
    assert len(counts) == 6
    assert sum((count - 300) ** 2 / 300 for count in counts.values()) < 20.5  # 5 degrees of freedom


@pytest.mark.parametrize("place", [-1, 12])
def test_beyond_its_end_an_order_has_nothing(place: int) -> None:
    with pytest.raises(IndexError, match=re.escape(f"place {place} of an order of 12")):
        KeyedOrder("spring", "q1", 12).at(place)


def test_an_address_is_the_hmac_of_its_parts_each_with_its_length() -> None:
    message = b"\x00\x00\x00\x02q1\x00\x00\x00\x03\xe7\x8e\x8b\x00\x00\x00\x0212"
    expected = int.from_bytes(hmac(b"spring", message, sha256).digest(), "big")
    assert address("spring", "q1", "王", 12) == expected
    assert address("spring", "q1", "1", 2) != address("spring", "q1", "12", "")


def test_another_process_orders_the_same() -> None:
    code = (
        "import json; from tests.draws.test_keyed_order import first;"
        "print(json.dumps(first('spring', 'q1', 1000)))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        check=True,
        env={**os.environ, "PYTHONHASHSEED": "7", "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert json.loads(ran.stdout) == first("spring", "q1", 1000)
