"""Ways in which a file is damaged, or made to do damage; each a function of chance and bytes."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

Mutation = Callable[[Random, bytes], bytes]

WORDS = (
    *(
        "",
        "NaN",
        "inf",
        "-0",
        "1e9999999999",
        "9" * 400,
        "0.1e-999999999",
        "1/0",
        "((9**16)**16)**16",
    ),
    *(
        "=1+1",
        "@x",
        "=HYPERLINK(1)",
        "\x00",
        "\u202e",
        "\ufeff",
        "\U0001f600",
        "\ud800",
        "é",
        "王伟",
    ),
    *(
        "{{ 7*7 }}",
        "{% for a in 'x' %}",
        "$\\frac{a}{",
        "true",
        "null",
        "[]",
        "{}",
        "../../x",
        "a/b",
        "-1",
    ),
    *(
        '"',
        "'",
        "“1”",
        "30°",
        "1,5",
        "1.234,5",
        "x" * 300,
        "x" * 40_000,
        "\r",
        "\n\n",
        ",,,,",
        ";;;",
    ),
)
_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?")
_WORD = re.compile(rb"[A-Za-z_]{2,}")
_QUOTED = re.compile(rb'"[^"\n]*"')
ENCODINGS = ("utf-8-sig", "utf-16", "utf-32", "gb18030", "cp1252", "utf-7", "cp037", "utf-16-be")


def mutated(chance: Random, content: bytes) -> bytes:
    """The content after one to three mutations."""
    for _ in range(chance.choice((1, 1, 2, 3))):
        content = chance.choice(MUTATIONS)(chance, content)
    return content


def flip(chance: Random, content: bytes) -> bytes:
    """Some bytes are others."""
    changed = bytearray(content)
    for _ in range(chance.choice((1, 3, 20)) if changed else 0):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def cut(chance: Random, content: bytes) -> bytes:
    """The end is missing."""
    return content[: chance.randrange(len(content) + 1)]


def remove(chance: Random, content: bytes) -> bytes:
    """A piece is missing."""
    first = chance.randrange(len(content) + 1)
    return content[:first] + content[first + chance.randrange(60) :]


def double(chance: Random, content: bytes) -> bytes:
    """Lines stand there again."""
    lines = content.splitlines(keepends=True)
    if not lines:
        return content
    place = chance.randrange(len(lines))
    return b"".join(
        (*lines[:place], lines[place] * chance.choice((2, 5, 300)), *lines[place + 1 :])
    )


def swap(chance: Random, content: bytes) -> bytes:
    """Two lines change places."""
    lines = content.splitlines(keepends=True)
    if len(lines) > 1:
        one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
        lines[one], lines[other] = lines[other], lines[one]
    return b"".join(lines)


def another_number(chance: Random, content: bytes) -> bytes:
    """A number is another word."""
    return _replaced(chance, content, _NUMBER, _word(chance))


def another_word(chance: Random, content: bytes) -> bytes:
    """A name is another word."""
    return _replaced(chance, content, _WORD, _word(chance))


def another_type(chance: Random, content: bytes) -> bytes:
    """A quoted text is a number, a list, a table or nothing."""
    kinds = (b"1", b"[]", b"{}", b"true", b"null", b"[[1]]", b"-1e999", b'{"a": 1}', b'""')
    return _replaced(chance, content, _QUOTED, chance.choice(kinds))


def insert(chance: Random, content: bytes) -> bytes:
    """A word stands where none was."""
    place = chance.randrange(len(content) + 1)
    return content[:place] + _word(chance) + content[place:]


def nest(chance: Random, content: bytes) -> bytes:
    """Brackets in brackets."""
    place, depth = chance.randrange(len(content) + 1), chance.choice((10, 1_000, 20_000))
    opening = chance.choice((b"[", b"{", b"(", b'{"a":', b"a.", b"-"))
    return content[:place] + opening * depth + content[place:]


def long_line(chance: Random, content: bytes) -> bytes:
    """A piece stands there very often."""
    place = chance.randrange(len(content) + 1)
    piece = content[place : place + chance.randrange(1, 30)]
    return content[:place] + piece * chance.choice((100, 5_000)) + content[place:]


def encode(chance: Random, content: bytes) -> bytes:
    """The same text in another encoding."""
    text = content.decode("utf-8", "replace")
    return text.encode(chance.choice(ENCODINGS), "replace")


def line_ends(chance: Random, content: bytes) -> bytes:
    """The lines of another system."""
    return content.replace(
        b"\n", chance.choice((b"\r\n", b"\r", b"\n\n", b"\x0b", b"\xe2\x80\xa8"))
    )


def separator(chance: Random, content: bytes) -> bytes:
    """Another sign between cells."""
    return content.replace(b",", chance.choice((b";", b"\t", b"|", b", ", b",,")))


def _word(chance: Random) -> bytes:
    return chance.choice(WORDS).encode("utf-8", "surrogatepass")


def _replaced(chance: Random, content: bytes, shape: re.Pattern[bytes], new: bytes) -> bytes:
    found = list(shape.finditer(content))
    if not found:
        return content
    place = chance.choice(found)
    return content[: place.start()] + new + content[place.end() :]


MUTATIONS: tuple[Mutation, ...] = (
    *(flip, cut, remove, double, swap, another_number, another_number, another_word, another_word),
    *(another_type, insert, nest, long_line, encode, line_ends, separator),
)
