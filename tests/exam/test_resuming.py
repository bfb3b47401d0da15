"""A generate that is killed at any moment goes on with --resume, and the exam is byte for byte that
of a run that nobody killed.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.problem.crank import crank_text
from tests.small_class import contents, generate

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and process ids of POSIX")

COUNT = 41  # three parts of a class
BANK = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
"""
Moment = Callable[[Path], bool]  # of the unfinished folder: whether it is time


def write_files(folder: Path, count: int = COUNT) -> Path:
    """A bank with its template, and a roster of so many students."""
    digits = len(str(count - 1))
    students = "".join(f"{number:0{digits}},Student {number}\n" for number in range(count))
    (folder / "roster.csv").write_text(f"student,name\n{students}", encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def unbroken(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The exam of a run that nobody killed."""
    folder = write_files(tmp_path_factory.mktemp("unbroken"))
    if generate(folder).exit_code:
        raise RuntimeError("the exam cannot be generated")
    return contents(folder / "EXAM")


def unfinished(folder: Path) -> Path | None:
    """What a run is writing, or has left."""
    return next(folder.glob(".EXAM.partial-*"), None)


def interrupt(
    folder: Path, moment: Moment, *options: str, by: signal.Signals = signal.SIGKILL
) -> bool:
    """Generate, and end the process when it is time; whether it still ran then."""
    files = ["bank.toml", "roster.csv", "-o", "EXAM", "--jobs", "1"]
    process = subprocess.Popen(
        [sys.executable, "-m", "kinegrade", "generate", *files, *options],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    while process.poll() is None:
        partial = unfinished(folder)
        if partial is not None and moment(partial):
            process.send_signal(by)
            break
        time.sleep(0.002)
    return process.wait() != 0


def has(name: str) -> Moment:
    return lambda partial: (partial / name).exists()


def test_killed_again_and_again_it_ends_as_if_nothing_had_happened(
    unbroken: dict[str, bytes], tmp_path: Path
) -> None:
    folder, seed = write_files(tmp_path), ("--reproducible", "spring", "--resume")
    moments = "unfinished", "papers/24.pdf", "key.pdf"  # "resumed papers" of `make prove`: any
    assert [moment for moment in moments if not interrupt(folder, has(moment), *seed)] == []
    assert not (folder / "EXAM").exists()
    result = generate(folder, "EXAM", "--resume")
    assert result.exit_code == 0, result.stderr
    assert f"EXAM: {COUNT} papers were there from an earlier run" in result.stderr
    assert contents(folder / "EXAM") == unbroken
    assert unfinished(folder) is None


@pytest.mark.left(beside="test_killed_again_and_again_it_ends_as_if_nothing_had_happened")
def test_a_run_goes_on_with_the_secret_of_the_one_that_was_killed(tmp_path: Path) -> None:
    folder = write_files(tmp_path)
    assert interrupt(folder, has("papers/24.pdf"))
    partial = unfinished(folder)
    assert partial is not None
    begun = json.loads((partial / "unfinished" / "begun.json").read_text(encoding="utf-8"))
    first = (partial / "papers" / "00.pdf").read_bytes()
    assert partial.stat().st_mode & 0o077 == 0
    result = kinegrade_in(folder)
    assert result.returncode == 0, result.stderr
    head = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert {name: head[name] for name in ("secret", "label", "codes")} == begun["secret"]
    assert (folder / "EXAM" / "papers" / "00.pdf").read_bytes() == first


def kinegrade_in(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """Go on in that folder."""
    files = ["bank.toml", "roster.csv", "-o", "EXAM", "--jobs", "1", "--resume"]
    return subprocess.run(
        [sys.executable, "-m", "kinegrade", "generate", *files, *options],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )


@pytest.fixture(scope="module")
def killed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which a run was killed when some papers were there."""
    folder = write_files(tmp_path_factory.mktemp("killed"))
    if not interrupt(folder, has("papers/24.pdf"), "--reproducible", "spring"):
        raise RuntimeError("the run was over before it was killed")
    return folder


@pytest.fixture
def left(killed: Path, tmp_path: Path) -> Path:
    """A copy of that folder, to go on in."""
    return Path(shutil.copytree(killed, tmp_path / "left"))


def test_a_damaged_paper_and_a_damaged_line_are_made_again(
    left: Path, unbroken: dict[str, bytes]
) -> None:
    partial = unfinished(left)
    assert partial is not None
    (partial / "papers" / "05.pdf").write_bytes(b"half")
    (partial / "papers" / "06.pdf").unlink()
    journal = partial / "unfinished" / "papers.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    assert len(lines) >= 24
    lines[7] = lines[7].replace(b'"pages":', b'"pages":1')
    journal.write_bytes(b"".join(lines)[:-20])
    result = generate(left, "EXAM", "--resume")
    assert f"EXAM: {len(lines) - 4} papers were there" in result.stderr
    assert contents(left / "EXAM") == unbroken


def test_another_roster_bank_or_option_is_refused_and_nothing_is_lost(left: Path) -> None:
    roster = left / "roster.csv"
    text = roster.read_text(encoding="utf-8")
    roster.write_text(text + "new,New\n", encoding="utf-8")
    result = generate(left, "EXAM", "--resume", "--solutions")
    assert result.exit_code == 2
    partial = unfinished(left)
    assert result.stderr.splitlines()[-1].endswith(
        "was begun with other roster, options - expected the same as when it was begun - restore "
        "that, or leave out --resume to begin anew"
    )
    roster.write_text(text, encoding="utf-8")
    assert partial is not None
    assert "were there" in generate(left, "EXAM", "--resume").stderr


def test_an_order_that_cannot_be_read_is_refused(left: Path) -> None:
    partial = unfinished(left)
    assert partial is not None
    (partial / "unfinished" / "begun.json").write_text("{}", encoding="utf-8")
    result = generate(left, "EXAM", "--resume")
    assert result.exit_code == 2
    assert "does not say how the unfinished exam was begun" in result.stderr
    assert generate(left).exit_code == 0


def test_other_commands_refuse_an_unfinished_exam(left: Path, tmp_path: Path) -> None:
    from tests.small_class import kinegrade

    partial = unfinished(left)
    assert partial is not None
    shutil.copytree(partial, copy := tmp_path / "COPY")
    result = kinegrade("grade", copy, copy / "answers.csv", "-o", tmp_path / "MARKS")
    assert result.exit_code == 2
    assert result.stderr.splitlines()[-1] == (
        f"error: {copy}: is unfinished: generate was interrupted as it wrote this folder - "
        "expected the folder of a whole exam - generate it again with --resume, which goes on "
        "where it stopped"
    )


def test_what_another_process_may_be_writing_is_left_alone(left: Path) -> None:
    partial = unfinished(left)
    assert partial is not None
    mine = partial.rename(left / f".EXAM.partial-another_machine-{os.getpid()}-00000000")
    result = generate(left, "EXAM", "--resume")
    assert result.exit_code == 2
    assert f"may be being written by another process ({mine.name})" in result.stderr
    assert mine.is_dir()


@pytest.mark.left(beside="test_killed_again_and_again_it_ends_as_if_nothing_had_happened")
def test_a_folder_that_is_replaced_is_gone_on_with_too(
    unbroken: dict[str, bytes], tmp_path: Path
) -> None:
    folder, again = write_files(tmp_path), ("--force", "--resume")
    assert generate(folder).exit_code == 0
    assert interrupt(folder, has("papers/24.pdf"), "--reproducible", "spring", *again)
    result = generate(folder, "EXAM", *again)
    assert "were there" in result.stderr
    assert result.exit_code == 0
    assert contents(folder / "EXAM") == unbroken


@pytest.mark.left(beside="test_killed_again_and_again_it_ends_as_if_nothing_had_happened")
def test_papers_with_solutions_and_sources_are_taken_over(tmp_path: Path) -> None:
    folder, options = write_files(tmp_path, 25), ("--solutions", "--also", "html")
    assert generate(folder, "WHOLE", *options).exit_code == 0
    made = ("--reproducible", "spring", *options)
    assert interrupt(folder, has("solutions/12.pdf"), *made)
    assert "were there" in generate(folder, "EXAM", "--resume", *options).stderr
    assert contents(folder / "EXAM") == contents(folder / "WHOLE")


@pytest.mark.left(beside="test_killed_again_and_again_it_ends_as_if_nothing_had_happened")
def test_with_resume_an_interrupted_run_leaves_what_it_has_done(
    unbroken: dict[str, bytes], tmp_path: Path
) -> None:
    folder, seed = write_files(tmp_path), ("--reproducible", "spring")
    assert interrupt(folder, has("papers/24.pdf"), *seed, by=signal.SIGTERM)
    assert unfinished(folder) is None
    assert interrupt(folder, has("papers/24.pdf"), *seed, "--resume", by=signal.SIGTERM)
    assert unfinished(folder) is not None
    assert "were there" in generate(folder, "EXAM", "--resume").stderr
    assert contents(folder / "EXAM") == unbroken
