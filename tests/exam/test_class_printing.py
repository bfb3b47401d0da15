"""A class printed by several processes: the same bytes, the same refusals, nobody left behind."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from kinegrade.exam.printing import class_printing
from kinegrade.exam.printing.class_printing import CHUNK, MOST, split_class
from kinegrade.exam.printing.printing import Printed
from kinegrade.press.binding.part import count_pages
from tests.problem.crank import crank_text
from tests.small_class import contents, generate, key_lines

pytestmark = pytest.mark.xdist_group("class printing")  # one worker sets the class, once
TWO_CHUNKS = "student,name\n" + "".join(
    f"{number},Student {number}\n" for number in range(2 * CHUNK + 1)
)
FEW_PAPERS = 4  # of `small_parts`
SMALL_PARTS = f"""
from kinegrade.exam.printing import class_printing

class_printing.CHUNK = {FEW_PAPERS}
"""  # for a process of its own
BANK = """title = "T"
course = "C"
shuffle = true
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
asks = { v_x = 1 }
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
asks = { v_y = 1 }
"""

FEW = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = [1], r = "1 .. 8 step 1", omega = "1 .. 8 step 1" }
"""


def write(folder: Path) -> Path:
    """A class that is large enough for two processes."""
    (folder / "roster.csv").write_text(TWO_CHUNKS, encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    return folder


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write(tmp_path)


def test_later_parts_are_filled_up_to_the_longest_paper_before_them(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    known: list[int] = []
    usual = class_printing.print_papers

    def note(*given: Any) -> list[Printed]:
        known.append(given[-1])
        return usual(*given)

    monkeypatch.setattr(class_printing, "print_papers", note)
    monkeypatch.setattr(class_printing, "CHUNK", FEW_PAPERS)
    assert generate(folder, "EXAM", "--jobs", "1").exit_code == 0
    pages = count_pages(next((folder / "EXAM" / "papers").glob("*.pdf")).read_bytes())
    assert (known[0], known[-1]) == (0, pages)


def write_few(folder: Path) -> Path:
    """A class that is large enough where FEW_PAPERS are worth a process."""
    write(folder)
    rows = TWO_CHUNKS.splitlines(keepends=True)[: 2 * FEW_PAPERS + 2]
    (folder / "roster.csv").write_text("".join(rows), encoding="utf-8")
    return folder


@pytest.fixture
def few(tmp_path: Path, small_parts: int) -> Path:
    assert small_parts == FEW_PAPERS
    return write_few(tmp_path)


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """What a single process writes."""
    place = write_few(tmp_path_factory.mktemp("one"))
    assert generate(place, "ONE", "--jobs", "1").exit_code == 0
    return contents(place / "ONE")


def test_two_processes_write_the_same_bytes_as_one(few: Path, one: dict[str, bytes]) -> None:
    assert generate(few, "TWO", "--jobs", "2").exit_code == 0
    assert contents(few / "TWO") == one


@pytest.mark.parametrize("count", [1, CHUNK, CHUNK + 1, 300, 1001])
@pytest.mark.parametrize("workers", [1, 2, 8])
def test_the_parts_are_the_class_and_become_smaller(count: int, workers: int) -> None:
    parts = list(split_class(count, workers))
    assert [place for part in parts for place in part] == list(range(count))
    sizes = list(map(len, parts))
    first, others = (sizes[:workers], sizes[workers:]) if workers > 1 else ([], sizes)
    assert others == sorted(others, reverse=True)
    assert [size for size in first if 2 * size > CHUNK] == []  # what binds them waits for these
    assert max(sizes) <= MOST
    assert [size for size in sizes[:-1] if 2 * size < CHUNK] == []
    assert workers > 1 or all(size >= CHUNK for size in sizes[:-1])


# Of a library: copies where there are none, else processes afresh
@pytest.mark.sampled(2, by="threads")
@pytest.mark.parametrize("threads", ["1", "2"])
def test_copies_of_a_process_without_threads_write_the_same_bytes(
    tmp_path: Path, one: dict[str, bytes], threads: str
) -> None:
    folder = write_few(tmp_path)
    program = tmp_path / "program.py"
    guarded = "if __name__ == '__main__':\n    from kinegrade.cli import main\n\n    main()\n"
    program.write_text(SMALL_PARTS + guarded, encoding="utf-8")
    command = [
        sys.executable,
        "-W",
        "error:This process:DeprecationWarning",
        str(program),
        "generate",
        "bank.toml",
        "roster.csv",
        "-o",
        "TWO",
        "--reproducible",
        "spring",
        "--allow-odd-ids",
        "--jobs",
        "2",
    ]
    subprocess.run(
        command,
        cwd=folder,
        check=True,
        capture_output=True,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join(sys.path),
            "OPENBLAS_NUM_THREADS": threads,
        },
    )
    assert contents(folder / "TWO") == one


@pytest.mark.left(beside="test_two_processes_write_the_same_bytes_as_one")
def test_versions_are_drawn_in_every_process_and_counted_once(few: Path) -> None:
    mistaken = '[[questions]]\ntemplate = "slider-crank"\n'
    (few / "bank.toml").write_text(f"versions = 3\n{BANK}{mistaken}", encoding="utf-8")
    assert generate(few, "ONE", "--jobs", "1").exit_code == 0
    assert generate(few, "TWO", "--jobs", "2").exit_code == 0
    assert "mistake" in (few / "ONE" / "exam.json").read_text(encoding="utf-8")
    assert contents(few / "TWO") == contents(few / "ONE")


def test_a_page_that_a_worker_cannot_typeset_is_told_as_ever(few: Path) -> None:
    (few / "crank.toml").write_text(
        crank_text(("above $O$.", r"above $\nonsense{O}$.")), encoding="utf-8"
    )
    lines = []
    for jobs in ("1", "2"):
        result = generate(few, "EXAM", "--jobs", jobs)
        assert result.exit_code == 2
        lines.append(result.stderr)
    assert lines[0] == lines[1]
    assert r"unknown command \nonsense" in lines[0]
    assert not list(few.glob(".*"))


@pytest.mark.left(beside="test_two_processes_write_the_same_bytes_as_one")
def test_no_two_papers_have_the_same_numbers_however_the_class_is_divided(few: Path) -> None:
    (few / "bank.toml").write_text(FEW, encoding="utf-8")
    said = []
    for jobs in ("1", "2"):
        result = generate(few, f"EXAM{jobs}", "--jobs", jobs)
        assert result.exit_code == 0
        said.append(result.stderr.splitlines()[:2])
    assert contents(few / "EXAM1") == contents(few / "EXAM2")
    assert said[0] == said[1]
    assert said[0][1] == "q1: dealt from 64 combinations of numbers"
    drawn = [json.dumps(line["questions"][0]["parameters"]) for line in key_lines(few / "EXAM2")]
    assert len(set(drawn)) == len(drawn) == 9


@pytest.mark.left(beside="test_a_question_of_which_nothing_is_good_is_refused_by_any_process")
def test_a_shortage_is_said_whoever_finds_it(few: Path) -> None:
    # 8 good ones for 9
    scarce = FEW.replace('omega = "1 .. 8 step 1"', "omega = [1, 20000000]")
    (few / "bank.toml").write_text(scarce, encoding="utf-8")
    results = [generate(few, f"EXAM{jobs}", "--jobs", jobs) for jobs in ("1", "2")]
    assert [result.exit_code for result in results] == [1, 1]
    one, two = (
        [line for line in result.stderr.splitlines() if line.startswith("complaint: ")]
        for result in results
    )
    assert one == two
    assert (
        "complaint: q1 (crank): 8 of the 16 combinations of values are fit for 9 students, so "
        "some have the same numbers - expected one for each - state more values in the question, "
        "as in draw = { r = [...] }, or write repeats = true in the question"
    ) in one
    assert contents(few / "EXAM1") == contents(few / "EXAM2")


def test_a_question_of_which_nothing_is_good_is_refused_by_any_process(few: Path) -> None:
    (few / "bank.toml").write_text(
        FEW.replace('omega = "1 .. 8 step 1"', "omega = [5000000]"), encoding="utf-8"
    )
    errors = {generate(few, "EXAM", "--jobs", jobs).stderr for jobs in ("1", "2")}
    (error,) = errors
    assert "q1 (crank): none of the 8 combinations of values is fit for students" in error
    assert not list(few.glob(".*"))


@pytest.mark.sampled(2, by="how")
@pytest.mark.skipif(
    not Path("/proc/self/task").exists(), reason="asks Linux for the children of a process"
)
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_whatever_ends_the_command_its_workers_end_with_it(
    folder: Path, how: signal.Signals
) -> None:
    command = [
        sys.executable,
        "-m",
        "kinegrade",
        "generate",
        "bank.toml",
        "roster.csv",
        "-o",
        "EXAM",
        "--jobs",
        "2",
    ]
    process = subprocess.Popen(
        command,
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    while process.poll() is None and not list(folder.glob(".*.partial-*/papers/*.pdf")):
        time.sleep(0.01)
    workers = children(process.pid)
    process.send_signal(how)
    process.wait()
    assert len(workers) >= 2
    assert gone(workers)
    assert not (folder / "EXAM").exists()
    assert how == signal.SIGKILL or not list(folder.glob(".*"))


def children(process: int) -> list[int]:
    return [
        int(number)
        for task in Path(f"/proc/{process}/task").iterdir()
        for number in (task / "children").read_text().split()
    ]


def gone(processes: list[int]) -> bool:
    """Whether all of them are gone, or only waited for, before long."""
    for _ in range(500):
        if not any(map(running, processes)):
            return True
        time.sleep(0.02)
    return False


def running(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False
