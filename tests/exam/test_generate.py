"""`kinegrade generate`: the folder's exact contents, the same bytes for the same words, whole or
not at all.
"""

from __future__ import annotations

import codecs
import json
import os
import sys
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import pikepdf
import pytest
from openpyxl import load_workbook
from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.problem.template.library.library import find_shipped, load_template
from tests.problem.crank import crank_text
from tests.small_class import (
    BANK,
    ROSTER,
    STUDENTS,
    asks_of,
    contents,
    generate,
    key_lines,
    kinegrade,
    table,
    write_class,
)

FILES = ["007.pdf", "0012.pdf", "a%2Fb.pdf", "%3D2.pdf"]
TOP = [
    "INSTRUCTOR-ONLY.txt",
    "answers.csv",
    "answers.xlsx",
    "bank.toml",
    "exam.json",
    "key.jsonl",
    "key.npz",
    "key.pdf",
    "papers",
    "papers.pdf",
    "templates",
]
SHORT = '[[questions]]\ntemplate = "crank.toml"\ndraw = { omega = [2, 3, 4] }\n'
NO_PANDOC = "pandoc not found - expected the optional extra - pip install 'kinegrade[word]'"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_class(tmp_path)


@pytest.fixture
def exam(small_class: Path) -> Path:
    return small_class / "EXAM"


def refused(folder: Path, *options: str) -> list[str]:
    """The lines of the refusal; nothing may have been written."""
    before = sorted(entry.name for entry in folder.iterdir())
    result = generate(folder, "NEW", *options)
    assert result.exit_code == 2
    assert sorted(entry.name for entry in folder.iterdir()) == before
    lines = result.stderr.splitlines()
    assert lines
    assert [line for line in lines if not line.startswith("error: ")] == []
    return lines


def with_crank(folder: Path, bank: str, *changes: tuple[str, str]) -> None:
    (folder / "crank.toml").write_text(crank_text(*changes), encoding="utf-8")
    (folder / "bank.toml").write_text('title = "T"\ncourse = "C"\n' + bank, encoding="utf-8")


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


def test_key_lines_have_the_promised_shape(exam: Path) -> None:
    lines = key_lines(exam)
    assert [line["student"] for line in lines] == list(STUDENTS)
    for line in lines:
        assert list(line) == ["student", "paper", "place", "questions"]
        assert len(line["questions"]) == 3
        for question in line["questions"]:
            assert list(question) == ["question", "template", "parameters", "drawn", "asks"]
            assert list(question["drawn"]) == list(question["parameters"])
            assert [
                entry
                for entry in question["parameters"].values()
                if list(entry) != ["exact", "value", "unit"]
            ] == []
            for name, entry in question["asks"].items():
                mistakes = [] if name == "v_x" else ["mistakes"]  # which is zero whatever one does
                assert list(entry) == [
                    "exact",
                    "value",
                    "unit",
                    "decimal",
                    "tolerance",
                    "points",
                    *mistakes,
                ]
                assert list(entry["tolerance"]) == ["relative", "absolute"]
    assert asks_of(exam)["007", "q1.a_B"]["points"] == 2.5
    assert asks_of(exam)["007", "q3.omega_AB"]["tolerance"] == {
        "relative": 0.005,
        "absolute": 0.001,
    }
    assert asks_of(exam)["007", "q2.v_y"]["tolerance"] == {"relative": 0, "absolute": 0.25}


def test_exact_texts_of_the_key_read_back_to_their_decimals(exam: Path) -> None:
    arithmetic = Balls(400)
    with arithmetic.context():
        for ask in asks_of(exam).values():
            number = evaluate(
                read_expression(ask["exact"]),
                {"pi": arithmetic.turns(1)},
                make_elementary_functions(arithmetic),
                arithmetic,
            )
            read_back, kept = Fraction(write_decimal(number, 40)), Fraction(ask["decimal"])
            assert abs(read_back - kept) <= abs(kept) / 10**35
            assert ask["value"] == float(kept)


def test_zero_answers_carry_an_absolute_tolerance(exam: Path) -> None:
    for line in key_lines(exam):
        values = line["questions"][1]["parameters"]
        zero = line["questions"][1]["asks"]["v_x"]
        assert (zero["exact"], zero["decimal"], zero["value"]) == ("0", "0", 0.0)
        speed = values["r"]["value"] * values["omega"]["value"]
        assert zero["tolerance"] == {"relative": 0.01, "absolute": pytest.approx(speed / 10**10)}


def test_grading_reads_the_exam(exam: Path) -> None:
    known = read_whole(open_exam(exam))
    assert [examinee.student for examinee in known.examinees] == list(STUDENTS)
    assert [ask.column for ask in known.asks] == [
        "q1.v_B",
        "q1.a_B",
        "q2.v_x",
        "q2.v_y",
        "q3.omega_AB",
        "q3.alpha_AB",
    ]
    for examinee in known.examinees:
        for column, key in examinee.keys.items():
            ask = asks_of(exam)[examinee.student, column]
            relative, absolute = (
                Fraction(str(ask["tolerance"][name])) for name in ("relative", "absolute")
            )
            assert key.rule.room(key.value) == max(relative * abs(key.value), absolute) > 0


def test_the_answer_sheet_is_blank_and_runs_nothing(exam: Path) -> None:
    rows = table(exam / "answers.csv")
    assert [row["student"] for row in rows] == list(STUDENTS)
    assert [row["name"] for row in rows] == ["王伟", "O'Neil, Zoë", "'=HYPERLINK(1)", "Ann"]
    assert list(rows[0]) == [
        "student",
        "name",
        "q1.v_B",
        "q1.a_B",
        "q2.v_x",
        "q2.v_y",
        "q3.omega_AB",
        "q3.alpha_AB",
    ]
    assert all(value == "" for row in rows for name, value in row.items() if "." in name)


def test_ids_keep_their_zeros_in_a_spreadsheet(exam: Path) -> None:
    sheet = load_workbook(exam / "answers.xlsx").active
    rows = [[cell.value for cell in row] for row in sheet.iter_rows()]
    own, asks = rows[1][:3], [str(name).partition(" ")[0] for name in rows[1][3:]]
    assert own == ["student", "name", "paper"]
    assert asks == list(table(exam / "answers.csv")[0])[2:]
    assert [row[0] for row in rows[2:]] == list(STUDENTS)
    assert rows[4][1] == "=HYPERLINK(1)"
    cells = [cell for row in sheet.iter_rows(min_row=2) for cell in row]
    assert {cell.data_type for cell in cells if cell.value} == {"s"}
    assert {cell.number_format for cell in cells} == {"@"}


def test_a_spreadsheet_shows_the_names_of_the_answer_sheet(exam: Path) -> None:
    assert (exam / "answers.csv").read_bytes().startswith(codecs.BOM_UTF8)


def test_papers_are_pdf_in_print_order_and_do_not_name_the_secret(exam: Path) -> None:
    pages = []
    for name in FILES:
        data = (exam / "papers" / name).read_bytes()
        assert data.startswith(b"%PDF-")
        assert b"spring" not in data
        with pikepdf.open(exam / "papers" / name) as pdf:
            pages.append(len(pdf.pages))
            assert not pdf.attachments
            assert "spring" not in str(dict(pdf.docinfo))
    with pikepdf.open(exam / "papers.pdf") as whole:
        # Each begins on a sheet of its own
        assert len(whole.pages) == sum(count + count % 2 for count in pages)


def test_the_text_of_a_paper_does_not_hold_its_answers(exam: Path) -> None:
    answers = asks_of(exam)
    for student, name in zip(STUDENTS, FILES, strict=True):
        text = "".join(
            "".join(page.extract_text() for page in PdfReader(exam / "papers" / name).pages).split()
        )
        assert student in text
        digits = [
            ask["decimal"].lstrip("-")[:6] for (who, _), ask in answers.items() if who == student
        ]
        telling = [decimal for decimal in digits if len(decimal) == 6]
        assert telling
        assert not [decimal for decimal in telling if decimal in text]


def test_the_same_words_give_the_same_bytes_other_words_other_numbers(
    folder: Path, exam: Path
) -> None:
    assert generate(folder).exit_code == 0
    assert contents(folder / "EXAM") == contents(exam)
    assert generate(folder, "OTHER", "--reproducible", "autumn").exit_code == 0
    ours, others = key_lines(exam), key_lines(folder / "OTHER")
    assert all(
        one["questions"] != other["questions"] and one["paper"] != other["paper"]
        for one, other in zip(ours, others, strict=True)
    )


def test_chinese_papers_have_the_same_key(folder: Path, exam: Path) -> None:
    assert generate(folder, "EXAM", "--lang", "zh", "--paper-size", "letter").exit_code == 0
    assert (folder / "EXAM" / "key.jsonl").read_bytes() == (exam / "key.jsonl").read_bytes()
    record = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert (record["title"], record["course"], record["language"]) == ("期中测验", "力学", "zh")


def test_what_was_done_is_said_on_standard_error(folder: Path) -> None:
    (folder / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    result = generate(folder)
    assert result.exit_code == 0
    assert result.stdout == ""
    assert "q1: dealt from 16335 combinations of numbers\n" in result.stderr
    assert "1 paper; to hand them out: kinegrade papers " in result.stderr


def test_an_existing_folder_is_kept_unless_it_is_kinegrades_own(folder: Path) -> None:
    (folder / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    assert generate(folder).exit_code == 0
    before = contents(folder / "EXAM")
    result = generate(folder, "EXAM", "--reproducible", "autumn")
    assert (result.exit_code, contents(folder / "EXAM")) == (2, before)
    (line,) = result.stderr.splitlines()
    assert "EXAM: already exists - expected a new folder - add --force to replace it" in line
    again = generate(folder, "EXAM", "--reproducible", "autumn", "--force", "--new-numbers")
    assert again.exit_code == 0
    assert contents(folder / "EXAM")["key.jsonl"] != before["key.jsonl"]
    (folder / "EXAM" / "my notes.txt").write_text("mine")
    assert "holds my notes.txt, which would be lost" in generate(folder, "EXAM", "--force").stderr
    (folder / "thesis").mkdir()
    (folder / "thesis" / "chapter.tex").write_text("mine")
    assert "was not written by kinegrade" in generate(folder, "thesis", "--force").stderr


@pytest.mark.parametrize(
    ("roster", "fault"),
    [
        ("student,name\n1,Ann\n1,Bob\n", 'student id "1" stands on lines 2 and 3'),
        ("who,name\n1,Ann\n", 'no column for "student"'),
        ("student,name\n,Ann\n", 'no student id ("Ann")'),
        ("student,name\n", "has no students"),
        ("", "is empty"),
    ],
)
def test_a_faulty_roster_is_refused(folder: Path, roster: str, fault: str) -> None:
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith("error: roster.csv:")
    assert fault in line


def test_an_unknown_template_is_refused(folder: Path) -> None:
    (folder / "bank.toml").write_text(
        BANK.replace('"slider-crank"', '"slider-crnk"'), encoding="utf-8"
    )
    (line,) = refused(folder)
    assert 'questions[1].template: no template "slider-crnk": did you mean "slider-crank"?' in line


def test_a_question_of_which_nothing_is_good_leaves_nothing(folder: Path) -> None:
    with_crank(
        folder,
        '[[questions]]\ntemplate = "slider-crank"\n'
        '[[questions]]\ntemplate = "crank.toml"\ndraw = { omega = [5000000] }\n',
    )
    (line,) = refused(folder)
    assert line.startswith("error: q2 (crank): none of the 6 combinations of values is fit for")
    assert line.endswith("- state more values in the question, as in draw = { r = [...] }")


def test_a_page_that_cannot_be_typeset_leaves_nothing(folder: Path) -> None:
    with_nonsense(folder)
    (line,) = refused(folder)
    assert "q1, statement" in line
    assert "nonsense" in line


def test_the_place_of_what_cannot_be_typeset_is_named_in_the_language_of_the_terminal(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    with_nonsense(folder)
    result = generate(folder, "NEW")
    assert result.exit_code == 2
    assert "q1，题干" in result.stderr


def with_nonsense(folder: Path) -> None:
    """The statement holds a command that no typesetter knows."""
    with_crank(folder, SHORT, ("above $O$.", r"above $\nonsense{O}$."))


def test_a_name_that_no_font_prints_does_not_stop_an_exam(folder: Path) -> None:
    (folder / "roster.csv").write_text(ROSTER.replace("王伟", "😀 王"), encoding="utf-8")
    result = generate(folder)
    assert result.exit_code == 1
    assert (
        "complaint: 007: the name has characters that no font prints, they stand as code points"
        in result.stderr
    )
    assert sorted(entry.name for entry in (folder / "EXAM" / "papers").iterdir()) == sorted(FILES)


@pytest.mark.parametrize("option", ["--seed", "--reproducible"])
@pytest.mark.parametrize("text", ["", "  ", "\udcff"])
def test_a_label_and_words_must_be_some_text(folder: Path, option: str, text: str) -> None:
    result = generate(folder, "EXAM", option, text)
    assert result.exit_code == 2
    assert "expected some text, like spring-2026" in result.stderr
    assert not (folder / "EXAM").exists()


@pytest.mark.parametrize(
    ("character", "code", "shown"),
    [("😀", "U+1F600", "[U+1F600]"), ("\u200b", "U+200B", ""), ("\x07", "U+0007", "[U+0007]")],
)
def test_an_id_that_does_not_print_does_not_stop_a_class(
    folder: Path, character: str, code: str, shown: str
) -> None:
    student = f"0{character}7"
    with_crank(folder, SHORT)
    (folder / "roster.csv").write_text(f"student,name\n1,Ann\n{student},Bob B.\n", encoding="utf-8")
    (line,) = refused(folder, "--strict")
    problem = f"roster.csv:3: student: the id of Bob B. has characters that do not print ({code})"
    assert line.startswith(f"error: {problem} - on the paper they are code points")
    result = generate(folder, "EXAM", "--solutions")
    assert result.exit_code == 1
    assert f"complaint: {problem}" in result.stderr
    exam = folder / "EXAM"
    assert [line["student"] for line in key_lines(exam)] == ["1", student]
    for printed in ("papers", "solutions"):
        (paper,) = (file for file in (exam / printed).iterdir() if file.name != "1.pdf")
        text = "".join(page.extract_text() for page in PdfReader(paper).pages)
        assert f"0{shown}7" in "".join(letter for letter in text if letter.isprintable())


def test_without_complaints_strict_changes_nothing(folder: Path) -> None:
    assert generate(folder, "EXAM", "--strict").exit_code == 0


def test_ids_that_spreadsheets_run_are_refused_unless_they_are_allowed(folder: Path) -> None:
    files = folder / "bank.toml", folder / "roster.csv"
    result = kinegrade("generate", *files, "-o", folder / "EXAM")
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith('error: roster.csv:5: student id "=2" (Ann) begins with =')
    assert not (folder / "EXAM").exists()


def test_a_missing_pandoc_is_reported_before_anything_is_drawn(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draw(*arguments: object) -> None:
        raise AssertionError("work was done in vain")

    monkeypatch.setattr("kinegrade.exam.generating.generate.deal_exam", draw)
    for module in (None, SimpleNamespace(get_pandoc_path=lambda: "/nowhere/pandoc")):
        monkeypatch.setitem(sys.modules, "pypandoc", module)
        (line,) = refused(folder, "--also", "html", "--also", "docx")
        assert line == f"error: html, docx: {NO_PANDOC}"


@pytest.mark.skipif(sys.platform != "linux", reason="names of any bytes")
def test_a_folder_whose_name_is_no_utf8_gets_its_exam(tmp_path: Path) -> None:
    write_class(tmp_path)
    target = tmp_path / os.fsdecode(b"EXAM-\xff")
    result = kinegrade("generate", *(tmp_path / "bank.toml", tmp_path / "roster.csv"), *(
        "-o", target, "--allow-odd-ids"))  # fmt: skip
    assert result.exit_code == 0, result.stderr
    assert (target / "papers.pdf").read_bytes().startswith(b"%PDF")
