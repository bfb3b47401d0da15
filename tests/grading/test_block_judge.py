"""A class marked in blocks gets, answer by answer, what deciding each answer exactly gives."""

from __future__ import annotations

import csv
import gc
import json
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.columns.part import PartKeys
from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.files.tables import parse_table
from kinegrade.grading.fast.block_judge import BlockJudge
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.judging.trivial_answers import Own
from kinegrade.grading.marking import MarkingTerms, mark
from kinegrade.grading.marks import Mark
from kinegrade.grading.policy.accepted import alternatives
from kinegrade.grading.policy.reading import read_policy
from kinegrade.grading.sheets import grid_entries
from kinegrade.grading.sheets.class_sheet import read_sheet
from tests.grading.one_by_one import marks_one_by_one
from tests.said import said

ASKS = {"q1": ("v_A", "v_B", "omega"), "q2": ("phi",)}
UNITS = {"v_A": "m/s", "v_B": "m/s", "omega": "rad/s", "phi": "deg"}
COLUMNS = [f"{question}.{ask}" for question, asks in ASKS.items() for ask in asks]
TOLERANCES: list[dict[str, Any]] = [
    {"relative": 0.01, "absolute": 0}, {"relative": 0, "absolute": 0.02}, {"relative": 0, "absolute": 0},
    {"relative": 0.02, "absolute": 0.005, "figures": 3}, {"relative": 0, "absolute": 0, "figures": 2},
]  # fmt: skip
MISTAKES = (
    "sense-reversed", "coriolis-dropped", "wrong-pole", "power-of-ten-up", "=odd", "angle.phi", "angle.psi"
)  # fmt: skip
POLICIES = (
    "",
    "attempts = 'best'\ntolerance = { relative = '2 %' }",
    "attempts = 'first'\n[questions.q1]\nvoid = 'full'",
    "tolerance = { figures = 2 }\ncredit = { mistakes = { wrong-pole = '1/2', coriolis-dropped = "
    "'1/2' } }",
    "credit = { wrong-unit = '1/3' }\n[questions.q1.asks.v_A]\npoints = 1.5\n"
    "accept = [{ value = '2*v_B', credit = '1/4' }, { value = 3 }]\n[questions.q2]\nvoid = 'drop'",
)


def key_of(ask: str, random: Random) -> dict[str, Any]:
    """Values that are nice, irrational, tiny or large; mistakes that lie apart, agree, or stand on
    each other.
    """
    value = random.choice(
        [
            Fraction(random.randint(-60, 60), random.choice([1, 2, 5, 7, 8, 30])),
            Fraction(random.randint(1, 10**12), 10 ** random.randint(6, 16)),
        ]
    )
    decimal = f"{float(value)!r}" if random.random() < 0.5 else f"{float(value):.17f}"
    exact = str(value) if random.random() < 0.5 else random.choice([None, "sqrt(3)"])
    if exact != str(value):
        value = Fraction(decimal)
    wrong = [-value, value * 2, value * Fraction(21, 20), value * 10, value * Fraction(2001, 1000)]
    mistakes = {
        name: f"{float(random.choice(wrong)):.9g}" for name in MISTAKES if random.random() < 0.8
    }
    entry = {
        "exact": exact,
        "value": float(value),
        "unit": UNITS[ask],
        "decimal": decimal,
        "points": 2,
        "tolerance": random.choice(TOLERANCES),
        "mistakes": mistakes,
    }
    return entry | ({"period": 360} if ask == "phi" and random.random() < 0.7 else {})


def typed(entry: dict[str, Any], random: Random) -> str:
    """What people type, much of it on a bound of the tolerance or near one."""
    value = float(random.choice([entry["decimal"], *entry["mistakes"].values()]))
    spread = entry["tolerance"]["relative"] * abs(value) + entry["tolerance"]["absolute"]
    number = value + random.choice([0, 0, 1, -1, 0.3, 1.0001, 3]) * spread
    text = random.choice(
        [f"{number:.4g}", f"{number:.3f}", f"{number:.12f}", entry["decimal"], f"{number:.2e}"]
    )
    return random.choice(
        [text] * 8
        + [
            text.replace(".", ","),
            f"{text} {entry['unit']}",
            f"{text} kg",
            "",
            "-",
            "?",
            "=1+1",
            f"+{abs(number):.3f}",
            "√3",
            f"{'-' * (number < 0)}√({number**2:.9f})",
            f"{number * 100:.5f} cm/s",
            "1,234",
            f"{text}\n",
            "0",
        ]
    )


def write_class(folder: Path, random: Random, students: int) -> None:
    """A random exam folder with answers.csv beside it; some students hand in twice, some not at
    all.
    """
    names = [f"{number:03}" for number in range(students)]
    papers = [
        {
            "student": name,
            "questions": [
                {"question": question, "asks": {ask: key_of(ask, random) for ask in asks}}
                for question, asks in ASKS.items()
            ],
        }
        for name in names
    ]
    head = {
        "format": 1,
        "language": "en",
        "students": [{"student": name, "name": f"=x{name}"} for name in names],
        "questions": [
            {
                "question": question,
                "asks": [{"ask": ask, "unit": UNITS[ask], "points": 2} for ask in asks],
            }
            for question, asks in ASKS.items()
        ],
    }
    (folder / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    (folder / "key.jsonl").write_text(
        "".join(f"{json.dumps(each)}\n" for each in random.sample(papers, students)),
        encoding="utf-8",
    )
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["student", *COLUMNS])
        for paper in random.choices(papers, k=students):
            entries = [
                entry for question in paper["questions"] for entry in question["asks"].values()
            ]
            writer.writerow([paper["student"], *(typed(entry, random) for entry in entries)])


def one_and_a_half(student: str, question: str, own: Own, later: str) -> tuple[Fraction, ...]:
    """Follow-through by a simple rule: the sum of the own answers, doubled."""
    return (2 * sum(own.values(), Fraction(0)),) if later != "v_A" else ()


@given(st.integers(0, 10**9), st.sampled_from(POLICIES), st.booleans())
def test_blocks_say_what_deciding_one_by_one_says(seed: int, policy: str, follow: bool) -> None:
    with TemporaryDirectory() as name:
        folder, random = Path(name), Random(seed)
        write_class(folder, random, 12)
        (folder / "policy.toml").write_text(policy, encoding="utf-8")
        exam, whole = open_exam(folder), read_whole(open_exam(folder))
        sheet = read_sheet(parse_table((folder / "answers.csv").read_bytes(), "answers.csv"), exam)
        rules = read_policy(folder / "policy.toml", exam)
        accepted, follows = (
            alternatives(exam, rules, exam),
            Follows(one_and_a_half) if follow else None,
        )
        expected = written(marks_one_by_one(whole, sheet, rules, accepted, follows))
        terms = MarkingTerms(rules, accepted, follows=follows)
        for one in (exam, whole):
            assert written(mark(one, sheet, terms).marks) == expected
        write_columns(folder / KEY_COLUMNS, folder / KEY, exam.head)
        by_columns = open_exam(folder)
        assert [
            paper for paper in by_columns.papers() if not isinstance(paper.keys, PartKeys)
        ] == []
        assert written(mark(by_columns, sheet, terms).marks) == expected


def written(marks: Iterable[Mark]) -> list[Mark]:
    """The marks with their reasons as marks.csv has them."""
    return [
        replace(
            each, verdict=replace(each.verdict, reason=said(each.verdict.reason), comparison="")
        )
        for each in marks
    ]


def test_the_size_of_blocks_changes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_class(tmp_path, Random(5), 40)
    (tmp_path / "policy.toml").write_text(POLICIES[3], encoding="utf-8")
    texts = []
    for number, (size, large) in enumerate(((1, 10_000), (7, 1), (1000, 1))):
        monkeypatch.setattr(grid_entries, "_FEW", size)
        monkeypatch.setattr(grid_entries, "_MANY", size)
        monkeypatch.setattr(grid_entries, "_LARGE", large)
        folder = tmp_path / f"MARKS{number}"
        grade(
            open_exam(tmp_path),
            tmp_path / "answers.csv",
            folder,
            MarkingWishes(policy=tmp_path / "policy.toml", follows=Follows(one_and_a_half)),
        )
        texts.append({file.name: file.read_bytes() for file in folder.iterdir()})
    assert texts[0] == texts[1] == texts[2]


def test_a_block_is_let_go_before_the_next(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_class(tmp_path, Random(5), 8)
    held: list[int] = []
    judged = BlockJudge.judged

    def count_held(*given: Any) -> JudgedBlock:
        held.append(sum(type(each) is JudgedBlock for each in gc.get_objects()))
        return judged(*given)

    monkeypatch.setattr(grid_entries, "_FEW", 2)
    monkeypatch.setattr(BlockJudge, "judged", count_held)
    grade(open_exam(tmp_path), tmp_path / "answers.csv", tmp_path / "MARKS")
    assert held == [0, 0, 0, 0]


def test_follow_through_is_asked_about_only_after_two_errors(tmp_path: Path) -> None:
    write_class(tmp_path, Random(1), 1)
    entries = json.loads((tmp_path / "key.jsonl").read_text(encoding="utf-8"))["questions"][0][
        "asks"
    ]
    asked: list[tuple[str, str, set[str], str]] = []

    def follows(student: str, question: str, own: Own, later: str) -> tuple[Fraction, ...]:
        asked.append((student, question, set(own), later))
        return (Fraction(carried_on),)

    def kinds(first: str, second: str, third: str) -> list[str]:
        (tmp_path / "answers.csv").write_text(
            f"student,{','.join(COLUMNS[:3])}\n000,{first},{second},{third}\n", encoding="utf-8"
        )
        exam = open_exam(tmp_path)
        sheet = read_sheet(
            parse_table((tmp_path / "answers.csv").read_bytes(), "answers.csv"), exam
        )
        marks = mark(exam, sheet, MarkingTerms(follows=Follows(follows))).marks
        return [each.verdict.kind for each in marks][:3]

    right = [entries[ask]["decimal"] for ask in ASKS["q1"]]
    off = f"{7.7 * float(entries['v_A']['decimal']):.3f}"
    carried_on = f"{7.7 * float(entries['omega']['decimal']):.3f}"
    assert kinds(off, right[1], right[2])[1:] == ["right", "right"]
    assert asked == []
    assert kinds(off, right[1], carried_on)[1:] == ["right", "follow-through"]
    assert asked
    assert [each for each in asked if each != ("000", "q1", {"v_A"}, "omega")] == []


def test_nothing_is_asked_about_a_question_in_which_nothing_follows(tmp_path: Path) -> None:
    write_class(tmp_path, Random(1), 12)
    exam, asked = open_exam(tmp_path), set[str]()

    def follows(student: str, question: str, own: Own, later: str) -> tuple[Fraction, ...]:
        asked.add(question)
        return ()

    (tmp_path / "answers.csv").write_text(
        "student,q1.v_A,q1.v_B,q1.omega\n" + "".join(f"{each:03},71,72,73\n" for each in range(12)),
        encoding="utf-8",
    )
    table = parse_table((tmp_path / "answers.csv").read_bytes(), "answers.csv")
    sheet = read_sheet(table, exam)
    for possible in (lambda _: False, lambda question: question == "q1"):
        assert not asked
        mark(exam, sheet, MarkingTerms(follows=Follows(follows, possible=possible)))
    assert asked == {"q1"}
