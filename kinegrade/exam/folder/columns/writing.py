"""key.npz, written beside a key of which every line is as `generate` writes it.

`exam_files` calls it whenever a head is written. Where papers hold different questions, or a line
was changed by hand so that only `exact_keys` reads it, there is no such file, and none is needed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice
from pathlib import Path
from zipfile import ZipFile

import msgspec
import numpy as np
from numpy.lib.format import write_array
from numpy.typing import NDArray

from kinegrade.errors import ExamError
from kinegrade.exam.folder.columns.record import (
    ABOUT,
    PART,
    About,
    find_origin,
    keep_time,
    state_terms,
)
from kinegrade.exam.folder.key.stated_keys import StatedKeys, Terms, read_stated_mistakes
from kinegrade.exam.folder.key.stream import stream_papers
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.records import ExamHead

_Arrays = dict[str, NDArray[np.generic]]


class _UnusualError(Exception):
    """A paper whose keys are no arrays of doubles."""


def write_columns(target: Path, key: Path, head: ExamHead) -> None:
    """Writes `target` for the key of an exam with that head, or removes it where the key has to be
    read line by line.
    """
    partial = target.with_name(f".{target.name}.partial")
    try:
        changed = key.stat().st_mtime_ns
        with ZipFile(partial, "w") as archive:
            _write_parts(archive, key, head)
        keep_time(partial, changed)
        partial.replace(target)
    except (_UnusualError, ExamError, ValueError, OverflowError):
        target.unlink(missing_ok=True)
    finally:
        partial.unlink(missing_ok=True)


def _write_parts(archive: ZipFile, key: Path, head: ExamHead) -> None:
    numbers: dict[str, int] = {}
    terms: dict[int, Terms] = {}
    papers, count = stream_papers(key, head), 0
    while part := list(islice(papers, PART)):
        for name, array in _make_arrays(part, numbers, terms).items():
            with archive.open(f"{count // PART}/{name}.npy", "w", force_zip64=True) as stream:
                write_array(stream, array, allow_pickle=False)
        count += len(part)
    stated = tuple(map(state_terms, terms.values()))
    about = About(find_origin(key, head), count, tuple(numbers), stated, key.stat().st_size)
    with archive.open(ABOUT, "w") as stream:
        stream.write(msgspec.json.encode(about))


def _make_arrays(
    papers: Sequence[Paper], numbers: dict[str, int], terms: dict[int, Terms]
) -> _Arrays:
    """The arrays of a part; `numbers` are those of the mistakes, `terms` by identity those of the
    papers, and both grow.
    """
    keys = list(_require_stated(papers))
    entries = [*chain.from_iterable(each.entries for each in keys)]
    shape = len(keys), -1
    mistakes = read_stated_mistakes([(each, ask) for each in keys for ask in range(len(each))])
    led_to = [*chain.from_iterable(each.items() for each in mistakes)]
    if any(not isinstance(wrong, float) for _, wrong in led_to):
        raise _UnusualError
    for each in keys:
        terms.setdefault(id(each.terms), each.terms)
    which = {known: number for number, known in enumerate(terms)}
    digits = [(entry.plain or entry.decimal).encode("ascii") for entry in entries]
    names = [numbers.setdefault(name, len(numbers)) for name, _ in led_to]
    return {
        "centres": np.array([each.centres for each in keys], np.float64),
        "values": np.array([entry.value for entry in entries], np.float64).reshape(shape),
        "exact": np.array(digits).reshape(shape),
        "terms": np.array([which[id(each.terms)] for each in keys], np.uint32),
        "ends": np.cumsum([0, *map(len, mistakes)], dtype=np.int64),
        "names": np.array(names, np.uint16),
        "wrong": np.array([wrong for _, wrong in led_to], np.float64),
    }


def _require_stated(papers: Sequence[Paper]) -> Iterator[StatedKeys]:
    """The keys of papers as they stand on their lines. Raises _UnusualError."""
    for paper in papers:
        if not isinstance(paper.keys, StatedKeys):
            raise _UnusualError
        yield paper.keys
