"""`kinegrade generate`: the folder's exact contents, and what it says of who got what."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.problem.template.library.library import find_shipped, load_template
from tests.exam.generate.written_class import FILES, TOP, refused
from tests.small_class import COLUMNS, STUDENTS, asks_of, generate


def test_the_folder_holds_what_it_promises_and_nothing_else(exam: Path) -> None:
    assert sorted(entry.name for entry in exam.iterdir()) == TOP
    assert sorted(entry.name for entry in (exam / "papers").iterdir()) == sorted(FILES)
    assert sorted(entry.name for entry in (exam / "templates").iterdir()) == [
        "bar-through-swivelling-sleeve.de.toml",
        "bar-through-swivelling-sleeve.toml",
        "crank.toml",
        "slider-crank.de.toml",
        "slider-crank.toml",
    ]
    assert "instructor only" in (exam / "INSTRUCTOR-ONLY.txt").read_text(encoding="utf-8")


def test_the_sources_are_kept_as_they_were(small_class: Path, exam: Path) -> None:
    assert (exam / "bank.toml").read_bytes() == (small_class / "bank.toml").read_bytes()
    assert (exam / "templates" / "crank.toml").read_bytes() == (
        small_class / "crank.toml"
    ).read_bytes()


def test_a_shared_mechanism_is_kept_so_that_the_folder_stands_alone(folder: Path) -> None:
    names = ("pose-four-bar-coupler", "pole-four-bar-coupler")
    entries = "".join(f'[[questions]]\ntemplate = "{name}"\n' for name in names)
    (folder / "bank.toml").write_text('title = "T"\ncourse = "C"\n' + entries, encoding="utf-8")
    assert generate(folder).exit_code == 0
    templates = folder / "EXAM" / "templates"
    kept = sorted(path.relative_to(templates).as_posix() for path in templates.rglob("*.toml"))
    assert kept == [
        "mechanisms/four-bar-with-coupler.toml",
        "pole-four-bar-coupler.toml",
        "pose-four-bar-coupler.toml",
    ]
    assert [name for name in names if load_template(name, templates) != load_template(name)] == []


def test_two_mechanisms_of_one_name_are_refused(folder: Path) -> None:
    own = find_shipped("templates")
    text = (own / "pose-four-bar-coupler.toml").read_text(encoding="utf-8")
    shared = (own / "mechanisms" / "four-bar-with-coupler.toml").read_text(encoding="utf-8")
    (folder / "mechanisms").mkdir()
    (folder / "mechanisms" / "four-bar-with-coupler.toml").write_text(
        shared + "# mine\n", encoding="utf-8"
    )
    (folder / "mine.toml").write_text(text, encoding="utf-8")
    entries = "".join(
        f'[[questions]]\ntemplate = "{name}"\n' for name in ("mine.toml", "pole-four-bar-coupler")
    )
    (folder / "bank.toml").write_text('title = "T"\ncourse = "C"\n' + entries, encoding="utf-8")
    assert refused(folder) == [
        "error: bank: templates of this bank share two different mechanisms named "
        '"four-bar-with-coupler": rename one file'
    ]


def test_exam_json_says_who_got_what(exam: Path) -> None:
    record = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert list(record) == [
        "format",
        "kinegrade",
        "warning",
        "title",
        "course",
        "date",
        "language",
        "paper_size",
        "engine",
        "pages",
        "reproducible",
        "questions",
        "students",
        "editable",
    ]
    assert (record["format"], record["title"], record["date"], record["reproducible"]) == (
        2,
        "Midterm",
        "2026-05-01",
        "spring",
    )
    assert [
        (entry["student"], entry["name"], entry.get("email", ""), entry["file"])
        for entry in record["students"]
    ] == [
        ("007", "王伟", "wei@example.org", "papers/007.pdf"),
        ("0012", "O'Neil, Zoë", "", "papers/0012.pdf"),
        ("a/b", "=HYPERLINK(1)", "", "papers/a%2Fb.pdf"),
        ("=2", "Ann", "", "papers/%3D2.pdf"),
    ]
    assert record["students"][0]["paper"] == "WJPK-SNPQ"
    assert (record["paper_size"], record["engine"]) == ("a4", "typst")
    q1, q2, q3 = record["questions"]
    assert (q1["question"], q1["template"], q1["points"], q1["combinations"]) == (
        "q1",
        "slider-crank",
        5.5,
        16335,
    )
    assert q1["asks"] == [
        {
            "ask": "v_B",
            "unit": "m/s",
            "sign": "not negative",
            "convention": "magnitude",
            "points": 3,
        },
        {
            "ask": "a_B",
            "unit": "m/s^2",
            "sign": "positive to the right ($+x$)",
            "convention": "+x",
            "points": 2.5,
        },
    ]
    assert (q2["combinations"], q3["points"]) == (9, 7)


def test_grading_reads_the_exam(exam: Path) -> None:
    known = read_whole(open_exam(exam))
    assert [examinee.student for examinee in known.examinees] == list(STUDENTS)
    assert [ask.column for ask in known.asks] == list(COLUMNS)
    for examinee in known.examinees:
        for column, key in examinee.keys.items():
            ask = asks_of(exam)[examinee.student, column]
            relative, absolute = (
                Fraction(str(ask["tolerance"][name])) for name in ("relative", "absolute")
            )
            assert key.rule.room(key.value) == max(relative * abs(key.value), absolute) > 0
