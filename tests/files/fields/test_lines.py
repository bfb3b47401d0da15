"""The line of a fault is the line of its key, however the file is laid out."""

from __future__ import annotations

import json
import tomllib
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.files.fields.lines import lines_of_json, lines_of_toml
from kinegrade.files.fields.place import Place

PLAIN = ["1", "0.5", "true", '"x"', "'x'", '"#"', '"[a]\\n\\""', "2026-05-01 10:00:00", "nan"]
SPREAD = [
    '"""\na = 1 # "\n"""',
    "'''\n[a]\n\"''''",
    '"""\n\\"\\"\\" ""\n"""',
    '""""quoted"""""',
    "[ # ]\n  1,\n  '''\n''',\n]",
    "[]",
]
KEYS = ["a", "b", "a-b", "1", '"a b"', "'it\"s'", '"\\u00e9"', '"a.b"', '""']
BARE = st.sampled_from(KEYS)


def plain_key(written: str) -> str:
    return str(next(iter(tomllib.loads(f"{written} = 1"))))


class Writer:
    """Writes TOML line by line, and keeps the line of each place as it goes."""

    def __init__(self) -> None:
        self.text, self.lines = "", {}

    def write(self, text: str, place: Place | None = None) -> None:
        if place is not None:
            self.lines.setdefault(place, self.text.count("\n") + 1)
        self.text += text


@st.composite
def inline(draw: st.DrawFn, writer: Writer, place: Place, depth: int) -> None:
    """A value, written where the writer stands."""
    kind = draw(st.sampled_from(["plain", "spread", "list", "table"] if depth else ["plain"]))
    if kind in ("plain", "spread"):
        writer.write(draw(st.sampled_from(PLAIN if kind == "plain" else SPREAD)))
        if kind == "spread" and writer.text.endswith(",\n]"):
            line = writer.text.count("\n")
            writer.lines |= {(*place, 0): line - 2, (*place, 1): line - 1}
        return
    if kind == "list":
        writer.write("[")
        for number in range(draw(st.integers(0, 3))):
            writer.write(draw(st.sampled_from(["", "\n", " # ] comment\n\t"])))
            writer.write("", (*place, number))
            draw(inline(writer, (*place, number), depth - 1))
            writer.write(draw(st.sampled_from([",", " ,", "\n,"])))
        writer.write("]")
        return
    writer.write("{ ")
    for number, key in enumerate(draw(st.lists(BARE, max_size=3, unique_by=plain_key))):
        writer.write(", " if number else "")
        draw(pair(writer, place, key, depth - 1))
    writer.write(" }")


@st.composite
def pair(draw: st.DrawFn, writer: Writer, place: Place, key: str, depth: int) -> None:
    """A key, dotted or not, with its value."""
    keys = [key, *draw(st.lists(BARE, max_size=2))]
    for number, part in enumerate(keys):
        place = (*place, plain_key(part))
        writer.write(draw(st.sampled_from([".", " . "])) if number else "")
        writer.write(part, place)
    writer.write(draw(st.sampled_from(["=", " = "])))
    draw(inline(writer, place, depth))


@st.composite
def documents(draw: st.DrawFn) -> tuple[str, dict[Place, int]]:
    writer = Writer()

    def body(place: Place) -> None:
        for key in draw(st.lists(BARE, max_size=3, unique_by=plain_key)):
            writer.write(draw(st.sampled_from(["", "\n", "# [x]\n", "  "])))
            draw(pair(writer, place, key, 2))
            writer.write(draw(st.sampled_from(["\n", " # a = 1\n", "\r\n"])))

    body(())
    for number in range(draw(st.integers(0, 3))):
        name = f"table{number}"
        match draw(st.sampled_from(["table", "dotted", "tables", "nested"])):
            case "table":
                writer.write(f"[{name}] # [[x]]\n", (name,))
                body((name,))
            case "dotted":
                writer.write("", (name,))
                writer.write(f'[ {name} . "x.y" ]\n', (name, "x.y"))
                body((name, "x.y"))
            case "tables":
                for entry in range(draw(st.integers(1, 3))):
                    writer.write("", (name,))
                    writer.write(f"[[{name}]]\n", (name, entry))
                    body((name, entry))
            case "nested":
                for entry in range(2):
                    writer.write("", (name,))
                    writer.write(f"[[ {name} ]]\n", (name, entry))
                    for inner in range(2):
                        writer.write("", (name, entry, "in"))
                        writer.write(f"[[{name}.in]]\n", (name, entry, "in", inner))
                        writer.write(f"[{name}.in.deep]\n", (name, entry, "in", inner, "deep"))
                        body((name, entry, "in", inner, "deep"))
    return writer.text, writer.lines


def places(content: Any, place: Place = ()) -> set[Place]:
    """All places of a content."""
    parts: list[tuple[Any, Any]] = []
    if isinstance(content, dict):
        parts = list(content.items())
    if isinstance(content, list):
        parts = list(enumerate(content))
    found = {(*place, step) for step, _ in parts}
    return found.union(*(places(part, (*place, step)) for step, part in parts))


@given(documents())
def test_each_key_of_a_toml_file_is_found_on_its_line(
    document: tuple[str, dict[Place, int]],
) -> None:
    text, expected = document
    assert places(tomllib.loads(text)) == expected.keys()
    assert lines_of_toml(text) == expected


VALUES = st.recursive(
    st.sampled_from([1, -2.5e3, True, None, "", '"', "a\\", "[{", "x: y", "é\n"]),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3)
    ),
    max_leaves=12,
)


@given(VALUES, st.sampled_from([None, 0, 2]), st.booleans())
def test_each_key_of_a_json_file_is_found_on_its_line(
    value: Any, indent: int | None, plain: bool
) -> None:
    text = json.dumps({"all": value}, indent=indent, ensure_ascii=plain)
    lines = lines_of_json(text)
    assert lines.keys() == places({"all": value})
    for place, line in lines.items():
        if isinstance(place[-1], str):
            assert json.dumps(place[-1], ensure_ascii=plain) in text.split("\n")[line - 1]
    if indent is not None:  # then every place stands on a line alone, in order
        assert list(lines.values()) == sorted(set(lines.values()))


@pytest.mark.parametrize("end", ["", "\n", "\r\n"])
def test_the_line_of_a_key_that_follows_texts_of_several_lines(end: str) -> None:
    text = f'a = """\nb = 1\n""""\nc.d = [\n  {{ e = 1 }},\n]\nlast = 1{end}'
    assert lines_of_toml(text) == {
        ("a",): 1,
        ("c",): 4,
        ("c", "d"): 4,
        ("c", "d", 0): 5,
        ("c", "d", 0, "e"): 5,
        ("last",): 7,
    }
