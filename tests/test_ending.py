"""How a run ends: by itself, by a signal, by a closed pipe, by a crash; nothing half-written,
nobody left at work.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.problem.crank import crank_text

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
PROMPT = 1.0  # seconds in which an interruption is obeyed
SLACK = 1.5  # seconds more, for a machine that does other things meanwhile
BANK = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
"""
CRASHING = """
import click
from kinegrade.cli.running.program import Program

@click.group(cls=Program)
def main(): pass

@main.command()
@click.option("--seed")
@click.argument("roster")
def fall(seed, roster):
    raise {fault}

main()
"""


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """A folder with a bank and a class that is large enough for two processes, and room for
    temporary files.
    """
    students = "".join(f"{number},Student {number}\n" for number in range(42))
    (tmp_path / "roster.csv").write_text(f"student,name\n{students}", encoding="utf-8")
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "crank.toml").write_text(crank_text(), encoding="utf-8")
    (tmp_path / "temporary").mkdir()
    return tmp_path


def started(room: Path, *command: str) -> subprocess.Popen[bytes]:
    """Python with these arguments, in a process group of its own as a terminal makes one."""
    return subprocess.Popen(
        [sys.executable, *command],
        cwd=room,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join(sys.path),
            "TMPDIR": str(room / "temporary"),
        },
    )


def generating(room: Path, *options: str) -> subprocess.Popen[bytes]:
    """`kinegrade generate` for the class in the room."""
    files = ("bank.toml", "roster.csv", "-o", "EXAM")
    return started(room, "-m", "kinegrade", "generate", *files, *options)


def wait_for(moment: Callable[[], bool], process: subprocess.Popen[bytes]) -> None:
    """Until it is time; the process must still run then."""
    until = time.monotonic() + 60
    while not moment():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < until
        time.sleep(0.01)


def at_work(group: int) -> list[str]:
    """The states of the processes in a group, without those that have ended and wait to be
    noticed.
    """
    listing = subprocess.run(
        ["ps", "-A", "-o", "pgid=,stat="], check=True, capture_output=True, text=True
    )
    lines = map(str.split, listing.stdout.splitlines())
    return [state for number, state in lines if int(number) == group and state[0] != "Z"]


def found(room: Path, pattern: str) -> Callable[[], bool]:
    """Whether a file of that pattern stands in the room."""
    return lambda: any(room.glob(pattern))


LEFT = pytest.mark.left(beside="test_a_run_that_is_ended_from_outside_leaves_nothing")
MOMENTS = [
    pytest.param(("--jobs", "1"), ".EXAM.partial-*/papers/*.pdf", id="one-process"),
    pytest.param(("--jobs", "2"), ".EXAM.partial-*", id="workers-begin", marks=LEFT),
    pytest.param(("--jobs", "2"), ".EXAM.partial-*/papers/*.pdf", id="workers-print"),
    pytest.param(
        ("--jobs", "1", "--engine", "latex"),
        "temporary/*/pages.tex",
        id="latex",
        marks=[pytest.mark.needs_tex, LEFT],
    ),
    pytest.param(
        ("--jobs", "2", "--engine", "latex"),
        "temporary/*/pages.tex",
        id="latex-of-workers",
        marks=[pytest.mark.needs_tex, LEFT],
    ),
    pytest.param(
        ("--jobs", "1", "--also", "docx"),
        "temporary/*/reference.docx",
        id="pandoc",
        marks=LEFT,
    ),
]


@pytest.mark.parametrize(("options", "moment"), MOMENTS)
def test_ctrl_c_ends_a_run_at_once_and_leaves_nothing(
    room: Path, options: tuple[str, ...], moment: str
) -> None:
    process = generating(room, *options)
    wait_for(found(room, moment), process)
    begin = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    assert_ended(process, room, signal.SIGINT, begin)


@pytest.mark.parametrize(("options", "moment"), [MOMENTS[0], MOMENTS[2]])
def test_a_run_that_is_ended_from_outside_leaves_nothing(
    room: Path, options: tuple[str, ...], moment: str
) -> None:
    process = generating(room, *options)
    wait_for(found(room, moment), process)
    begin = time.monotonic()
    process.terminate()
    assert_ended(process, room, signal.SIGTERM, begin)


def assert_ended(
    process: subprocess.Popen[bytes], room: Path, number: signal.Signals, begin: float
) -> None:
    """It ended soon, by that signal, said so in one line, and nothing and nobody is left of it."""
    said = process.communicate(timeout=60)[1].decode()
    assert time.monotonic() - begin < PROMPT + SLACK
    assert process.returncode == 128 + number
    assert said.splitlines()[-1].endswith(f" by {number.name}")
    assert "Traceback" not in said
    assert not at_work(process.pid)
    assert not list((room / "temporary").iterdir())
    assert not [entry.name for entry in room.iterdir() if "EXAM" in entry.name]


def test_ctrl_c_while_the_program_is_loaded_is_no_traceback(room: Path) -> None:
    program = (
        "import signal, sys\n"
        "class Interrupting:\n"
        "    def find_spec(self, name, path, target=None):\n"
        "        if name == 'kinegrade.cli.marks': signal.raise_signal(signal.SIGINT)\n"
        "sys.meta_path.insert(0, Interrupting())\n"
        "from kinegrade.__main__ import start\n"
        "start()\n"
    )
    process = started(room, "-c", program, "list")
    assert process.communicate(timeout=60)[1] == b""
    assert process.returncode == 130


def test_a_reader_that_closes_the_pipe_hears_nothing(room: Path) -> None:
    process = started(room, "-m", "kinegrade", "show", "slider-crank")
    assert process.stdout is not None
    process.stdout.close()
    assert process.stderr is not None
    assert process.stderr.read() == b""
    assert process.wait() == 128 + 13


def test_help_for_a_closed_pipe_is_silent_too(room: Path) -> None:
    process = started(room, "-m", "kinegrade", "--help")
    assert process.stdout is not None
    process.stdout.close()
    assert process.stderr is not None
    assert process.stderr.read() == b""
    assert process.wait() == 128 + 13


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_a_closed_standard_output_is_no_crash(room: Path, closed: str) -> None:
    """As under some job runners: what a command writes into a file is written all the same."""
    command = f'"{sys.executable}" -m kinegrade new mine -o mine.toml {closed}'
    assert subprocess.run(["sh", "-c", command], cwd=room, check=False).returncode == 0
    assert (room / "mine.toml").exists()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="Linux has a full device")
@pytest.mark.parametrize("asked", ["list", "--help"])
def test_a_full_disk_behind_standard_output_is_one_line(room: Path, asked: str) -> None:
    with Path("/dev/full").open("wb") as full:
        process = subprocess.run(
            [sys.executable, "-m", "kinegrade", asked],
            cwd=room,
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        )
    assert process.returncode == 2
    assert process.stderr.decode() == (
        "error: standard output: cannot be written (No space left on device) - expected a place "
        "with room - send it elsewhere\n"
    )


@pytest.mark.parametrize("fault", ["ValueError('王伟 has 0.5')", "EOFError()", "OSError('x')"])
def test_a_crash_is_no_complaint_and_its_report_holds_no_names(room: Path, fault: str) -> None:
    program = CRASHING.format(fault=fault)
    process = started(room, "-c", program, "fall", "--seed=secret", "class-7.csv")
    said = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 70
    assert said.startswith(f"crash: {fault.split('(', maxsplit=1)[0]}")
    assert said.count("\n") == 1
    [report] = (room / "temporary").iterdir()
    assert str(report) in said
    text = report.read_text(encoding="utf-8")
    assert "command: fall --seed .\n" in text
    assert "line 12, in fall" in text
    assert not [word for word in ("王伟", "0.5", "secret", "class-7") if word in text]


def test_a_crash_without_room_for_a_report_is_still_one_line(room: Path) -> None:
    program = (
        f"import tempfile; tempfile.tempdir = 'nowhere'\n{CRASHING.format(fault='KeyError(1)')}"
    )
    process = started(room, "-c", program, "fall", "class.csv")
    assert process.communicate(timeout=60)[1].decode() == (
        "crash: KeyError: 1 - this is a fault of kinegrade - no report could be written (No such "
        "file or directory)\n"
    )
    assert process.returncode == 70


def test_the_report_of_a_crash_in_a_worker_says_where_in_the_worker(room: Path) -> None:
    program = (
        "import click\nfrom functools import partial\n"
        "from kinegrade.cli.running.program import Program\nfrom kinegrade.processes.executor import open_executor\n"
        "@click.group(cls=Program)\ndef main(): pass\n"
        "@main.command()\ndef fall():\n"
        "    with open_executor(2, 'fall', 'fork') as others:\n"
        "        others.submit(int, 'a name').result()\n"
        "main()\n"
    )
    process = started(room, "-c", program, "fall")
    said = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 70
    [report] = (room / "temporary").iterdir()
    assert str(report) in said
    text = report.read_text(encoding="utf-8")
    assert "_process_worker" in text
    assert "a name" not in text


def test_the_next_run_clears_the_temporary_folders_of_killed_ones(room: Path) -> None:
    making = (
        "import time; from kinegrade.files.temporary import temporary_folder\n"
        "with temporary_folder() as folder:\n"
        "    (folder / 'figures').mkdir()\n"
        "    print(folder, flush=True)\n"
        "    {then}\n"
    )
    first = started(room, "-c", making.format(then="time.sleep(60)"))
    second = started(room, "-c", making.format(then="time.sleep(60)"))
    assert first.stdout is not None
    assert second.stdout is not None
    left = Path(first.stdout.readline().decode().strip())
    used = Path(second.stdout.readline().decode().strip())
    first.kill()
    first.communicate()
    assert (left / "figures").exists()
    third = started(room, "-c", making.format(then="pass"))
    assert third.communicate(timeout=60)[1] == b""
    assert not left.exists()
    assert used.exists()
    second.kill()
    second.communicate()


def test_no_room_for_a_temporary_folder_is_one_line(room: Path) -> None:
    (room / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    process = started(
        room,
        "-c",
        "import tempfile; tempfile.tempdir = 'nowhere'\nfrom kinegrade.cli import main\nmain()",
        *("generate", "bank.toml", "roster.csv", "-o", "EXAM", "--also", "docx"),
    )
    said = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 2
    assert "nowhere: no temporary folder can be made (No such file or directory)" in said
