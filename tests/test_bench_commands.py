"""The commands that the bench times are done: one that refused would end the bench, and leave
all that follows it unmeasured.
"""

from __future__ import annotations

from pathlib import Path

from benchmarks.class_commands import COMMANDS, list_commands, make_class

STUDENTS = 12


def test_every_command_that_is_timed_is_done(tmp_path: Path) -> None:
    """Each in the order in which the bench runs them; `run` asserts that none refuses."""
    class_ = make_class(tmp_path, STUDENTS)
    done = 0
    for words in list_commands(tmp_path):
        class_.run(*words)
        done += 1
    assert done == len(COMMANDS)
