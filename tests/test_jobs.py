"""The commands that work by several processes give the same bytes whatever their number, and end
in one line where a process is ended from outside.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.problem.crank import crank_text
from tests.small_class import contents, generate, kinegrade

COUNT = 41  # three parts of a class
BANK = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
"""


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS of a class that is large enough for several processes."""
    folder = tmp_path_factory.mktemp("jobs")
    students = "".join(f"{number},Student {number}\n" for number in range(COUNT))
    (folder / "roster.csv").write_text(f"student,name\n{students}", encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    if generate(folder, "EXAM").exit_code:
        raise RuntimeError("the exam cannot be generated")
    answers = folder / "EXAM" / "answers.csv"
    if kinegrade("grade", folder / "EXAM", answers, "-o", folder / "MARKS").exit_code:
        raise RuntimeError("the exam cannot be marked")
    return folder


@pytest.mark.sampled(3, by="form")
@pytest.mark.parametrize("form", ["pdf", "html", "md"])
def test_feedback_is_the_same_by_several_processes(marked: Path, tmp_path: Path, form: str) -> None:
    for jobs in ("1", "2"):
        named = (marked / "EXAM", marked / "MARKS", "-o", tmp_path / jobs)
        result = kinegrade("feedback", *named, "--format", form, "--jobs", jobs)
        assert result.exit_code == 0, result.stderr
    assert contents(tmp_path / "1") == contents(tmp_path / "2")
    assert len(list((tmp_path / "2" / "sheets").iterdir())) == COUNT


@pytest.mark.sampled(2, by="system")
@pytest.mark.parametrize("system", ["moodle-xml", "qti21"])
def test_a_quiz_is_the_same_by_several_processes(marked: Path, tmp_path: Path, system: str) -> None:
    for jobs in ("1", "2"):
        wanted = ("--to", system, "-o", tmp_path / jobs, "--jobs", jobs)
        assert kinegrade("quiz", marked / "EXAM", *wanted).exit_code in (0, 1)
    assert (tmp_path / "1").read_bytes() == (tmp_path / "2").read_bytes()


@pytest.mark.left(beside="test_check_refuses_a_template_after_what_it_says_of_those_before")
def test_check_says_the_same_by_several_processes(marked: Path) -> None:
    names = (marked / "crank.toml", "slider-crank", marked / "crank.toml")
    one, two = (
        kinegrade("check", *names, "--sample", "2", "--jobs", jobs).stdout for jobs in ("1", "2")
    )
    verdicts = [line.split(":")[0] for line in one.splitlines() if not line.startswith("  ")]
    assert verdicts == ["crank", "slider-crank", "crank"]
    assert re.sub(r"[0-9.]+ ms each", "", one) == re.sub(r"[0-9.]+ ms each", "", two)


def test_check_refuses_a_template_after_what_it_says_of_those_before(marked: Path) -> None:
    names = (marked / "crank.toml", "no-such-template", "slider-crank")
    for jobs in ("1", "2"):
        result = kinegrade("check", *names, "--sample", "2", "--jobs", jobs)
        assert result.exit_code == 2
        assert result.stdout.startswith("crank: ")
        assert "slider-crank" not in result.stdout
        assert 'no template "no-such-template"' in result.stderr


@pytest.mark.sampled(2, by="command")
@pytest.mark.skipif(
    not Path("/proc/self/task").exists(), reason="asks Linux for the children of a process"
)
@pytest.mark.parametrize("command", ["generate", "feedback"])
def test_a_process_that_is_killed_is_one_line_and_nothing_is_written(
    marked: Path, tmp_path: Path, command: str
) -> None:
    named = {
        "generate": ("bank.toml", "roster.csv"),
        "feedback": ("EXAM", "MARKS"),
    }
    program = (sys.executable, "-m", "kinegrade")
    process = subprocess.Popen(
        [*program, command, *named[command], "-o", str(tmp_path / "OUT"), "--jobs", "2"],
        cwd=marked,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    while process.poll() is None and len(workers_of(process.pid)) < 2:
        time.sleep(0.01)
    os.kill(workers_of(process.pid)[-1], signal.SIGKILL)
    said = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 2
    assert said.splitlines()[-1] == (
        f"error: {command}: a process was ended from outside - expected room in memory for all "
        "of them - use fewer: --jobs 1"
    )
    assert not list(tmp_path.iterdir())


def workers_of(process: int) -> list[int]:
    """The processes that work for this one, without the one that only watches over resources."""
    children = [
        int(number)
        for task in Path(f"/proc/{process}/task").glob("*/children")
        for number in task.read_text().split()
    ]
    return [number for number in children if b"resource_tracker" not in command_line(number)]


def command_line(process: int) -> bytes:
    """How a process was started."""
    return Path(f"/proc/{process}/cmdline").read_bytes()
