"""What is said on the terminal is said in its language; files are not written in it."""

from __future__ import annotations

from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result

from kinegrade.cli import main
from kinegrade.cli.help import list_help_keys
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.entries import read_entries
from kinegrade.language.known import known_languages


def chinese(*arguments: object) -> Result:
    return CliRunner(env={"LC_ALL": "zh_CN.UTF-8"}).invoke(main, list(map(str, arguments)))


def test_help_is_in_the_language_of_the_terminal() -> None:
    assert "按学号 STUDENT 重新打印一名学生的试卷" in chinese("paper", "--help").output
    assert "列出题目模板。" in chinese("--help").output


def test_a_refusal_and_a_usage_error_are_in_the_language_of_the_terminal(tmp_path: Path) -> None:
    path = tmp_path / "marks"
    path.write_text("", encoding="utf-8")
    refused = chinese("papers", path, "-o", tmp_path / "x")
    assert refused.stderr == (
        f"错误：{path}: 此处应为 EXAM，所给的是 一个文件 - 应为由 kinegrade generate 生成的考试文件夹 - "
        "请给出该文件夹\n"
    )
    usage = chinese("generate", "demo", "roster.csv", "-o", "EXAM", "--seed", " ")
    assert "应为一段文字，如 spring-2026" in usage.stderr


def test_what_is_wrong_with_a_bank_and_a_roster_is_said_in_the_language_of_the_terminal(
    tmp_path: Path,
) -> None:
    bank, roster = tmp_path / "bank.toml", tmp_path / "class.csv"
    bank.write_text('title = "A"\ncourse = "B"\nquestions = []\n', encoding="utf-8")
    roster.write_text("学号,姓名\n007,安\n007,博\n", encoding="utf-8")
    refused = chinese("generate", bank, roster, "-o", tmp_path / "EXAM")
    assert f"错误：{bank}:3: questions: 0 个表 - 应为1 至 50 个 [[questions]] 表" in refused.stderr
    refused = chinese("generate", "demo", roster, "-o", tmp_path / "EXAM")
    assert '错误：class.csv: 学号 "007" 出现在第 2和3 行 - 每个学号只应出现一次' in refused.stderr


def test_what_is_wrong_with_an_exam_folder_is_said_in_the_language_of_the_terminal(
    tmp_path: Path,
) -> None:
    head = tmp_path / "EXAM" / "exam.json"
    head.parent.mkdir()
    head.write_text('{"format": 9}', encoding="utf-8")
    refused = chinese("papers", head.parent, "-o", tmp_path / "x")
    assert refused.stderr == (
        f"错误：{head}:1: format: 9 - 应为1或2，本 kinegrade 只能读取这些 - "
        "请使用不早于生成该文件夹的 kinegrade 版本\n"
    )


def test_why_a_mechanism_cannot_be_solved_is_said_in_the_language_of_the_terminal() -> None:
    refused = chinese("solve", "slider-crank", "--set", "k=1/9")
    assert refused.stderr == (
        "错误：slider-crank: points.B: 以 A 为圆心、0.1111 为半径的圆达不到直线 y = 0\n"
    )


@pytest.mark.parametrize("language", known_languages())
def test_help_has_an_entry_for_each_command_and_option_and_none_besides(language: Language) -> None:
    entries = read_entries(language, "help").entries
    assert set(list_help_keys(main)) == set(entries)
    commands = {f"help.{name}" for name in main.commands}
    assert [each for each in main.commands.values() if not isinstance(each, click.Command)] == []
    assert [key for key in commands if "kinegrade " not in open_catalogue(language).text(key)] == []


def test_an_output_that_is_there_is_refused_in_the_language_of_the_terminal(tmp_path: Path) -> None:
    path = tmp_path / "crank.toml"
    path.write_text("mine", encoding="utf-8")
    refused = chinese("new", "crank", "-o", path)
    assert refused.stderr == (
        f"错误：{path}: 已存在 - 应为新文件 - 请加 --force 以替换它，或换一个名称\n"
    )
    assert path.read_text(encoding="utf-8") == "mine"
