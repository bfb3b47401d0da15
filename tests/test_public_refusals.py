"""What the public functions refuse: in one line, before anything is written, in the terminal's
words.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import pytest

import kinegrade
from kinegrade.errors import OptionError, OutputError

SEED = "--seed mixes a label into a random secret, --reproducible WORDS derives all from the words: give one"
KNOWN_SYSTEMS = "known here: blackboard, brightspace, canvas, edx, generic, moodle, sakai, xlsx"


@pytest.fixture(scope="module")
def work(small_class: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with MARKS of the small class."""
    folder = tmp_path_factory.mktemp("work")
    exam = kinegrade.open_exam(small_class / "EXAM")
    kinegrade.grade(exam, small_class / "EXAM" / "answers.csv", folder / "MARKS")
    return folder


def refused(run: Callable[[], object]) -> str:
    with pytest.raises(OptionError) as caught:
        run()
    return str(caught.value)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"seed": "a", "reproducible": "b"}, SEED),
        (
            {"paper_size": "a5", "engine": "word"},
            'paper_size: unknown: "a5" - known here: a4, letter\n'
            'engine: unknown: "word" - known here: latex, typst',
        ),
        (
            {"method": "poles"},
            'method: unknown: "poles" - did you mean "pole"? (known here: base-point, pole, projection)',
        ),
    ],
)
def test_options_of_an_exam_that_are_unknown_or_contradict_each_other(
    small_class: Path, tmp_path: Path, options: dict[str, Any], message: str
) -> None:
    bank = kinegrade.Bank.read(small_class / "bank.toml")
    roster = kinegrade.Roster.read(small_class / "roster.csv", odd_ids=True)
    chosen = kinegrade.GenerateOptions(**options)
    output = tmp_path / "EXAM"
    assert refused(lambda: kinegrade.generate(bank, roster, output, options=chosen)) == message
    assert not output.exists()


@pytest.mark.parametrize(
    ("system", "options", "message"),
    [
        ("ilias", {}, f'to: unknown: "ilias" - {KNOWN_SYSTEMS}'),
        (
            "moodle",
            {"by": ("id", "phone")},
            'by: unknown: "phone" - known here: email, id, login',
        ),
        (
            "moodle",
            {"language": "zh"},
            "--lang: only the generic sheet has headers that can be translated - leave it out",
        ),
        (
            "moodle",
            {"overwrite": True},
            "--overwrite: cells of a download are filled anyway - leave it out, or fill a workbook "
            "(--to xlsx --into)",
        ),
        (
            "moodle",
            {"id_column": "A"},
            "--id-column: says whose the rows of an office's workbook are - leave it out, or fill "
            "a workbook (--to xlsx --into)",
        ),
        ("moodle", {"maximum": 0}, '"0": expected a number above zero, like 10 or 12.5'),
        (
            "moodle",
            {"columns": {"q9": "a"}, "per_question": True},
            '"q9=a": expected QUESTION=HEADER, once for each of q1, q2, q3',
        ),
    ],
)
def test_options_of_an_export(
    work: Path, tmp_path: Path, system: str, options: dict[str, Any], message: str
) -> None:
    marks, output = kinegrade.open_marks(work / "MARKS"), tmp_path / "grades.csv"
    chosen = kinegrade.ExportOptions(**options)
    run = lambda: kinegrade.export(marks, output, to=system, options=chosen)  # noqa: E731
    assert refused(run) == message
    assert not output.exists()


def test_answers_whose_decimal_mark_is_unknown(small_class: Path, tmp_path: Path) -> None:
    exam = kinegrade.open_exam(small_class / "EXAM")
    options = kinegrade.GradeOptions(decimal=cast("Any", "dot"))
    run = lambda: kinegrade.grade(exam, "answers.csv", tmp_path / "MARKS", options=options)  # noqa: E731
    assert refused(run) == 'decimal: unknown: "dot" - known here: comma, point'


def test_a_part_of_an_exam_is_no_place_for_a_report(small_class: Path, work: Path) -> None:
    exam, marks = kinegrade.open_exam(small_class / "EXAM"), kinegrade.open_marks(work / "MARKS")
    key = small_class / "EXAM" / "key.jsonl"
    before = key.read_bytes()
    with pytest.raises(OutputError, match="is a part of the EXAM folder EXAM, which would be lost"):
        kinegrade.report(exam, marks, key, force=True)
    assert key.read_bytes() == before


def test_a_path_in_place_of_what_is_read_from_it(tmp_path: Path) -> None:
    text: Any = "SPRING"
    path: Any = Path("SPRING")
    exam = "exam: is a path, not what it leads to - read it first: kinegrade.open_exam('SPRING')"
    marks = exam.replace("exam:", "marks:").replace("open_exam", "open_marks")
    output = tmp_path / "output"
    roster = (
        "roster: is a path, not what it leads to - read it first: kinegrade.Roster.read('SPRING')"
    )
    bank = roster.replace("roster:", "bank:").replace("Roster", "Bank")
    late = roster.replace("roster:", "late:")
    asked: list[tuple[Callable[[], object], list[str]]] = [
        (lambda: kinegrade.generate(text, path, output), [bank, roster]),
        (lambda: kinegrade.add_students(text, text, text, text), [exam, bank, roster, late]),
        (lambda: kinegrade.grade(path, "answers.csv", output), [exam]),
        (lambda: kinegrade.export(text, output, to="moodle", exam=text), [marks, exam]),
        (lambda: kinegrade.quiz(text, output, to="qti12"), [exam]),
        (lambda: kinegrade.feedback(text, text, output), [exam, marks]),
        (lambda: kinegrade.report(text, path, output), [exam, marks]),
    ]
    for run, faults in asked:
        assert refused(run).splitlines() == faults
    assert not output.exists()
