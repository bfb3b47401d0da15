"""Several runs that differ in their part run each test once, and those of a group together."""

from __future__ import annotations

import re
import subprocess
import sys
from collections import Counter
from itertools import pairwise

FILES = "tests/worked/test_senses.py", "tests/worked/test_introductions.py"
PARTS = 2
PLAIN = "-o", "addopts=", "--import-mode=importlib", "-n", "0", "-p", "no:cacheprovider"


def list_tests(*options: str) -> list[str]:
    """The tests that a run with these options would run, in order."""
    proves = "--hypothesis-profile=prove", "-m", "sampled"
    command = [sys.executable, "-m", "pytest", *PLAIN, "--co", "-q", *proves, *options, *FILES]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return [line for line in done.stdout.splitlines() if "::" in line]


def find_template(test: str) -> str:
    """The template of a test."""
    return re.findall(r"\[(.*)\]$", test)[0]


def test_parts_share_no_test_and_leave_none_out() -> None:
    parts = [list_tests("--part", f"{part}/{PARTS}") for part in range(PARTS)]
    assert sorted(test for part in parts for test in part) == sorted(list_tests())
    templates = [set(map(find_template, part)) for part in parts]
    assert max(Counter(name for part in templates for name in part).values()) == 1
    follow = [find_template(test) for test in parts[0]]
    changes = sum(one != other for one, other in pairwise(follow))
    assert changes == len(templates[0]) - 1
