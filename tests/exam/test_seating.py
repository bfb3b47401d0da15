"""Groups, rooms, seats, languages and extra time of a roster: printed, sorted by, kept with the
exam, and used by what comes after; through the command line.
"""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.roster.roster import parse_roster
from tests.printed_text import read_pages
from tests.small_class import contents, generate, kinegrade, write_short_class

ROSTER = """student,name,group,room,seat,language,extra-time
007,Ann Lee,G1,Hall 7,A10,,25 %
0012,Ben Ho,G2,Hall 7,A2,,
0013,王伟,G2,教一-101,3,中文,30 min
0014,Cleo Ng,G1,教一-101,1,,
"""
LATE = "student,name,room,seat\n0015,Dan Oh,Hall 7,A1\n"


def write_seated_class(folder: Path, roster: str = ROSTER, header: str = "") -> Path:
    """A class with rooms."""
    write_short_class(folder, header)
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    return folder


def list_owners(file: Path) -> list[str]:
    """Whose papers a booklet holds, by the id at the foot of each page."""
    texts = read_pages(file)
    known = ("007", "0012", "0013", "0014", "0015")
    found = [next((each for each in known if f"\n{each}\n" in text), "") for text in texts]
    return list(dict.fromkeys(filter(None, found)))


def read_first_page(file: Path) -> str:
    """The text of a paper's first page without blanks."""
    return "".join(PdfReader(file).pages[0].extract_text().split())


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of that class."""
    folder = write_seated_class(tmp_path_factory.mktemp("seated"))
    result = generate(folder, "EXAM", "--solutions")
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def test_papers_lie_by_room_and_seat(exam: Path) -> None:
    assert list_owners(exam / "papers.pdf") == ["0012", "007", "0014", "0013"]
    with (exam / "answers.csv").open(encoding="utf-8-sig", newline="") as lines:
        assert [row[0] for row in csv.reader(lines)][1:] == ["0012", "007", "0014", "0013"]


def test_each_room_has_a_booklet(exam: Path) -> None:
    assert sorted(each.name for each in (exam / "rooms").iterdir()) == [
        "Hall-7.pdf",
        "教一-101.pdf",
    ]
    assert list_owners(exam / "rooms" / "Hall-7.pdf") == ["0012", "007"]
    assert list_owners(exam / "rooms" / "教一-101.pdf") == ["0014", "0013"]


def test_spare_papers_have_a_booklet_too(tmp_path: Path) -> None:
    folder = write_seated_class(tmp_path)
    assert generate(folder, "EXAM", "--spare", "2").exit_code == 0
    codes = [each.paper for each in open_exam(folder / "EXAM").head.spares]
    pages = "\n".join(read_pages(folder / "EXAM" / "rooms" / "spare.pdf"))
    assert [code for code in codes if code not in pages] == []
    assert kinegrade("assign", folder / "EXAM", codes[0], "0099").exit_code == 0
    assert codes[0] not in "\n".join(read_pages(folder / "EXAM" / "rooms" / "spare.pdf"))


def test_the_head_of_a_paper_says_where_and_how_long(exam: Path) -> None:
    text = read_first_page(exam / "papers" / "007.pdf")
    assert [each for each in ("GroupG1", "RoomHall7", "SeatA10", "Extratime25%") if each in text]
    assert "Extratime" not in read_first_page(exam / "papers" / "0012.pdf")


def test_a_paper_and_its_solutions_are_in_the_students_language(exam: Path) -> None:
    own = read_first_page(exam / "papers" / "0013.pdf")
    assert [
        each for each in ("期中测验", "考场教一-101", "延长时间30分钟") if each not in own
    ] == []
    assert "Midterm" in read_first_page(exam / "papers" / "0014.pdf")
    assert "期中测验" in read_first_page(exam / "solutions" / "0013.pdf")


def test_a_paper_is_printed_again_as_it_was(exam: Path) -> None:
    again = kinegrade("paper", exam, "0013")
    assert again.stdout_bytes == (exam / "papers" / "0013.pdf").read_bytes()
    solution = kinegrade("paper", exam, "0013", "--solution")
    assert solution.stdout_bytes == (exam / "solutions" / "0013.pdf").read_bytes()


def test_the_exam_folder_keeps_what_the_roster_says(exam: Path) -> None:
    kept = open_exam(exam).head.candidates["0013"]
    assert (kept.group, kept.room, kept.seat, kept.language, kept.extra_time) == (
        "G2",
        "教一-101",
        "3",
        "zh",
        "30 min",
    )


def test_feedback_and_report_follow(exam: Path, tmp_path: Path) -> None:
    answers = (exam / "answers.csv").read_text(encoding="utf-8-sig").splitlines()
    filled = [answers[0], *(line.replace(",,", ",1,", 1) for line in answers[1:])]
    (tmp_path / "answers.csv").write_text("\n".join(filled), encoding="utf-8")
    marked = kinegrade("grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    assert marked.exit_code == 0, marked.stderr
    sheets = ("feedback", exam, tmp_path / "MARKS", "--format", "md", "-o")
    assert kinegrade(*sheets, tmp_path / "OWN").exit_code == 0
    assert "学号" in (tmp_path / "OWN" / "sheets" / "0013.md").read_text(encoding="utf-8")
    assert "学号" not in (tmp_path / "OWN" / "sheets" / "0014.md").read_text(encoding="utf-8")
    assert kinegrade(*sheets, tmp_path / "ALL", "--lang", "en").exit_code == 0
    assert "学号" not in (tmp_path / "ALL" / "sheets" / "0013.md").read_text(encoding="utf-8")
    page = tmp_path / "report.html"
    assert kinegrade("report", exam, tmp_path / "MARKS", "-o", page).exit_code == 0
    text = page.read_text(encoding="utf-8")
    assert text.count("<h2>Groups</h2>") == 1
    assert "<tr><td>G1</td>" in text
    assert "<tr><td>G2</td>" in text


def test_a_late_student_joins_a_room_and_a_changed_room_is_refused(tmp_path: Path) -> None:
    folder = write_seated_class(tmp_path)
    assert generate(folder).exit_code == 0
    before = contents(folder / "EXAM")
    (folder / "late.csv").write_text(LATE, encoding="utf-8")
    files = (folder / "bank.toml", folder / "roster.csv", "-o", folder / "EXAM")
    added = kinegrade("generate", *files, "--add", folder / "late.csv")
    assert added.exit_code == 0, added.stderr
    after = contents(folder / "EXAM")
    assert after["rooms/教一-101.pdf"] == before["rooms/教一-101.pdf"]
    assert list_owners(folder / "EXAM" / "rooms" / "Hall-7.pdf") == ["0015", "0012", "007"]
    (folder / "roster.csv").write_text(ROSTER.replace("Hall 7,A2", "Hall 8,A2"), encoding="utf-8")
    (folder / "late.csv").write_text(LATE.replace("0015", "0016"), encoding="utf-8")
    refused = kinegrade("generate", *files, "--add", folder / "late.csv")
    assert refused.exit_code == 2
    assert 'room "Hall 8" of student "0012"' in refused.stderr


def test_rooms_may_change_before_papers_are_printed(tmp_path: Path) -> None:
    folder = write_seated_class(tmp_path)
    assert generate(folder).exit_code == 0
    (folder / "roster.csv").write_text(ROSTER.replace("Hall 7", "Hall 8"), encoding="utf-8")
    result = generate(folder, "EXAM", "--force", "--accept-changes")
    assert result.exit_code == 0, result.stderr
    assert "4 papers keep their numbers" in result.stderr
    assert "this changed: room of " in result.stderr
    assert not (folder / "EXAM" / "rooms" / "Hall-7.pdf").exists()
    (folder / "roster.csv").write_text("student,name\n007,Ann\n", encoding="utf-8")
    assert generate(folder, "PLAIN").exit_code == 0
    assert not (folder / "PLAIN" / "rooms").exists()


def test_students_without_a_room_are_not_lost(tmp_path: Path) -> None:
    folder = write_seated_class(tmp_path, ROSTER.replace("Hall 7,A2", ","))
    result = generate(folder)
    assert result.exit_code == 1
    assert "room: nothing for 1 student, 0012" in result.stderr
    assert list_owners(folder / "EXAM" / "rooms" / "without-room.pdf") == ["0012"]


def test_a_language_that_the_exam_lacks_is_refused(tmp_path: Path) -> None:
    folder = write_seated_class(tmp_path, ROSTER.replace("中文", "Deutsch"))
    refused = generate(folder)
    assert refused.exit_code == 2
    first, *rest = refused.stderr.splitlines()
    assert first == (
        "error: roster.csv: 1 student wants a paper in de - complete the texts named below, or do "
        "without the column: --column language="
    )
    assert rest[0].startswith("error: bank: ")
    assert generate(folder, "EXAM", "--column", "language=").exit_code == 0


def test_the_order_of_a_pile() -> None:
    text = "id,name,room,seat,group\n1,A,,,b\n2,B,H10,2,\n3,C,H2,10,\n4,D,H2,9,\n5,E,,,a\n"
    seated = parse_roster(text.encode(), "roster.csv").seated
    assert [each.student for each in seated.students] == ["4", "3", "2", "5", "1"]


@pytest.mark.left(beside="test_the_head_of_a_paper_says_where_and_how_long")
@pytest.mark.needs_tex
def test_latex_prints_the_same_heads(tmp_path: Path) -> None:
    lines = ROSTER.splitlines(keepends=True)
    header = '[header]\nduration = { en = "2 hours", zh = "两小时" }\n\n'
    folder = write_seated_class(tmp_path, "".join((lines[0], lines[1], lines[3])), header)
    result = generate(folder, "EXAM", "--engine", "latex")
    assert result.exit_code == 0, result.stderr
    text = read_first_page(folder / "EXAM" / "papers" / "007.pdf")
    assert "Duration2hours" in text
    assert "Extratime25%" in text
    assert "RoomHall7" in text
    assert "延长时间30分钟" in read_first_page(folder / "EXAM" / "papers" / "0013.pdf")
