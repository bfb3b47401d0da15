"""`kinegrade list` and `show`, as an instructor uses them to choose problems."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kinegrade.choosing.choice import read_entries
from kinegrade.cli.problems import choosing
from kinegrade.problem.template.library import library
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from tests.small_class import kinegrade

COLUMNS = ("name", "family", "title", "difficulty", "minutes", "tags")


def listed(*wishes: str) -> list[dict[str, str]]:
    """The rows of a list."""
    result = kinegrade("list", *wishes)
    assert (result.exit_code, result.stderr) == (0, "")
    return [
        dict(zip(COLUMNS, line.split("\t"), strict=True)) for line in result.stdout.splitlines()
    ]


def test_problems_with_coriolis_acceleration_of_medium_difficulty_without_gears() -> None:
    rows = listed("--asks", "coriolis", "--difficulty", "2..3", "--without-tag", "gears")
    assert {"eccentric-cam-offset-follower", "bent-rod-tangent-disc"} <= {
        row["name"] for row in rows
    }
    assert [row for row in rows if row["difficulty"] not in "23"] == []
    assert [row for row in rows if "coriolis" not in row["tags"].split()] == []
    assert [row for row in rows if "gears" in row["tags"].split()] == []


def test_each_wish_takes_what_does_not_fulfil_it() -> None:
    everything = {row["name"]: row for row in listed()}
    assert tuple(everything) == find_template_names()
    rolling = {row["name"] for row in listed("--joint", "roll")}
    smooth = {row["name"] for row in listed("--without-joint", "roll")}
    assert rolling | smooth == set(everything)
    assert "rolling-wheel-rim-points" in rolling - smooth
    assert {row["family"] for row in listed("--family", "trammel")} == {"trammel"}
    both = listed("--tag", "slot", "--tag", "rolling")
    assert [row["name"] for row in both] == ["rolling-wheel-pin-slotted-rocker"]
    short = listed("--minutes", "0..10")
    assert [row for row in short if int(row["minutes"]) > 10] == []
    assert {"slider-crank"} <= {row["name"] for row in listed("--method", "projection")}
    assert {row["difficulty"] for row in listed("--difficulty", "5")} == {"5"}


def test_what_no_template_knows_is_refused_with_the_nearest() -> None:
    result = kinegrade("list", "--tag", "corolis", "--joint", "mesg", "--asks", "acceleraton")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.splitlines() == [
        'error: --tag: unknown: "corolis" - did you mean "coriolis"?',
        'error: --joint: unknown: "mesg" - did you mean "mesh"?',
        'error: --asks: unknown: "acceleraton" - did you mean "acceleration", '
        '"normal_acceleration" or "relative_acceleration"?',
    ]


@pytest.mark.parametrize("bounds", ["3..2", "x", "", "1-3", "..3"])
def test_bounds_are_a_level_or_a_range(bounds: str) -> None:
    result = kinegrade("list", "--difficulty", bounds)
    assert result.exit_code == 2
    assert "expected a level or a range, like 3 or 2..3" in result.stderr


def test_the_wish_that_takes_the_last_templates_is_named() -> None:
    result = kinegrade("list", "--tag", "belt", "--difficulty", "5")
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr == (
        "complaint: no template is left: --difficulty 5 takes the last 3, belt-driven-bicycle, "
        "crossed-belt-drive, two-stage-belt-drive - leave it out, or ask for less\n"
    )
    many = kinegrade("list", "--without-tag", "acceleration", "--difficulty", "5").stderr
    [last] = re.findall(r"--difficulty 5 takes the last (\d+), ", many)
    assert f"and {int(last) - 3} more" in many


def test_tags_are_listed_with_counts_and_meanings() -> None:
    rows = [line.split("\t") for line in kinegrade("list", "--tags").stdout.splitlines()]
    belt = ["belt", "3", "a belt runs over two pulleys"]
    assert belt in rows
    assert sum(int(count) for _, count, _ in rows[:3]) == len(find_template_names())
    among = kinegrade("list", "--tags", "--tag", "belt").stdout.splitlines()
    assert belt in [line.split("\t") for line in among]
    assert [line for line in among if line.startswith("gears")] == [
        "gears\t0\tgears, or a gear and a rack"
    ]


def test_a_terminal_gets_columns_that_fit_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choosing, "_is_terminal", lambda: True)
    monkeypatch.setenv("COLUMNS", "80")
    header, first, *_ = kinegrade("list", "--tag", "belt").stdout.splitlines()
    assert header.split()[:3] == ["template", "family", "title"]
    assert first.startswith("belt-driven-bicycle")
    assert max(map(len, (header, first))) <= 80
    assert kinegrade("list", "--tag", "belt", "--difficulty", "5").stdout == ""


@pytest.mark.sampled(8, first=2)
@pytest.mark.parametrize("name", find_template_names())
def test_a_template_is_shown_without_latex(name: str) -> None:
    for language, difficulty in (("en", "difficulty: "), ("zh", "难度：")):
        shown = kinegrade("show", name, "--lang", language).stdout
        assert not set("$\\{}") & set(shown)
        assert difficulty in shown


def test_the_reader_s_language_is_that_of_the_terminal_where_there_is_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    assert "曲柄滑块机构" in kinegrade("list", "--family", "slider-crank").stdout
    assert "求速度瞬心" in kinegrade("list", "--tags").stdout
    assert "曲柄 OA 长 r = 1 m" in kinegrade("show", "slider-crank").stdout
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    assert "Schubkurbelgetriebe" in kinegrade("show", "slider-crank").stdout
    assert "The jaw AB" in kinegrade("show", "stone-crusher").stdout  # there is no German text
    assert "Jaw of a stone crusher" in kinegrade("list", "--tag", "machine").stdout
    refused = kinegrade("show", "stone-crusher", "--lang", "de")
    assert refused.exit_code == 2


def test_all_shipped_templates_are_worked_out_in_two_seconds_of_one_core(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(library, "read_template", read_template)  # not as tests keep them
    began = time.process_time()
    read_entries(map(load_template, find_template_names()))
    assert time.process_time() - began < 2


def test_the_list_is_printed_by_a_process_of_its_own(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "kinegrade", "list", "--family", "belt"],
        capture_output=True,
        check=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        cwd=tmp_path,
    )
    assert run.stdout.startswith("belt-driven-bicycle\tbelt\tBicycle with a toothed belt\t2\t")
