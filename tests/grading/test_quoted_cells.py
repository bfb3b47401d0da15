"""A complaint about an answer says in which file, row and column it stands, and quotes the whole of
it as it was typed; through the command line.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade, write_short_class

SEVERAL = "is more than one number; one number was expected - unreadable, no points"
WORKED = "is a range or a calculation; one number was expected - unreadable, no points"


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the crank alone."""
    folder = write_short_class(tmp_path_factory.mktemp("quoted"))
    assert generate(folder, "EXAM").exit_code == 0
    return folder / "EXAM"


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("3 oder 4", SEVERAL),
        ("3 or 4 m/s", SEVERAL),
        ("3或4", SEVERAL),
        ("=1+1", WORKED),
        ("v = 1+1", WORKED),
    ],
)
@pytest.mark.parametrize("form", ["a row for each student", "one below the other"])
def test_an_answer_is_quoted_with_its_place(
    exam: Path, tmp_path: Path, form: str, typed: str, said: str
) -> None:
    lines = ["student,q1.v_x,q1.v_y", f"007,0,{typed}"]
    if form == "one below the other":
        lines = ["student,ask,answer", f"007,q1.v_y,{typed}"]
    (tmp_path / "typed.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    result = kinegrade("grade", exam, tmp_path / "typed.csv", "-o", tmp_path / "MARKS")
    place = "complaint: typed.csv:2: q1.v_y"
    assert f'{place}: "{typed}" {said}' in result.stderr.splitlines()
