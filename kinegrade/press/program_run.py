"""An external program, run to its end or stopped: whatever ends this process in between, the
program does not outlive it.
"""

from __future__ import annotations

import signal
import subprocess
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import FrameType

_ENDING = (signal.SIGINT, signal.SIGTERM)


@dataclass(frozen=True)
class ProgramRun:
    """The outcome: the exit status, 0 for success, and what was written to standard output and
    error.
    """

    status: int
    output: bytes
    complaint: bytes


def run_program(
    command: Sequence[str],
    seconds: float,
    *,
    given: bytes = b"",
    folder: Path | None = None,
    environment: Mapping[str, str] | None = None,
) -> ProgramRun:
    """Run a program with this input, in this folder.

    Raises OSError where it cannot be started, TimeoutError where it has not ended after that time;
    then it is stopped.
    """
    process: subprocess.Popen[bytes] | None = None
    try:
        # A signal between the start and the next line would leave it running
        with _signals_deferred():
            process = subprocess.Popen(
                command,
                cwd=folder,
                env=environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        output, complaint = process.communicate(given, timeout=seconds)
    except subprocess.TimeoutExpired as fault:
        raise TimeoutError(str(fault)) from fault
    finally:
        if process is not None:
            _stop(process)
    return ProgramRun(process.returncode, output, complaint)


def _stop(process: subprocess.Popen[bytes]) -> None:
    """Stop a program that is still running, and close its channels."""
    if process.poll() is None:
        process.kill()
        process.communicate()


@contextmanager
def _signals_deferred() -> Iterator[None]:
    """A signal that would end this process waits for the end of the block."""
    if threading.current_thread() is not threading.main_thread():  # signals do not reach it
        yield
        return
    caught: list[int] = []

    def keep(number: int, frame: FrameType | None) -> None:
        caught.append(number)

    usual = {
        number: signal.signal(number, keep)
        for number in _ENDING
        if callable(signal.getsignal(number))
    }
    try:
        yield
    finally:
        for number, handler in usual.items():
            signal.signal(number, handler)
        if caught:
            signal.raise_signal(caught[0])
