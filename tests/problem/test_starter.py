"""`kinegrade new` gives a template that is finished: every table is there, explained, and `check`
accepts it.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.language import Language
from kinegrade.problem.template.library.alike import find_alike
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.sections.keys import NEEDED, OPTIONAL
from kinegrade.problem.template.texts import find_languages
from kinegrade.proof.checking import check
from tests.small_class import kinegrade

KEYS = (*NEEDED, *OPTIONAL)


def refusal(*arguments: str | Path) -> str:
    """What `new` says when it cannot be done."""
    result = kinegrade("new", *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    (line,) = result.stderr.splitlines()
    return line


def test_new_writes_a_template_into_the_current_folder_that_check_accepts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = kinegrade("new", "my-first")
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr == "my-first.toml: written; prove it with: kinegrade check my-first.toml\n"
    assert (tmp_path / "my-first.toml").read_text(encoding="utf-8") == write_starter_text()
    proof = kinegrade("check", "my-first.toml", "--sample", "60")
    assert (proof.exit_code, proof.stdout.splitlines()[0]) == (0, "my-first: sound")


def test_every_table_is_there_and_explained_in_the_lines_above_it() -> None:
    assert set(tomllib.loads(write_starter_text())) == set(KEYS)
    lines = write_starter_text().splitlines()
    first_table = lines.index("[title]")
    starts = [
        index
        for index, line in enumerate(lines)
        if line.startswith("[")
        or (index < first_table and line.startswith(tuple(f"{key} =" for key in KEYS)))
    ]
    assert len(starts) == len(KEYS)
    assert [index for index in starts if not lines[index - 1].startswith("# ")] == []


def test_a_file_that_is_there_is_kept_unless_forced(tmp_path: Path) -> None:
    path = tmp_path / "my-first.toml"
    path.write_text("mine", encoding="utf-8")
    assert "exists" in refusal("my-first", "-o", path)
    assert path.read_text(encoding="utf-8") == "mine"
    assert kinegrade("new", "my-first", "-o", path, "--force").exit_code == 0
    assert path.read_text(encoding="utf-8") == write_starter_text()


@pytest.mark.parametrize("name", ["My-First", "my first", "../x", "x.toml", "-", "曲柄"])
def test_a_name_is_small_letters_digits_and_hyphens(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert refusal("--", name) == (
        f"error: {name}.toml: a template's name is made of small letters, digits, hyphens and underscores"
    )
    assert list(tmp_path.iterdir()) == []


def test_a_name_may_have_underscores(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert kinegrade("new", "my_first").exit_code == 0
    checked = kinegrade("check", "my_first.toml", "--sample", "20")
    assert checked.stdout.startswith("my_first: sound\n")
    assert kinegrade("show", "my_first.toml", "-o", "page.pdf").exit_code == 0


@pytest.mark.parametrize("file", ["other.toml", "my-first", "my-first.txt"])
def test_a_template_is_called_by_the_name_of_its_file(file: str, tmp_path: Path) -> None:
    path = tmp_path / file
    assert refusal("my-first", "-o", path) == (
        f"error: {path}: a template is called by the name of its file: expected a path that ends "
        "in my-first.toml: change the path or the name"
    )
    assert not path.exists()


def test_a_template_is_written_like_a_shipped_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = kinegrade("new", "my-crank", "--like", "slider-crank")
    assert result.exit_code == 0
    assert result.stderr == (
        "my-crank.toml: written, like slider-crank; prove it with: kinegrade check my-crank.toml; "
        "look at it with: kinegrade gallery my-crank.toml --draws 6 -o sheet.pdf\n"
    )
    text = (tmp_path / "my-crank.toml").read_text(encoding="utf-8")
    assert text == load_template("slider-crank").file.text


def test_a_shared_mechanism_is_written_beside_and_one_that_is_there_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert kinegrade("new", "my-bar", "--like", "pole-four-bar-coupler").exit_code == 0
    checked = kinegrade("check", "my-bar.toml", "--sample", "20")
    assert checked.stdout.startswith("my-bar: sound\n")
    shared = tmp_path / "mechanisms" / "four-bar-with-coupler.toml"
    shared.write_text("mine", encoding="utf-8")
    assert kinegrade("new", "other", "--like", "pole-four-bar-coupler").exit_code == 0
    assert shared.read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize(
    ("words", "like"),
    [
        ("slotted rocker", "slotted-rocker-and-slider-two-drivers"),
        ("Four-bar COUPLER", "pose-four-bar-coupler"),
        ("a ladder slides down a wall", "rod-ground-and-incline"),
        ("winch that lifts a load by a rope through gears", "hoist-with-gears"),
        ("reel pulled by its thread", "spool-pulled-by-cord"),
        ("excavator boom moved by a hydraulic cylinder", "slotted-link-on-cylinder"),
        ("Kolben, Pleuel und Kurbel", "slider-crank"),
        ("Eine Leiter lehnt an der Wand und rutscht", "rod-ground-and-incline"),
        ("Zahnrad zwischen zwei Zahnstangen", "pinion-between-two-racks"),
        ("Planetengetriebe mit gegebenen Zähnezahlen", "differential-epicyclic-train"),
        ("Momentanpol der Koppel", "pole-four-bar-coupler"),
        ("Malteserkreuz", "geneva-drive"),
        ("行星轮系", "epicyclic-train-by-tooth-counts"),
        ("自行车", "belt-driven-bicycle"),
        ("梯子沿墙滑下", "rod-ground-and-incline"),
        ("机械臂", "two-link-robot-arm"),
    ],
)
def test_a_template_is_found_by_words(words: str, like: str) -> None:
    assert find_alike(words) == like


@pytest.mark.parametrize("name", ["slider-crank", "geneva-drive", "hoist-with-gears"])
def test_a_template_is_found_by_its_own_statement(name: str) -> None:
    for text in load_template(name).words.statement.texts:
        assert find_alike(text) == name


def test_words_that_the_nearest_template_has_nothing_of_are_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert kinegrade("new", "x", "--from", "slotted unicorn rocker").stderr.startswith(
        "slotted-rocker-and-slider-two-drivers is the nearest; it has nothing of: unicorn\nx.toml: written"
    )
    assert "nearest" not in kinegrade("new", "y", "--from", "slotted rocker").stderr


def test_check_tells_files_of_one_name_apart_and_from_a_shipped_template(tmp_path: Path) -> None:
    text = load_template("slider-crank").file.text
    paths = [tmp_path / folder / "slider-crank.toml" for folder in "ab"]
    for path, added in zip(paths, ("", "# mine\n"), strict=True):
        path.parent.mkdir()
        path.write_text(text + added, encoding="utf-8")
    said = kinegrade("check", *map(str, paths), "--sample", "20").stdout
    assert f"{paths[0]}: sound\n" in said
    assert f"{paths[1]}: sound\n" in said
    assert said.count("a shipped template has this name") == 1
    assert (
        'a bank gets this file by template = "slider-crank.toml", and the shipped one by '
        '"slider-crank"' in said
    )
    assert kinegrade("check", str(paths[0]), "--sample", "20").stdout.startswith("slider-crank: ")


def test_words_that_no_template_has_and_names_that_there_are_not_are_refused() -> None:
    assert refusal("x", "--from", "qwertz") == (
        'error: no shipped template has any of the words "qwertz" - choose one by: kinegrade list'
    )
    assert refusal("x", "--like", "slider-krank") == (
        'error: no template "slider-krank": did you mean "slider-crank"?'
    )


@pytest.mark.parametrize("also", [["--bank"], ["--policy"], ["--from", "cam"]])
def test_one_model_is_chosen_and_for_a_template_alone(also: list[str]) -> None:
    result = kinegrade("new", "x", "--like", "slider-crank", *also)
    assert result.exit_code == 2
    assert "a template is written --like another or found by --from words" in result.stderr


@pytest.mark.parametrize("language", ["de", "zh"])
def test_the_starter_speaks_the_language_of_the_terminal(language: str, tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    terminal = {"LC_ALL": f"{language}_XX.UTF-8"}
    done = CliRunner().invoke(main, ["new", "mine", "-o", str(path)], env=terminal)
    assert done.exit_code == 0
    assert path.read_text(encoding="utf-8") == write_starter_text(Language(language))
    assert check(load_template(str(path)), sample=20).is_sound


@pytest.mark.parametrize("language", ["de", "zh"])
def test_starters_say_the_same_in_each_language(language: str) -> None:
    own = write_starter_text(Language(language))
    assert _leave_out_texts(tomllib.loads(own)) == _leave_out_texts(
        tomllib.loads(write_starter_text())
    )
    assert find_languages(read_template("starter", own)) == (language,)
    comments, english = (
        {line for line in text.splitlines() if line.startswith("#")}
        for text in (own, write_starter_text())
    )
    assert not comments & english


def _leave_out_texts(value: Any) -> Any:
    """Data without the texts that are in a language, and sources."""
    if isinstance(value, list):
        return [_leave_out_texts(each) for each in value]
    if not isinstance(value, dict):
        return value
    kept = {key: each for key, each in value.items() if key not in {"en", "de", "zh", "source"}}
    return {key: _leave_out_texts(each) for key, each in kept.items()}
