"""How hypothesis runs (the same examples every time, new ones for `make prove`), and a small exam
for all.
"""

from __future__ import annotations

import gc
import os
import re
from itertools import count
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from kinegrade.exam.bank.bank import Bank, read_bank
from kinegrade.exam.printing import class_printing
from kinegrade.processes import garbage_collection
from kinegrade.processes.garbage_collection import NEW_OBJECTS
from tests.files_in_memory import leave_files_in_memory
from tests.golden_files import BANK, GOLDEN, Hold, drop_tests_without_goldens
from tests.kept_results import keep_results
from tests.kept_volumes import keep_volumes
from tests.one_process import work_in_one_process
from tests.parts import group_tests, keep_part
from tests.problem.crank import crank_text
from tests.repeated_secrets import repeat_secrets
from tests.sampling import drop_unsampled
from tests.small_class import VANISHING, generate, write_class
from tests.tools import complaint, missing_tools

os.environ["LC_ALL"] = "C.UTF-8"  # tests read what the terminal says in English
FOLDERS = count()
COMMON = {
    "deadline": None,
    "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much],
}
settings.register_profile("suite", max_examples=15, derandomize=True, **COMMON)
settings.register_profile("prove", max_examples=200, database=None, **COMMON)
settings.load_profile("suite")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--regenerate-golden",
        action="store_true",
        help="Write the files of tests/golden/ anew, by the tests that hold them alone.",
    )
    parser.addoption(
        "--part", help="One of several runs: 0/6 is the first of six (tests/parts.py)."
    )


def pytest_configure(config: pytest.Config) -> None:
    gc.set_threshold(NEW_OBJECTS)  # as commands have it
    if not _proves(config):
        repeat_secrets(config)
        keep_results()
        keep_volumes()
        leave_files_in_memory()
        work_in_one_process()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Try a sample where there are many like cases; say which tests a worker runs together."""
    if not _proves(config):
        drop_unsampled(config, items)
    if config.getoption("--regenerate-golden"):
        drop_tests_without_goldens(config, items)
    if "PYTEST_XDIST_WORKER" in os.environ:
        group_tests(items)
    if part := config.getoption("--part"):
        keep_part(config, items, part)


def _proves(config: pytest.Config) -> bool:
    """Whether `make prove` runs these tests."""
    return bool(config.getoption("--hypothesis-profile") == "prove")


def pytest_collection_finish() -> None:
    """Let the collector of garbage pass over what stays until the end: modules and tests. That
    something is frozen is known then: to count it would take each command as long as a paper.
    """
    gc.freeze()
    garbage_collection.is_frozen = lambda: True


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Fail a test that needs TeX where there is none: a test that is skipped proves nothing."""
    if item.get_closest_marker("needs_tex") is None:
        return
    missing = missing_tools()
    if missing:
        pytest.fail(complaint(missing), pytrace=False)


@pytest.fixture
def tmp_path(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of a test's own, with a number that no other has: to find one, pytest would look
    through those of all tests before.
    """
    name = re.sub(r"\W", "_", request.node.name)[:30]
    return tmp_path_factory.mktemp(f"{name}{next(FOLDERS)}", numbered=False)


@pytest.fixture
def hold(request: pytest.FixtureRequest) -> Hold:
    """Holds a text against the golden file of that name, or writes it."""

    def compare(name: str, text: str) -> None:
        if request.config.getoption("--regenerate-golden"):
            (GOLDEN / name).write_text(text, encoding="utf-8", newline="\n")
        assert text == (GOLDEN / name).read_text(encoding="utf-8")

    return compare


@pytest.fixture
def golden_bank(tmp_path: Path) -> Bank:
    """The bank of the exam whose files are goldens."""
    (tmp_path / "crank.toml").write_text(crank_text(VANISHING), encoding="utf-8")
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    return read_bank(tmp_path / "bank.toml")


@pytest.fixture
def small_parts(monkeypatch: pytest.MonkeyPatch) -> int:
    """How many papers are worth a process of their own, made few."""
    few = 4
    monkeypatch.setattr(class_printing, "CHUNK", few)
    return few


@pytest.fixture(scope="session")
def small_class(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with bank.toml, roster.csv and the EXAM generated from them; to be read, not to be
    changed.
    """
    folder = write_class(tmp_path_factory.mktemp("class"))
    result = generate(folder)
    if result.exit_code != 0:
        raise RuntimeError(result.stderr)
    return folder
