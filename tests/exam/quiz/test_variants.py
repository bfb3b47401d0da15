"""The variants of a quiz: papers, versions, processes, and folders at fault."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError, KinegradeError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.quiz import quiz
from kinegrade.exam.quiz.paper import QuizWishes, make_quiz_paper
from kinegrade.exam.quiz.quiz import PLAIN
from kinegrade.exam.quiz.source import read_quiz_source
from kinegrade.processes.executor import Start, open_executor
from tests.exam.quiz.exam_folders import copied, first_line, read_line
from tests.exam.quizzes import papers, quiz_of
from tests.small_class import generate, key_lines, kinegrade, write_class


def set_class(folder: Path, head: str) -> Path:
    """A class whose bank begins with a head, its exam set."""
    bank = write_class(folder) / "bank.toml"
    bank.write_text(head + bank.read_text(encoding="utf-8"), encoding="utf-8")
    assert generate(folder).exit_code == 0
    return folder


def test_variants_are_the_first_papers_and_nobodys(small_class: Path) -> None:
    pool, own = papers(small_class / "EXAM", variants=2), papers(small_class / "EXAM")
    assert pool == tuple(replace(paper, student="", name="") for paper in own[:2])
    with pytest.raises(
        ExamError, match="has 4 different papers - expected 5 for 5 variants of each question - ask"
    ):
        quiz_of(small_class / "EXAM", variants=5)


def test_a_version_is_put_once_and_questions_in_the_order_in_which_responses_are_read(
    tmp_path: Path,
) -> None:
    folder = set_class(tmp_path, "versions = 2\nshuffle = true\n")
    put = papers(folder / "EXAM")
    assert [(paper.code, paper.student, paper.name) for paper in put] == [
        ("A", "", "Version A"),
        ("B", "", "Version B"),
    ]
    lines = open_exam(folder / "EXAM").keys.texts()
    orders = {tuple(json.loads(line)["printed"]) for _, line in lines}
    read = list(open_exam(folder / "EXAM").questions)
    assert orders - {tuple(read)}
    assert [[question.sheet.identifier for question in paper.questions] for paper in put] == [
        read,
        read,
    ]
    assert len(papers(folder / "EXAM", variants=2)) == 2
    with pytest.raises(ExamError, match="has 2 different papers"):
        quiz_of(folder / "EXAM", variants=3)


def test_a_question_without_its_figure_says_where_that_is_on_a_shuffled_paper(
    tmp_path: Path,
) -> None:
    folder = set_class(tmp_path, "shuffle = true\n")
    upload = tmp_path / "upload.txt"
    assert kinegrade("quiz", folder / "EXAM", "--to", "blackboard", "-o", upload).exit_code <= 1
    texts = [line.split("\t")[1] for line in upload.read_text("utf-8").splitlines()]
    keys = key_lines(folder / "EXAM")
    orders = [key["printed"] for key in keys]
    assert len(set(map(tuple, orders))) > 1
    expected = [
        (key["paper"], key["printed"].index(question["question"]) + 1)
        for key in keys
        for question in key["questions"]
        for _ in question["asks"]
    ]
    said = [re.search(r"^\[(.*?)\] .*your paper, at question (\d)\.\)", text) for text in texts]
    assert [(each[1], int(each[2])) for each in said if each] == expected


@pytest.mark.sampled(2, by="start")
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_other_processes_make_the_same_papers(
    small_class: Path, monkeypatch: pytest.MonkeyPatch, start: Start
) -> None:
    monkeypatch.setattr(quiz, "_PART", 1)
    with open_executor(2, "quiz", start) as workers:
        assert papers(small_class / "EXAM", workers=workers) == papers(small_class / "EXAM")


def test_papers_are_counted_for_a_progress_bar(small_class: Path) -> None:
    counts: list[int] = []

    def watched(items: Any, count: int) -> Any:
        counts.append(count)
        return items

    assert len(papers(small_class / "EXAM", progress=watched)) == 4
    papers(small_class / "EXAM", progress=watched, variants=3)
    assert counts == [4, 3]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        (
            "exam.json",
            None,
            r"exam.json: cannot be read \(No such file or directory\) - expected an exam folder "
            r"made by",
        ),
        (
            "bank.toml",
            b"\xff",
            r"bank.toml: cannot be read \(not UTF-8\) - expected an exam folder made by kinegrade",
        ),
        (
            "key.jsonl",
            None,
            r"key.jsonl: cannot be read \(No such file or directory\) - expected an exam folder",
        ),
        (
            "exam.json",
            b"{}",
            r"exam.json: format: missing - expected 1 or 2, the only ones this kinegrade reads",
        ),
        (
            "exam.json",
            b'{"format": 3}',
            r"exam.json:1: format: 3 - expected 1 or 2, the only ones this kinegrade reads - use a",
        ),
        (
            "exam.json",
            b'{"format": 1, "questions": [], "students": 5}',
            r"exam.json:1: questions: empty - expected a list that is not empty - restore the",
        ),
        (
            "key.jsonl",
            b"{",
            r"key.jsonl: line 1: is broken \(.*\) - expected it as kinegrade generate wrote it",
        ),
        ("templates/crank.toml", b"family = 5", r"EXAM: crank.toml"),
    ],
)
def test_a_folder_at_fault_is_refused(
    small_class: Path, tmp_path: Path, name: str, text: bytes | None, message: str
) -> None:
    exam = copied(small_class, tmp_path)
    if text is None:
        (exam / name).unlink()
    else:
        (exam / name).write_bytes(text)
    with pytest.raises(ExamError, match=message):
        papers(exam)


def test_a_broken_line_of_the_key_is_named(small_class: Path, tmp_path: Path) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    line["questions"][0]["asks"]["v_B"]["points"] = "1e999"
    with pytest.raises(
        ExamError,
        match=r'the line of student "007": is broken \("points" is .* - expected a number\) - expect',
    ):
        make_quiz_paper(source, PLAIN, read_line(line))


@pytest.mark.parametrize(
    ("change", "unknown"),
    [
        (lambda line: line.update(student="008"), "008"),
        (lambda line: line["questions"][0].update(question="q9"), "q9"),
        (lambda line: line["questions"][0]["asks"].update(v_Z={}), "v_Z"),
    ],
)
def test_a_line_that_the_head_does_not_know_is_named(
    small_class: Path, tmp_path: Path, change: Callable[[dict[str, Any]], None], unknown: str
) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    ask = line["questions"][0]["asks"]["v_B"]
    change(line)
    if unknown == "v_Z":
        line["questions"][0]["asks"]["v_Z"] = ask
    with pytest.raises(
        ExamError, match=rf"is broken \('{unknown}' is not in exam.json\) - expected it as"
    ):
        make_quiz_paper(source, PLAIN, read_line(line))


def test_a_value_that_builds_no_mechanism_is_told_with_its_paper(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    line["questions"][1]["drawn"]["h"] = "99"
    with pytest.raises(KinegradeError, match=rf"EXAM: paper {line['paper']}, q2: points.A: "):
        make_quiz_paper(source, PLAIN, read_line(line))


def test_the_asks_are_known_ahead_of_the_papers(small_class: Path) -> None:
    quiz = quiz_of(small_class / "EXAM", variants=2, wishes=QuizWishes(mistakes=False))
    ahead = list(quiz.asks)
    of_papers = [
        (question.sheet.identifier, ask)
        for paper in quiz.papers
        for question in paper.questions
        for ask in question.asks
    ]
    assert ahead == of_papers


def test_a_solution_has_graphs_where_those_of_the_exam_have(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    drawn = count_pictures(exam)
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    (exam / "exam.json").write_text(json.dumps(head | {"cycle": True}), encoding="utf-8")
    moving = [len(question.asks) for question in papers(exam, variants=1)[0].questions]
    assert count_pictures(exam) == [few + asked for few, asked in zip(drawn, moving, strict=True)]


def count_pictures(exam: Path) -> list[int]:
    """The pictures of each solution of the first paper."""
    (paper,) = papers(exam, variants=1, wishes=QuizWishes(solutions=True))
    return [len(question.solution.pictures) for question in paper.questions]
