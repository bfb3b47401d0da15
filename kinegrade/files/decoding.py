"""The bytes of a table as text: in the encoding that is declared, marked, or most likely."""

from __future__ import annotations

import codecs
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.language.message import Fault, Message, Text

_LATIN = frozenset(map(chr, range(0xC0, 0x250)))  # letters with accents
_CONTROL_SHARE = 4  # a file of which more than a quarter is control characters is not text
_CONTROLS = bytes(set(range(32)) - set(b"\t\n\r\f")) + b"\x7f"
_MARKS = (
    (codecs.BOM_UTF8, "UTF-8"),
    (codecs.BOM_UTF32_LE, "UTF-32-LE"),  # before UTF-16, whose mark is its beginning
    (codecs.BOM_UTF32_BE, "UTF-32-BE"),
    (codecs.BOM_UTF16_LE, "UTF-16-LE"),
    (codecs.BOM_UTF16_BE, "UTF-16-BE"),
)
STRANGE_UTF_8 = "UTF-8, backslashreplace"  # no encoding is recognised: bytes written out
_OTHER_FORMATS = (
    (b"PK\x03\x04", Message("files.is-spreadsheet-or-archive")),
    (b"\xd0\xcf\x11\xe0", Message("files.is-spreadsheet")),
    (b"%PDF", Message("files.is-pdf")),
    (b"\x89PNG", Message("files.is-picture")),
    (b"\xff\xd8\xff", Message("files.is-picture")),
    (b"\x1f\x8b", Message("files.is-compressed")),
)
CSV_FILE = Message("files.a-csv-file")
_SEND_CSV = Message("files.save-as-csv")


@dataclass(frozen=True)
class Misread:
    """Bytes that are not in the encoding a file seems to have, and the line where they stand."""

    line: int
    encoding: str
    shown: str


@dataclass(frozen=True)
class Decoded:
    """The text of a file and its encoding; `misread` where another one was assumed."""

    text: str
    encoding: str
    misread: Misread | None = None


def decode(content: bytes, file: str, encoding: str | None) -> Decoded:
    """The text of a file, `encoding` as declared. Raises TableError for what is no text, or not in
    the declared encoding.
    """
    declared = _decode_declared(content, file, encoding)
    if declared is not None:
        return Decoded(declared, str(encoding))
    _refuse_other_formats(content, file)
    return _decode(content)


def _refuse_other_formats(content: bytes, file: str) -> None:
    kinds = [kind for beginning, kind in _OTHER_FORMATS if content.startswith(beginning)]
    sample = content[:65536]
    controls = len(sample) - len(sample.translate(None, _CONTROLS))
    if (
        not kinds
        and _find_byte_order_mark(content) is None
        and controls * _CONTROL_SHARE > len(sample)
    ):
        kinds = [Message("files.is-not-text")]
    if kinds:
        raise TableError(Fault(file, kinds[0], CSV_FILE, _SEND_CSV))


def _find_byte_order_mark(content: bytes) -> tuple[bytes, str] | None:
    return next((pair for pair in _MARKS if content.startswith(pair[0])), None)


def _decode_declared(content: bytes, file: str, encoding: str | None) -> str | None:
    """The text in the encoding that was declared; None where none was, or where a mark or UTF-8
    says otherwise.
    """
    if encoding is None or _find_byte_order_mark(content):
        return None
    try:
        content.decode("utf-8")
        if b"\0" not in content:
            return None
    except UnicodeDecodeError:
        pass
    try:
        return content.decode(encoding)
    except (LookupError, UnicodeError) as fault:
        what = Message("files.not-in-declared", encoding=encoding, reason=str(fault))
        expected, do = Message("files.text"), Message("files.declare-right")
        raise TableError(Fault(file, what, expected, do)) from fault


def _decode(content: bytes) -> Decoded:
    mark, encoding = _find_byte_order_mark(content) or (b"", "UTF-8")
    body = content[len(mark) :]
    try:
        return Decoded(body.decode(encoding), encoding)
    except UnicodeDecodeError as fault:
        line = body.count(b"\n", 0, fault.start) + 1
        misread = Misread(line, encoding, fault.object[fault.start : fault.start + 8].hex(" "))
    if mark:
        return Decoded(body.decode(encoding, "backslashreplace"), encoding, misread)
    return Decoded(*_decode_assumed(body), misread)


def _decode_assumed(body: bytes) -> tuple[str, str]:
    """The text and its encoding: what most spreadsheets in China and Europe write if not UTF-8."""
    for encoding, is_likely in (("GB18030", _is_chinese), ("Windows-1252", bool)):
        try:
            text = body.decode(encoding)
        except UnicodeDecodeError:
            continue
        if is_likely(text):
            return text, encoding
    return body.decode("utf-8", "backslashreplace"), STRANGE_UTF_8


def name_encoding(encoding: str) -> Text:
    """The encoding of a table as messages name it."""
    return Message("files.strange-utf-8") if encoding == STRANGE_UTF_8 else encoding


def _is_chinese(text: str) -> bool:
    """Whether most characters beyond ASCII are the common ones of GB 2312, or Latin letters; a
    Western text in another encoding gives rare ones.
    """
    beyond = [character for character in text if not character.isascii()]
    others = [character for character in beyond if character not in _LATIN]
    common = "".join(others).encode("gb2312", "ignore").decode("gb2312")
    return 2 * (len(beyond) - len(others) + len(common)) > len(beyond)
