"""The commands give the same bytes by a cluster as by one process, though a worker is killed in the
middle: with a real scheduler and real workers.
"""

from __future__ import annotations

import pickle
import shutil
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from kinegrade.errors import InstallationError, KinegradeError, WorkerError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.printing.class_reprint import print_class_again
from kinegrade.exam.printing.class_solutions import print_class_solutions
from kinegrade.exam.printing.reprint import kept_run
from kinegrade.exam.quiz.paper import QuizWishes
from kinegrade.exam.quiz.quiz import read_quiz
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.processes import cluster as module
from kinegrade.processes.cluster import do_packed
from kinegrade.processes.executor import map_in_order, open_executor
from tests.problem.crank import crank_text
from tests.processes.clusters import ENVIRONMENT, Cluster, count_workers, wait_until
from tests.small_class import contents, generate, kinegrade

pytestmark = pytest.mark.xdist_group("cluster")  # one scheduler for all
COUNT = 61  # four parts of a class
BANK = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = "0 .. 10 step 1", omega = "1 .. 40 step 1" }
"""


@pytest.fixture(scope="module")
def scheduler(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    """A scheduler."""
    found = Cluster(tmp_path_factory.mktemp("cluster"))
    yield found
    found.end()


@pytest.fixture(scope="module")
def workers(scheduler: Cluster) -> Cluster:
    """A scheduler with two workers."""
    for _ in range(2):
        scheduler.add_worker()
    wait_until(lambda: count_workers(scheduler.address) == 2)
    return scheduler


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS."""
    folder = tmp_path_factory.mktemp("course")
    students = "".join(f"{number:02},Student {number}\n" for number in range(COUNT))
    (folder / "roster.csv").write_text(f"student,name\n{students}", encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    if generate(folder, "EXAM", "--jobs", "1").exit_code:
        raise RuntimeError("the exam cannot be generated")
    answers = folder / "EXAM" / "answers.csv"
    if kinegrade("grade", folder / "EXAM", answers, "-o", folder / "MARKS").exit_code:
        raise RuntimeError("the exam cannot be marked")
    return folder


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_a_scheduler_without_workers_is_refused(scheduler: Cluster) -> None:
    with pytest.raises(WorkerError) as raised, open_executor(1, "check", cluster=scheduler.address):
        pass
    assert raised.value.problems == (
        f"{scheduler.address}: the scheduler has no workers - start workers where this version of "
        "kinegrade is installed: dask worker ADDRESS",
    )


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_an_exam_is_the_same_though_a_worker_is_killed(
    workers: Cluster, course: Path, tmp_path: Path
) -> None:
    extra = workers.add_worker()
    wait_until(lambda: count_workers(workers.address) == 3)
    files = [str(course / "bank.toml"), str(course / "roster.csv"), "-o", "EXAM"]
    wishes = ["--reproducible", "spring", "--allow-odd-ids", "--cluster", workers.address]
    process = subprocess.Popen(
        [sys.executable, "-m", "kinegrade", "generate", *files, *wishes],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        env=ENVIRONMENT,
    )
    wait_until(lambda: any(tmp_path.glob(".EXAM.partial-*/papers")) or process.poll() is not None)
    assert process.poll() is None
    extra.kill()
    said = process.communicate(timeout=120)[1].decode()
    assert process.returncode == 0, said
    assert contents(tmp_path / "EXAM") == contents(course / "EXAM")


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_solutions_are_the_same(workers: Cluster, course: Path, tmp_path: Path) -> None:
    folders = tmp_path / "1", tmp_path / "2"
    for folder, wishes in zip(folders, ((), ("--cluster", workers.address)), strict=True):
        shutil.copytree(course / "EXAM", folder)
        result = kinegrade("solutions", folder, "--jobs", "1", *wishes)
        assert result.exit_code == 0, result.stderr
    assert contents(folders[0]) == contents(folders[1])


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_feedback_is_the_same(workers: Cluster, course: Path, tmp_path: Path) -> None:
    named = ("feedback", course / "EXAM", course / "MARKS", "--format", "pdf", "--jobs", "1")
    assert kinegrade(*named, "-o", tmp_path / "1").exit_code == 0
    assert kinegrade(*named, "-o", tmp_path / "2", "--cluster", workers.address).exit_code == 0
    assert contents(tmp_path / "1") == contents(tmp_path / "2")


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_a_quiz_is_the_same(workers: Cluster, course: Path, tmp_path: Path) -> None:
    named = ("quiz", course / "EXAM", "--to", "moodle-xml", "--solutions", "--jobs", "1")
    assert kinegrade(*named, "-o", tmp_path / "1.xml").exit_code in (0, 1)
    again = kinegrade(*named, "-o", tmp_path / "2.xml", "--cluster", workers.address)
    assert again.exit_code in (0, 1)
    assert (tmp_path / "1.xml").read_bytes() == (tmp_path / "2.xml").read_bytes()


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_check_refuses_what_this_machine_cannot_read(workers: Cluster, course: Path) -> None:
    names = (course / "crank.toml", course / "crank.toml", "no-such-template")
    result = kinegrade("check", *names, "--sample", "2", "--cluster", workers.address)
    assert result.exit_code == 2
    assert result.stdout.count("crank: ") == 2
    assert 'no template "no-such-template"' in result.stderr


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_a_worker_of_another_version_is_refused(
    workers: Cluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "__version__", "0.0")
    with pytest.raises(WorkerError) as raised, open_executor(1, "check", cluster=workers.address):
        pass
    assert "does not have kinegrade 0.0 - start workers where" in raised.value.problems[0]


@pytest.mark.left(beside="test_no_task_needs_the_exam_folder")
def test_results_are_bounded_on_the_way(workers: Cluster) -> None:
    asked: list[int] = []

    def items() -> Iterator[int]:
        for number in range(40):
            asked.append(number)
            yield number

    with open_executor(1, "test", cluster=workers.address) as others:
        for number, result in enumerate(map_in_order(others, abs, items(), 1)):
            assert result == number
            assert len(asked) <= number + 6


def test_an_encrypted_connection_needs_certificates() -> None:
    address = "tls://127.0.0.1:1"
    with pytest.raises(WorkerError) as raised, open_executor(1, "check", cluster=address):
        pass
    assert raised.value.problems == (
        f"{address}: no certificates are known here for it - expected ca-file, cert and key under "
        "distributed.comm.tls in the settings of Dask - set them, or let the network protect the "
        "connection and use tcp://",
    )


def test_no_scheduler_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PATIENCE", 1)
    address = "tcp://127.0.0.1:1"
    with pytest.raises(WorkerError) as raised, open_executor(1, "check", cluster=address):
        pass
    assert raised.value.problems[0].startswith(f"{address}: no scheduler answers (")
    assert raised.value.problems[0].endswith(
        "expected the address of a scheduler of Dask, as in tcp://host:8786 - start it by: dask "
        "scheduler"
    )


def test_without_the_extra_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InstallationError) as raised, open_executor(1, "check", cluster="tcp://a:1"):
        pass
    assert raised.value.problems == (
        "--cluster: what a cluster needs is not installed - install it by: pip install "
        "'kinegrade[cluster]'",
    )


class Elsewhere(Executor):
    """Does each task where the exam folder is not, and gets nothing but its bytes."""

    def __init__(self, exam: Path) -> None:
        self._exam = exam

    def submit(self, task: Any, /, *given: Any, **named: Any) -> Future[Any]:
        packed = pickle.dumps(partial(task, *given, **named))
        away = self._exam.rename(self._exam.with_name("AWAY"))
        sound, result = pickle.loads(do_packed(packed))
        away.rename(self._exam)
        future: Future[Any] = Future()
        assert sound, result
        future.set_result(result)
        return future


def test_no_task_needs_the_exam_folder(course: Path, tmp_path: Path) -> None:
    place = Path(shutil.copytree(course / "EXAM", tmp_path / "EXAM"))
    exam = open_exam(place)
    run = kept_run(exam, KeptExam(exam), solutions=True)
    elsewhere = Elsewhere(place)
    printed = print_class_solutions(exam, run, exam.head.students, elsewhere, 1)
    assert len(list(printed)) == COUNT
    assert len(list(print_class_again(KeptExam(exam), run, elsewhere, 1))) == COUNT
    wishes = QuizWishes(solutions=True)
    assert len(list(read_quiz(exam, wishes=wishes, workers=elsewhere).papers)) == COUNT


class Losing(Executor):
    """Loses every task."""

    def submit(self, task: object, /, *given: object, **named: object) -> Future[bytes]:  # type: ignore[override]
        from distributed import KilledWorker  # as in clusters.py

        future: Future[bytes] = Future()
        future.set_exception(KilledWorker("task", SimpleNamespace(address="a"), 3))  # type: ignore[no-untyped-call]
        return future


def test_a_part_that_is_lost_again_and_again_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    client = SimpleNamespace(
        get_executor=lambda pure: Losing(),
        nthreads=lambda: {"a": 1},
        run=lambda asked: {"a": asked()},
    )

    @contextmanager
    def connect(address: str) -> Iterator[SimpleNamespace]:
        yield client

    monkeypatch.setattr(module, "_connect", connect)
    with (
        pytest.raises(KinegradeError) as raised,
        open_executor(1, "quiz", cluster="tcp://a:1") as w,
    ):
        list(map_in_order(w, abs, range(3)))
    assert raised.value.problems == (
        "quiz: the cluster has lost a part of the work again and again - look at the logs of its "
        "workers: each needs memory for one part, and the scheduler has to run until the end",
    )
