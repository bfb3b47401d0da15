"""A signal does not interrupt the loading of a module: one that is not written in Python reports
that as a crash, with lines that nobody asked for.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

# it asks for its own end, as Ctrl-C would while it is loaded, and says what became of it
MODULE = """
import os, signal, time

try:
    os.kill(os.getpid(), signal.{name})
    time.sleep(0.1)
    print("loaded", flush=True)
except BaseException:
    print("interrupted", flush=True)
    raise
"""
COMMAND = """
import time
from kinegrade.cli.running.signals import Signalled, signals_obeyed

try:
    with signals_obeyed():
        import slowly
        time.sleep(60)
except Signalled as ending:
    print("ended by", ending.number)
"""
SHORT = """
import time
from kinegrade.cli.running.signals import signals_obeyed

with signals_obeyed():
    import slowly
time.sleep(0.2)
print("done")
"""
WORKER = """
from kinegrade.processes.worker import do_task

def load():
    import slowly
    return "done"

print(do_task(load))
"""
unix = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no timers")


def said(folder: Path, program: str, name: str) -> list[str]:
    """The lines of a program beside a module that sends that signal while it is loaded."""
    (folder / "slowly.py").write_text(MODULE.format(name=name), encoding="utf-8")
    path = os.pathsep.join([str(folder), *sys.path])
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )
    assert done.stderr == ""
    return done.stdout.splitlines()


@unix
def test_a_run_ends_by_ctrl_c_when_the_module_is_loaded(tmp_path: Path) -> None:
    assert said(tmp_path, COMMAND, "SIGINT") == ["loaded", f"ended by {int(signal.SIGINT)}"]


@unix
def test_a_run_that_is_done_by_then_is_not_ended_afterwards(tmp_path: Path) -> None:
    assert said(tmp_path, SHORT, "SIGINT") == ["loaded", "done"]


def test_a_worker_that_loads_is_left_to_the_process_that_it_works_for(tmp_path: Path) -> None:
    assert said(tmp_path, WORKER, "SIGTERM") == ["loaded", "done"]
