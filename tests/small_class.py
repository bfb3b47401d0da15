"""A class of four and a bank of three questions, as files; and the command line as users call
it.
"""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

from click.testing import CliRunner, Result

from kinegrade.cli import main
from tests.problem.crank import crank_text

STUDENTS = ("007", "0012", "a/b", "=2")
COLUMNS = ("q1.v_B", "q1.a_B", "q2.v_x", "q2.v_y", "q3.omega_AB", "q3.alpha_AB")
ROSTER = """student,name,email
007,王伟,wei@example.org
0012,"O'Neil, Zoë",
a/b,=HYPERLINK(1),
=2,Ann,
"""
BANK = """title = { en = "Midterm", zh = "期中测验" }
course = { en = "Mechanics", zh = "力学" }
date = 2026-05-01
tolerance = { relative = "1 %" }

[[questions]]
template = "slider-crank"
asks = { v_B = 3, a_B = 2.5 }

[[questions]]
template = "crank.toml"
draw = { h = [0], r = [1, 2, 3], omega = [2, 3, 4] }
asks = { v_x = 1, v_y = { points = 2, tolerance = { absolute = 0.25 } } }

[[questions]]
template = "bar-through-swivelling-sleeve"
asks = { omega_AB = 3, alpha_AB = 4 }
tolerance = { relative = "0.5 %", absolute = 0.001 }
"""
VANISHING = ('sign = "+x", points', 'sign = "+x", vanishes = true, points')


def write_class(folder: Path) -> Path:
    """bank.toml with its own template crank.toml, and roster.csv; v_x of the crank is zero for
    everybody.
    """
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(VANISHING), encoding="utf-8")
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return folder


def write_short_class(folder: Path, header: str = "") -> Path:
    """The same class with the crank alone, which is set most quickly, and a head for the bank."""
    write_class(folder)
    frame, _, crank, _ = BANK.split("[[questions]]")
    (folder / "bank.toml").write_text(f"{frame}{header}[[questions]]{crank}", encoding="utf-8")
    return folder


def kinegrade(*arguments: str | Path) -> Result:
    """The command line; an exception that is no exit is a traceback that a user would see, and is
    raised.
    """
    result = CliRunner().invoke(main, list(map(str, arguments)))
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def errors(*arguments: str | Path) -> list[str]:
    """The problems of a command that cannot be done."""
    result = kinegrade(*arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert [line for line in result.stderr.splitlines() if not line.startswith("error: ")] == []
    return [
        line.removeprefix("error: ")
        for line in result.stderr.splitlines()
        if line.startswith("error: ")
    ]


def generate(folder: Path, name: str = "EXAM", *options: str) -> Result:
    """`kinegrade generate` for the class in a folder, from the words spring unless said
    otherwise.
    """
    seed = () if {"--seed", "--reproducible"} & set(options) else ("--reproducible", "spring")
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / name, "--allow-odd-ids", *seed, *options)


def contents(folder: Path) -> dict[str, bytes]:
    """Every file below a folder with its bytes."""
    files = (file for file in sorted(folder.rglob("*")) if file.is_file())
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


def key_lines(exam: Path) -> list[dict[str, Any]]:
    """The lines of key.jsonl."""
    return [
        json.loads(line) for line in (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    ]


def asks_of(exam: Path) -> dict[tuple[str, str], dict[str, Any]]:
    """The key's asks by student and column of the answer sheet."""
    return {
        (line["student"], f"{question['question']}.{name}"): ask
        for line in key_lines(exam)
        for question in line["questions"]
        for name, ask in question["asks"].items()
    }


def table(file: Path) -> list[dict[str, str]]:
    """The rows of a CSV file by column."""
    with file.open(encoding="utf-8-sig", newline="") as lines:
        return list(csv.DictReader(lines))
