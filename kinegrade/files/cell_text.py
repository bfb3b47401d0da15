"""What a cell holds: blanks of any kind are trimmed, names of columns compared."""

from __future__ import annotations

import unicodedata

_SHOWN_CHARACTERS = 1000
# Turn the direction of what follows them, to the end of a line
DIRECTIONS = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
INVISIBLE = "\u00ad\u061c\ufeff\u200b\u200c\u200d\u200e\u200f\u2060" + DIRECTIONS
_SURROUNDING = "".join(chr(code) for code in range(0x3001) if chr(code).isspace()) + INVISIBLE
_UNSEEN = str.maketrans(dict.fromkeys(INVISIBLE))
_DASHES = "-\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uff0d "


def trim(text: str) -> str:
    """Without surrounding blanks of any kind: no-break, ideographic, zero-width, byte-order mark.

    >>> trim("\\u3000 007\\u200b ")
    '007'
    """
    return text.strip(_SURROUNDING)


def drop_invisible(text: str) -> str:
    """Without characters that nobody sees, wherever they stand: what looks the same is the same.

    >>> drop_invisible("00\\u200b12")
    '0012'
    """
    return text if text.isascii() else text.translate(_UNSEEN)


def is_answered(cell: str) -> bool:
    """Whether anything but blanks and dashes was typed.

    >>> is_answered("0"), is_answered(" - ")
    (True, False)
    """
    return cell[:1].isalnum() or bool(trim(cell).strip(_DASHES))


def make_header_key(text: str) -> str:
    """A column name for comparison: no full-width forms, single blanks, no upper case.

    >>> make_header_key(" Q1\\uff0ev_B ")
    'q1.v_b'
    """
    return " ".join(trim(unicodedata.normalize("NFKC", text)).casefold().split())


def shorten(text: str) -> str:
    """A cell for a report: of a longer one the first SHOWN_CHARACTERS, and how many there are.

    >>> shorten("9" * 5000)[-14:]
    '9… (1000/5000)'
    """
    if len(text) <= _SHOWN_CHARACTERS:
        return text
    return f"{text[:_SHOWN_CHARACTERS]}… ({_SHOWN_CHARACTERS}/{len(text)})"
