"""Work for other processes: in order, bounded, the same for every way of starting them, and nobody
is left at work.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from multiprocessing import active_children
from pathlib import Path

import pytest

from kinegrade.errors import TemplateError, WorkerError
from kinegrade.processes.executor import Shared, Start, map_in_order, open_executor

WAYS: list[tuple[int, Start | None]] = [(1, None), (2, None), (2, "fork"), (2, "spawn")]
every_way = pytest.mark.parametrize(("jobs", "start"), WAYS)
linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells of threads")


def late_if_even(number: int) -> int:
    """A number, the even ones later than the odd ones after them."""
    time.sleep(0.05 if number % 2 == 0 else 0)
    return number


def refuse(number: int) -> int:
    """Refuses 3, with two problems."""
    if number == 3:
        raise TemplateError("three: is odd", "three: is prime")
    return number


def kill_this_process(number: int) -> int:
    """Ends the process that does this task, without a word."""
    os.kill(os.getpid(), signal.SIGKILL)
    return number


def end_this_process(number: int) -> int:
    """Ends the process that does this task, as `kill` does where no signal is named."""
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(60)
    return number


def process_of(number: int) -> int:
    """Which process does this task."""
    return os.getpid()


def sleep_long(number: int) -> None:
    """Works for longer than any test waits."""
    time.sleep(60)


def visits(shared: Shared[list[int]]) -> tuple[int, int]:
    """The process, and how many tasks with this value it has done."""
    shared.value.append(0)
    return os.getpid(), len(shared.value)


@every_way
def test_results_come_in_order(jobs: int, start: Start | None) -> None:
    with open_executor(jobs, "test", start) as workers:
        assert list(map_in_order(workers, late_if_even, range(9), 4)) == list(range(9))
    assert not active_children()


def test_any_executor_will_do() -> None:
    with ThreadPoolExecutor(2) as workers:
        assert list(map_in_order(workers, late_if_even, range(9), 4)) == list(range(9))


@pytest.mark.parametrize("count", [0, 1])
def test_a_single_item_is_not_worth_another_process(count: int) -> None:
    with open_executor(2, "test") as workers:
        assert list(map_in_order(workers, process_of, range(count), 4)) == [os.getpid()] * count
        assert not active_children()


def test_one_job_is_this_process_which_works_when_a_result_is_asked_for() -> None:
    taken: list[int] = []

    def note(number: int) -> int:
        taken.append(number)
        return number

    with open_executor(1, "test") as workers:
        results = map_in_order(workers, note, range(9), 4)
        assert not taken
        assert [next(results), next(results)] == [0, 1]
        assert taken == [0, 1]


@every_way
def test_a_bounded_number_of_tasks_is_under_way(jobs: int, start: Start | None) -> None:
    asked: list[int] = []

    def items() -> Iterator[int]:
        for number in range(40):
            asked.append(number)
            yield number

    with open_executor(jobs, "test", start) as workers:
        for number, result in enumerate(map_in_order(workers, late_if_even, items(), 3)):
            assert result == number
            assert len(asked) <= number + 3
    assert len(asked) == 40


@every_way
def test_what_a_task_raises_is_raised_with_all_its_problems(jobs: int, start: Start | None) -> None:
    done: list[int] = []
    with (
        pytest.raises(TemplateError) as raised,
        open_executor(jobs, "test", start) as workers,
    ):
        done += map_in_order(workers, refuse, range(9), 4)
    assert raised.value.problems == ("three: is odd", "three: is prime")
    assert not active_children()


@pytest.mark.parametrize("end", [kill_this_process, end_this_process])
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_a_process_ended_from_outside_is_one_line_that_names_the_command(
    start: Start, end: Callable[[int], int]
) -> None:
    with (
        pytest.raises(WorkerError) as raised,
        open_executor(2, "check", start) as workers,
    ):
        list(map_in_order(workers, end, range(9), 4))
    assert raised.value.problems == (
        "check: a process was ended from outside - expected room in memory for all of them - "
        "use fewer: --jobs 1",
    )
    assert not active_children()


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_results_that_are_no_longer_wanted_leave_no_process(start: Start) -> None:
    with open_executor(2, "test", start) as workers:
        results = map_in_order(workers, late_if_even, range(1000), 4)
        assert next(results) == 0
        results.close()
    assert not active_children()


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_an_exception_does_not_wait_for_tasks_under_way(start: Start) -> None:
    begin = time.monotonic()
    with pytest.raises(KeyError, match="while they sleep"):
        fail_at_work(start)
    assert time.monotonic() - begin < 20
    assert not active_children()


def fail_at_work(start: Start) -> None:
    """Raises KeyError while both processes are at long tasks."""
    with open_executor(2, "test", start) as workers:
        tasks = [workers.submit(sleep_long, number) for number in range(2)]
        while not all(task.running() for task in tasks):
            time.sleep(0.01)
        raise KeyError("while they sleep")


def test_processes_of_others_are_not_dismissed() -> None:
    with open_executor(2, "test") as others:
        first = others.submit(process_of, 1).result()
        with pytest.raises(KeyError, match="while they sleep"):
            fail_at_work("fork")
        assert first in [process.pid for process in active_children()]
        assert others.submit(late_if_even, 1).result() == 1


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_what_all_tasks_share_is_unpickled_once_by_a_process(start: Start) -> None:
    shared: Shared[list[int]] = Shared([])
    with open_executor(2, "test", start) as workers:
        seen = list(map_in_order(workers, visits, [shared] * 40, 4))
    assert not shared.value
    for process in {process for process, _ in seen}:
        counts = [count for each, count in seen if each == process]
        assert sorted(counts) == list(range(1, len(counts) + 1))


def test_what_all_tasks_share_is_not_copied_for_this_process() -> None:
    shared: Shared[list[int]] = Shared([])
    with open_executor(1, "test") as workers:
        assert list(map_in_order(workers, visits, [shared] * 2, 4)) == [
            (os.getpid(), 1),
            (os.getpid(), 2),
        ]
    assert len(shared.value) == 2


STARTS = """
import threading
from multiprocessing import active_children
from kinegrade.processes.executor import open_executor
{before}
if __name__ == "__main__":
    with open_executor(2, "test") as workers:
        workers.submit(abs, 1).result()
        print(sorted({{type(process).__name__ for process in active_children()}}))
"""


@linux
@pytest.mark.parametrize(
    ("before", "kind"),
    [("", "ForkProcess"), ("threading.Timer(1, int).start()", "SpawnProcess")],
)
def test_processes_are_copies_of_one_that_surely_has_no_other_thread(
    before: str, kind: str, tmp_path: Path
) -> None:
    program = tmp_path / "program.py"
    program.write_text(STARTS.format(before=before), encoding="utf-8")
    answer = subprocess.run(
        [sys.executable, str(program)],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert answer.stdout == f"['{kind}']\n"


@linux
def test_what_generate_loads_and_a_press_at_rest_start_no_thread() -> None:
    program = (
        "import os, kinegrade.exam.generating.generate; from kinegrade.press.typst.press import TypstPress; press = "
        "TypstPress(); print(len(os.listdir('/proc/self/task')))"
    )
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(sys.path),
        "OPENBLAS_NUM_THREADS": "1",
    }
    answer = subprocess.run(
        [sys.executable, "-c", program], check=True, capture_output=True, env=environment
    )
    assert answer.stdout.split() == [b"1"]


ENDED_AT_ITS_START = """
import os
import signal

signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])
os.kill(os.getpid(), signal.SIGTERM)

from kinegrade.processes.worker import begin_work

begin_work()
print("at work")
"""


@linux
def test_a_process_that_is_ended_while_it_starts_says_nothing() -> None:
    command = [sys.executable, "-c", ENDED_AT_ITS_START]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (ended.stdout, ended.stderr, ended.returncode) == ("", "", -signal.SIGTERM)


INTERRUPTED_WHILE_RESULTS_COME = """
import sys
import time

from kinegrade.processes.executor import map_in_order, open_executor

for delay in range(8):
    try:
        with open_executor(2, "test", "fork") as workers:
            results = map_in_order(workers, bytes, [30_000_000] * 1000)
            next(results)
            time.sleep(delay / 100)
            raise KeyError
    except KeyError:
        sys.stdout.write("ended ")
"""


@linux
def test_a_process_that_is_killed_while_it_sends_a_result_is_not_waited_for() -> None:
    """Half a result stood in the pipe, and the pool waited for the other half for ever."""
    command = [sys.executable, "-c", INTERRUPTED_WHILE_RESULTS_COME]
    ended = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert (ended.stdout, ended.stderr, ended.returncode) == ("ended " * 8, "", 0)
