"""A generate of a large course that is killed five times, at moments by chance, and resumed gives the
exam of one that nobody killed, byte for byte.

The papers are set, and some of them printed afterwards from both exams: to print all would take
longer than all other proofs together.
"""

from __future__ import annotations

import shutil
from pathlib import Path
from random import Random

from tests.exam.test_resuming import Moment, interrupt, kinegrade_in, unfinished, write_files
from tests.small_class import contents, kinegrade

STUDENTS = 20_000
KILLS, PRINTED = 5, 4
OPTIONS = "--no-papers", "--reproducible", "spring"


def hold(seed: int, folder: Path, students: int = STUDENTS) -> int:
    """Kill a run at the moments of a seed; gives how many papers were compared."""
    place = folder / "resumed papers"
    try:
        whole, broken = (write_class(place / name, students) for name in ("whole", "broken"))
        assert kinegrade_in(whole, *OPTIONS).returncode == 0
        random, key = Random(seed), (whole / "EXAM" / "key.jsonl").stat().st_size
        for share in sorted(random.uniform(0.01, 0.95) for _ in range(KILLS)):
            assert interrupt(broken, has_set(int(share * key)), *OPTIONS, "--resume")
            assert unfinished(broken) is not None
        result = kinegrade_in(broken, *OPTIONS)
        assert result.returncode == 0, result.stderr
        assert "papers were there from an earlier run" in result.stderr
        assert contents(broken / "EXAM") == contents(whole / "EXAM")
        for number in random.sample(range(students), PRINTED):
            student = f"{number:0{len(str(students - 1))}}"
            assert print_paper(whole, student) == print_paper(broken, student)
    finally:
        shutil.rmtree(place)
    return students


def write_class(folder: Path, students: int) -> Path:
    """A bank and a roster of so many students, who may have the same numbers."""
    folder.mkdir(parents=True)
    write_files(folder, students)
    with (folder / "bank.toml").open("a", encoding="utf-8") as bank:
        bank.write("repeats = true\n")
    return folder


def has_set(size: int) -> Moment:
    """The moment at which the key has so many bytes."""
    return lambda partial: _find_size(partial / "key.jsonl") >= size


def _find_size(file: Path) -> int:
    return file.stat().st_size if file.exists() else 0


def print_paper(folder: Path, student: str) -> bytes:
    """The paper of a student."""
    file = folder / f"{student}.pdf"
    result = kinegrade("paper", str(folder / "EXAM"), student, "-o", str(file))
    assert result.exit_code == 0, result.stderr
    return file.read_bytes()
