"""A fixed sample of every proof, every seed that once failed, and the program that runs proofs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from tests.prove import __main__ as program
from tests.prove import invented, progress, properties, whole_tests
from tests.prove.__main__ import main
from tests.prove.failed_seeds import FAILED
from tests.prove.outcome import Outcome
from tests.prove.proof import Proof
from tests.prove.proofs import PROOFS

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits of time are signals of POSIX")
FIRST = 1_000  # seed of the samples
BY_NAME = {proof.name: proof for proof in PROOFS}
SAMPLE = [
    pytest.param(proof, seed, id=f"{proof.name} {seed}")
    for proof in PROOFS
    for seed in range(FIRST, FIRST + proof.sample)
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that the cases of this process share."""
    return tmp_path_factory.mktemp("proofs")


@pytest.mark.parametrize(("proof", "seed"), SAMPLE)
def test_the_claim_holds_at_a_fixed_sample(proof: Proof, seed: int, folder: Path) -> None:
    proof.hold(seed, folder)


@pytest.mark.parametrize(("name", "seed"), FAILED)
def test_what_once_failed_holds_now(name: str, seed: int, folder: Path) -> None:
    BY_NAME[name].hold(seed, folder)


def test_every_proof_has_a_sample() -> None:
    without = [proof.name for proof in PROOFS if not proof.sample]
    # whose samples are the suite, tests/proof, tests/description, tests/figures, tests/by_hand,
    # tests/exam and tests/practice
    assert without == [
        "properties",
        "whole tests",
        "sound templates",
        "sufficient descriptions",
        "solution pages",
        "short solutions",
        "graded figures",
        "unlike figures",
        "by hand",
        "whole papers",
        "resumed papers",
        "printed pages",
        "practice sheets",
        "practice sheet size",
        "practice access",
    ]
    assert "tests/laws/test_laws.py" in properties.files()
    assert "tests/cycles/test_curves.py" in whole_tests.files()


def run(capsys: pytest.CaptureFixture[str], *arguments: str, cases: int) -> tuple[int, list[str]]:
    """The status and the lines of a run of the invented proof."""
    proof = Proof("invented", invented.hold, cases=cases, batch=3, sample=0)
    status = main(["--seed", "10", "--jobs", "2", *arguments], (proof,))
    return status, capsys.readouterr().out.splitlines()


def test_a_failure_is_the_line_that_belongs_into_the_list(
    capsys: pytest.CaptureFixture[str],
) -> None:
    status, lines = run(capsys, cases=10)
    assert status == 1
    name, seed, cases, full, _, failures, compared = lines[1].split()
    assert (name, seed, cases, full, failures) == ("invented", "10", "10", "10", "5")
    assert int(compared) == 2 * 6  # by those that hold, and by the one that took much memory
    assert lines[2].startswith("    ('invented', 11): 'AssertionError in invented.py:")
    assert lines[2].endswith(": 11 ends in 1',")
    assert lines[3].endswith(": no such thing',")
    assert lines[4] == "    ('invented', 13): 'the process died (status 7)',"
    assert lines[5].startswith("    ('invented', 14): 'memory: 1")
    assert lines[6] == "    ('invented', 15): 'the process died (SIGXCPU)',"


def test_a_run_without_failure_ends_well(capsys: pytest.CaptureFixture[str]) -> None:
    status, lines = run(capsys, "--scale", "0.1", cases=10)
    assert (status, len(lines)) == (0, 2)
    assert lines[1].split()[2:4] == ["1", "10"]


def test_how_far_a_proof_is_is_said_while_it_runs(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that is cut short has said what it found: failures at once, the rest every minute."""
    monkeypatch.setattr(progress, "EVERY", 0.01)
    main(["--seed", "10", "--jobs", "1"], (Proof("invented", invented.hold, 3, 3, 0),))
    table, said = capsys.readouterr()
    lines = said.splitlines()
    assert any(re.fullmatch(r"invented: 0 of 3 done, \d+ s", line) for line in lines), lines
    assert [line for line in lines if line.startswith(" ")] == table.splitlines()[2:]
    assert "11 ends in 1" in said


def test_what_is_said_has_the_number_of_things_compared(capsys: pytest.CaptureFixture[str]) -> None:
    tally = progress.Tally(Proof("invented", invented.hold, 3, 3, 0), 3)
    tally.add(Outcome(10, "", 2))
    tally.add(Outcome(16, "", 2))
    tally.show()
    assert capsys.readouterr().err == "invented: 2 of 3 done, 4 compared, 0 s\n"


def test_a_run_that_is_out_of_time_says_so_by_its_numbers(
    capsys: pytest.CaptureFixture[str],
) -> None:
    _, lines = run(capsys, "--minutes", "0", cases=10)
    assert lines[1].split()[2:4] == ["0", "10"]


def test_a_dear_proof_leaves_those_after_it_their_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    shares = []

    def note_share(
        proof: Proof, seeds: range, jobs: int, until: float, note: object
    ) -> list[Outcome]:
        shares.append(round((until - time.monotonic()) / 60))
        return []

    monkeypatch.setattr(program, "outcomes", note_share)
    proof = Proof("invented", invented.hold, cases=1, batch=1, sample=0)
    main(["--minutes", "30"], (proof, proof, proof))
    assert shares == [10, 15, 30]  # of what is left; here none takes its share
    shares.clear()
    main(["--minutes", "30"], (replace(proof, weight=4), proof, proof))
    assert shares == [20, 15, 30]


def test_a_case_has_its_own_time_of_the_processor() -> None:
    give = "from tests.prove.batch import SECONDS, main\n"
    tell = "import resource; print(resource.getrlimit(resource.RLIMIT_CPU)[0] - SECONDS)"
    run_case = 'main("tests.prove.invented:hold", "10", "11"); '
    done = subprocess.run(
        [sys.executable, "-c", give + run_case + tell], capture_output=True, text=True, check=True
    )
    assert 0 <= int(done.stdout.splitlines()[-1]) < 60, done.stdout


def test_a_proof_that_is_not_there_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--only", "fairnes"])
    assert "invalid choice: 'fairnes'" in capsys.readouterr().err


def test_a_seed_of_properties_that_fails_names_the_test(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = tmp_path / "test_wrong.py"
    file.write_text(
        "from hypothesis import given, strategies as st\n\n"
        "@given(st.integers())\ndef test_all_are_small(n):\n    assert n < 100\n",
        encoding="utf-8",
    )
    profile = "from hypothesis import settings\n\nsettings.register_profile('prove')\n"
    (tmp_path / "conftest.py").write_text(profile, encoding="utf-8")
    monkeypatch.setattr(properties, "files", lambda: (str(file),))
    with pytest.raises(AssertionError, match="FAILED .*test_wrong.py::test_all_are_small"):
        properties.hold(5, tmp_path)
