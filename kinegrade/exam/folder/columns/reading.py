"""key.npz read again, part by part, where it was written by the key as it now stands.

A file that is missing, older than the key or damaged is never used: `find_columns` or the part that
cannot be read says so, and `ExamFolder` reads the key itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from itertools import accumulate
from pathlib import Path
from typing import NamedTuple
from zipfile import BadZipFile, ZipFile

import msgspec
import numpy as np
from numpy.lib.format import read_array_header_1_0, read_magic
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.blocks import PartPapers, PartRows
from kinegrade.exam.folder.columns.part import KeyPart
from kinegrade.exam.folder.columns.record import (
    ABOUT,
    ARRAYS,
    PART,
    About,
    is_current,
    is_of_head,
    is_other_key,
    read_terms,
)
from kinegrade.exam.folder.key.stated_keys import Terms
from kinegrade.exam.folder.papers import RightAnswers
from kinegrade.exam.folder.records import ExamHead

DAMAGED = (
    OSError,
    BadZipFile,
    KeyError,
    IndexError,
    ValueError,
    TypeError,
    EOFError,
    msgspec.MsgspecError,
)
_VERSION, _HEADER_AT = (1, 0), 10  # of the format of arrays, and the bytes before its header
_Arrays = dict[str, NDArray[np.generic]]
_read_about = msgspec.json.Decoder(About).decode


@dataclass(frozen=True)
class KeyColumns:
    """The keys of all papers in the order of the roster; those of a part are read together, as they
    are asked for.
    """

    path: Path
    head: ExamHead
    about: About

    def parts(self, size: int) -> Iterator[PartPapers]:
        """The papers, as many parts together as have no more papers than that, one at least. Raises
        one of `DAMAGED` at the first part that cannot be read.
        """
        terms = [read_terms(stated, self.head) for stated in self.about.terms]
        begin = 0
        with ZipFile(self.path) as archive:
            every, together = range(self._parts), max(1, size // PART)
            for first in every[::together]:
                numbers = every[first : first + together]
                parts = [_read_arrays(archive, number, ARRAYS) for number in numbers]
                part = _make_part(_join_arrays(parts), terms, self.about)
                owners = self.head.students[begin : begin + len(part.terms)]
                yield PartPapers(owners, PartRows(part, range(len(owners))))
                begin += len(owners)
                del parts, part  # so that the next take their place

    def right_answers(self) -> Iterator[RightAnswers]:
        """What is right on the papers, part by part: a twentieth of what they take. Raises one of
        `DAMAGED` at the first part that cannot be read.
        """
        terms = [read_terms(stated, self.head) for stated in self.about.terms]
        with ZipFile(self.path) as archive:
            for number in range(self._parts):
                arrays = _read_arrays(archive, number, ("values", "terms"))
                which: list[int] = arrays["terms"].tolist()
                periods = [terms[each].periods for each in {*which}]
                yield RightAnswers(
                    arrays["values"].astype(np.float64, copy=False),
                    [terms[each].rules for each in which],
                    [float(max(each or 0 for each in own)) for own in zip(*periods, strict=True)],
                )

    @property
    def _parts(self) -> int:
        return -(-self.about.papers // PART)


def find_columns(path: Path, key: Path, head: ExamHead) -> KeyColumns | None:
    """The arrays in that file, if they were written by this key and this head; else None."""
    if not path.exists() or head.choices:
        return None
    try:
        about = _open_about(path)
        current = is_current(about, path, key, head) and about.papers == len(head.students)
    except DAMAGED:
        return None
    return KeyColumns(path, head, about) if current else None


def find_earlier_columns(path: Path, head: ExamHead) -> KeyColumns | None:
    """The arrays in that file, whatever the key is now, if they were written for this head."""
    try:
        about = _open_about(path)
    except DAMAGED:
        return None
    fits = is_of_head(about, head) and about.papers == len(head.students)
    return KeyColumns(path, head, about) if fits else None


def is_key_changed(path: Path, key: Path, head: ExamHead) -> bool:
    """Whether a key is another than that by which the arrays in that file were written; False where
    nothing tells it.
    """
    try:
        about = _open_about(path)
        return not is_current(about, path, key, head) and is_other_key(about, key, head)
    except DAMAGED:
        return False


def _open_about(path: Path) -> About:
    with ZipFile(path) as archive:
        return _read_about(archive.read(ABOUT))


def _read_arrays(archive: ZipFile, number: int, names: Iterable[str]) -> _Arrays:
    return {name: _read_array(archive.read(f"{number}/{name}.npy")) for name in names}


def _read_array(content: bytes) -> NDArray[np.generic]:
    """The array that a file holds. `read_array` copies it, and takes as long again for the form of
    each, which most arrays share with others. Raises ValueError.
    """
    begin = _HEADER_AT + int.from_bytes(content[_HEADER_AT - 2 : _HEADER_AT], "little")
    form = _read_form(content[:begin])
    return np.frombuffer(content, form.dtype, offset=begin).reshape(form.shape)


def _join_arrays(parts: Sequence[_Arrays]) -> _Arrays:
    """The arrays of parts that are one behind the other as those of one part."""
    if len(parts) == 1:
        return parts[0]
    joined = {name: np.concatenate([part[name] for part in parts]) for name in ARRAYS}
    ends = [part["ends"].astype(np.int64, copy=False) for part in parts]
    begins = accumulate([0, *(int(each[-1]) for each in ends)])
    moved = [each[1:] + begin for each, begin in zip(ends, begins, strict=False)]
    return {**joined, "ends": np.concatenate([ends[0][:1], *moved])}


class _Form(NamedTuple):
    shape: tuple[int, ...]
    dtype: np.dtype[np.generic]


@lru_cache(maxsize=256)
def _read_form(beginning: bytes) -> _Form:
    """What the beginning of a file says of its array. Raises ValueError where we write none so."""
    stream = BytesIO(beginning)
    if read_magic(stream) != _VERSION:
        raise ValueError
    shape, by_columns, dtype = read_array_header_1_0(stream)
    if by_columns or dtype.hasobject:
        raise ValueError
    return _Form(shape, dtype)


def _make_part(arrays: _Arrays, terms: list[Terms], about: About) -> KeyPart:
    names = arrays["names"].astype(np.uint16, casting="safe", copy=False)
    if names.max(initial=0) >= max(1, len(about.mistakes)):
        raise IndexError
    return KeyPart(
        arrays["centres"].astype(np.float64, copy=False),
        arrays["values"].astype(np.float64, copy=False),
        arrays["exact"].astype(np.bytes_, copy=False),
        [terms[number] for number in arrays["terms"].tolist()],
        arrays["ends"].astype(np.int64, copy=False),
        names,
        about.mistakes,
        arrays["wrong"].astype(np.float64, copy=False),
    )
