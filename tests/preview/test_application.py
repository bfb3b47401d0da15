"""The preview's pages: what a file is now, or what is wrong with it; and nobody else may look."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade.problem.template.library.library import find_shipped
from tests.preview.visitor import Visitor, visiting
from tests.problem.crank import crank_text

FAULTY = crank_text(("family", "famly"), ("[points]", "[dots]"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A template of one's own."""
    path = tmp_path / "crank.toml"
    path.write_text(crank_text(), encoding="utf-8")
    return path


@pytest.fixture
def visitor(file: Path) -> Iterator[Visitor]:
    """A visitor of its preview."""
    with visiting(file) as visitor:
        yield visitor


def entitle(file: Path, title: str) -> None:
    """Save the template with another title."""
    lines = file.read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.startswith("title")]
    file.write_text("\n".join([f'title = "{title}"', *kept]), encoding="utf-8")


def test_the_page_names_its_file_and_loads_nothing_from_elsewhere(visitor: Visitor) -> None:
    answer = visitor.ask("/")
    assert "<title>crank.toml</title>" in answer.text
    assert answer.headers["content-security-policy"].startswith("default-src 'none'")
    assert "http" not in answer.text
    for asset, kind in (("preview.js", "text/javascript"), ("preview.css", "text/css")):
        assert asset in answer.text
        assert visitor.ask(f"/{asset}").headers["content-type"].startswith(kind)


def test_the_problem_has_figure_statement_answers_and_boxes(visitor: Visitor) -> None:
    problem = visitor.read("/problem/0/en")
    assert "<svg" in problem
    assert '<article lang="en">' in problem
    assert 'data-ask="v_x"' in problem
    assert 'role="alert"' not in problem


def test_a_save_is_seen_at_the_next_look(visitor: Visitor, file: Path) -> None:
    assert "Crank on a wall" not in visitor.read("/problem/0/en")
    entitle(file, "Crank on a wall")
    assert "Crank on a wall" in visitor.read("/problem/0/en")


@pytest.mark.parametrize("part", ["problem", "check", "draws", "solution", "motion"])
def test_every_fault_of_the_file_stands_in_place_of_every_part(
    visitor: Visitor, file: Path, part: str
) -> None:
    file.write_text(FAULTY, encoding="utf-8")
    said = visitor.read(f"/{part}/0/en")
    assert 'role="alert"' in said
    assert "famly" in said
    assert "dots" in said


def test_what_is_no_toml_is_said_with_its_line(visitor: Visitor, file: Path) -> None:
    file.write_text("title = \n", encoding="utf-8")
    assert "crank.toml:1" in visitor.read("/problem/0/en")
    assert visitor.list_labels() == []


def test_a_file_that_is_gone_is_missed(visitor: Visitor, file: Path) -> None:
    file.unlink()
    assert "cannot be read" in visitor.read("/problem/0/en")


def test_check_draws_motion_and_solution_are_shown(visitor: Visitor) -> None:
    assert "crank: " in visitor.read("/check/0/en")
    assert 1 <= visitor.read("/draws/0/en").count("<svg") <= 6
    assert "<svg" in visitor.read("/motion/0/en")
    assert "<math" in visitor.read("/solution/0/en")


def test_pages_speak_the_language_that_is_asked_for(visitor: Visitor) -> None:
    assert "答案" in visitor.read("/problem/0/zh")
    assert "Antworten" in visitor.read("/problem/0/de")
    answer = visitor.ask("/problem/0/xx")
    assert (answer.status, answer.text.split(" - ")[0]) == (400, 'unknown: "xx"')


def test_other_pages_cannot_look_by_a_name_of_their_own(visitor: Visitor) -> None:
    assert visitor.ask("/problem/0/en", host="evil.example").status == 400
    assert visitor.ask("/../../etc/passwd").status == 404


def test_nothing_that_a_file_says_becomes_a_tag(visitor: Visitor, file: Path) -> None:
    entitle(file, "<script>alert(1)</script>")
    assert "<script>" not in visitor.read("/problem/0/en")
    file.write_text(f'"<script>" = 1\n{crank_text()}', encoding="utf-8")
    assert "<script>" not in visitor.read("/problem/0/en")


def test_a_bank_shows_each_of_its_questions(tmp_path: Path) -> None:
    bank = tmp_path / "demo.toml"
    bank.write_text((find_shipped("banks") / "demo.toml").read_text("utf-8"), encoding="utf-8")
    with visiting(bank) as visitor:
        labels = visitor.list_labels()
        assert labels[:2] == ["q1: slider-crank", "q2: planetary-gear-external-rim-velocities"]
        assert 'data-ask="omega_II"' in visitor.read("/problem/1/en")
        # The last of those that are left
        assert 'data-ask="v_O"' in visitor.read("/problem/99/en")
