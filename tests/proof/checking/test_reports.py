"""What `kinegrade check` prints of a template, and its status."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.problem.template.library.library import load_template
from kinegrade.proof.checking import check
from kinegrade.proof.reporting import write_findings, write_verdict
from tests.problem.crank import crank, crank_text
from tests.said import all_said, said

UNPUBLISHED = crank_text(('[[published]]\nsource = "by hand"\ngives = { v_x = "-omega*h" }\n', ""))


def test_the_report_says_what_was_found() -> None:
    report = check(crank(), sample=200)
    lines = [said(write_verdict(report)), *map(said, write_findings(report))]
    assert lines[:4] == [
        "crank: FAULTY",
        "complete in: en, zh",
        "published results proved exactly: 5",
        "drawable combinations: 18; examined: 18, accepted: 2, "
        "refused: absurd 2, condition 6, degenerate 4, mechanism 4",
    ]
    assert re.fullmatch(r"distinct instances: about 2; [\d.]+ ms each", lines[4])
    assert lines[5:7] == [
        "difficulty: 1 of 5; about 6 minutes",
        "refused, condition: omega < 10000000: 6 of 18, nearly all at omega = 20000000 rad/s: "
        "leave that value out",
    ]
    assert [line.partition(":")[0] for line in lines[7:10]] == [
        "refused, degenerate",
        "refused, mechanism",
        "refused, absurd",
    ]
    assert lines[10:] == [
        "v_x                  -1 .. -1         m/s     negative 100%, different 1",
        'A is "right"; with "left" it closes as well in 100% of the draws: -o FILE shows both',
        "fault: about 2 distinct instances: at least 500 are needed for a class: widen the domains",
        "fault: v_x has the same answer in all instances: a student guesses it: give it no points "
        "here (a bank may still ask for it), or ask for something else",
        "fault: breaks at r = 1, h = 3, omega = 2: crank: points.A: the circle about O of "
        "radius 1 does not reach the line y = 3: add the condition "
        '"distance(O, foot(O, line(P, 0))) < r" or narrow the domains',
    ]


def test_the_report_is_in_the_language_of_the_terminal(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(crank_text(), encoding="utf-8")
    chinese = CliRunner(env={"LC_ALL": "zh_CN.UTF-8"})
    shown = chinese.invoke(main, ["check", str(file), "--sample", "18", "--jobs", "1"])
    assert shown.exit_code == 1
    assert shown.stdout.startswith("crank：有误\n  齐全的语言：en、zh\n")
    assert "拒绝：大小不合理 2、不合条件 6、退化 4、机构不成立 4\n" in shown.stdout
    assert (
        "  错误：v_x 在所有实例中答案相同：学生会猜到：请在此不给分（题库仍可要求），或改求别的量\n"
    ) in shown.stdout


def test_the_command_ends_with_status_1_for_a_faulty_template(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(UNPUBLISHED, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == 1
    assert result.stdout.startswith("crank: FAULTY\n")
    assert "remark: no published result" in result.stdout
    assert CliRunner().invoke(main, ["check", "slider-crank"]).exit_code == 0


def test_a_check_leaves_nothing_in_the_folder_where_it_is_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert all_said(check(load_template("slider-crank"), sample=20).faults) == []
    assert list(tmp_path.iterdir()) == []
