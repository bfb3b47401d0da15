"""A long list of a JSON text is read in one step only where reading it entry by entry gives the
same.
"""

from __future__ import annotations

import json
import re

import msgspec
import pytest

from kinegrade.errors import JsonError
from kinegrade.files.fields.json_records import read_records
from kinegrade.files.fields.json_text import read_json

ANN = '  {\n   "name": "Ann",\n   "late": true\n  }'
WRITTEN = f'{{\n "format": 2,\n "students": [\n{ANN},\n  {{\n   "name": "Zoë"\n  }}\n ]\n}}\n'


class Student(msgspec.Struct, frozen=True, omit_defaults=True):
    name: str
    late: bool = False


def test_a_list_as_it_is_written_is_read_in_one_step_and_leaves_the_rest() -> None:
    found = read_records(WRITTEN, "students", Student)
    assert found is not None
    assert found.records == (Student("Ann", late=True), Student("Zoë"))
    assert read_json(found.rest) == {"format": 2, "students": []}


def test_blanks_between_make_no_difference() -> None:
    compact = json.dumps(json.loads(WRITTEN), ensure_ascii=False, separators=(",", ":"))
    found = read_records(compact, "students", Student)
    assert found is not None
    assert found == read_records(WRITTEN, "students", Student)._replace(rest=found.rest)  # type: ignore[union-attr]
    assert read_json(found.rest) == {"format": 2, "students": []}


@pytest.mark.parametrize(
    ("part", "other"),
    [
        ('"late": true', '"late": true,\n   "late": true'),
        ('"late": true', '"late": false'),
        ('"late": true', '"late": true,\n   "seat": "7"'),
        ('"name": "Ann",', '"name": 7,'),
        ('"name": "Ann",', '"name" : "Ann",'),
        ('"Zoë"', '"Zo\\u00eb"'),
        ("true", "NaN"),
        ('"format": 2', '"students": 2'),
        ('"format": 2', f'"spares": {{\n "students": [\n{ANN}\n ]\n}}'),
        (' "students": [', ' "people": ['),
        (ANN, ANN * 2),
        ("}\n", "}}\n"),
    ],
)
def test_any_other_list_is_left_or_gives_the_same(part: str, other: str) -> None:
    text = WRITTEN.replace(part, other, 1)
    found = read_records(text, "students", Student)
    if found is None:
        return
    listed = json.loads(msgspec.json.encode(found.records))
    try:
        rest = read_json(found.rest)
    except JsonError as fault:
        with pytest.raises(JsonError, match=re.escape(str(fault))):
            read_json(text)
    else:
        assert isinstance(rest, dict)
        assert read_json(text) == {**rest, "students": listed}


def test_no_list_and_an_empty_one_are_left() -> None:
    for text in ("{}", '{"students": []}', "[]", "", '{\n "students": []\n}', "\ud800"):
        assert read_records(text, "students", Student) is None
