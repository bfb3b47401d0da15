"""The recipe "Add a language" of CONTRIBUTING, followed on a copy with a language that nobody speaks;
each of its steps left out, one by one, is refused by name.
"""

from __future__ import annotations

import csv
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from babel.messages.catalog import Message

from tests.language.catalogue_faults import (
    NOUN,
    find_catalogue_faults,
    read_catalogue,
    read_messages,
)
from tests.language.update import update_language, write_catalogue
from tests.problem.crank import crank_text
from tests.problem.test_languages import ONLY_ENGLISH
from tests.recipes.recipe import copy_package, run

NEW = "qq"
MARK = "Qq"  # begins every text of the language
LETTERS = re.compile(r"[A-Za-z]{2}")
WORDS = re.compile(r"\b[a-z]{3,}\b")  # of a sentence: names and codes have capitals
PLACES = re.compile(r"<[A-Za-z:_]+>|\$[^$]*\$")
LANGUAGE = {"tag": NEW, "decimal-mark": ",", "forms": "nominative dative"}
BANK = """title = {{ en = "T", {new} = "{mark} T" }}
course = "C"
[[questions]]
template = "crank.toml"
"""
TEMPLATE = f"""title = "{MARK} crank"
statement = "{MARK} {{{{ r }}}} turns with {{{{ omega }}}}, $A$ above $O$ {{{{ h.value }}}}."
[parameters]
r = "{MARK} length"
h = "{MARK} height"
omega = "{MARK} angular velocity"
[asks]
v_x = "{MARK} along x"
v_y = "{MARK} along y"
"""


@pytest.fixture(scope="module")
def room(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package with the new language in all steps, and an exam's files."""
    folder = copy_package(tmp_path_factory.mktemp("language"))
    begin_catalogue(folder)
    translate_catalogue(folder)
    (folder / "bank.toml").write_text(BANK.format(new=NEW, mark=MARK), encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(*ONLY_ENGLISH), encoding="utf-8")
    (folder / f"crank.{NEW}.toml").write_text(TEMPLATE, encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n1,Ann\n2,Bo\n", encoding="utf-8")
    return folder


def catalogues(folder: Path) -> Path:
    return folder / "kinegrade" / "language" / "catalogues"


def begin_catalogue(folder: Path) -> None:
    """Step 1."""
    update_language(NEW, catalogues(folder))


def translate_catalogue(folder: Path) -> None:
    """Steps 2 and 3."""
    files = catalogues(folder) / NEW
    for domain, catalog in read_catalogue(files).items():
        for message in catalog:
            if message.context is not None:
                message.string = translate(domain, message)
                message.flags &= {NOUN}
        write_catalogue(files / f"{domain}.po", catalog)


def translate(domain: str, message: Message) -> str | tuple[str, ...]:
    if domain == "language":
        return LANGUAGE.get(str(message.context), str(message.id))
    if isinstance(message.id, list | tuple):
        return tuple(map(marked, message.id))
    if NOUN in message.flags:
        return f"{marked(message.id)}|{marked(message.id)} dative"
    return marked(message.id)


def marked(text: str) -> str:
    """The text of the new language; what holds no word stays as it is."""
    return f"{MARK} {text}" if LETTERS.search(PLACES.sub("", text)) else text


def faults(folder: Path) -> list[str]:
    """Step 4."""
    return list(find_catalogue_faults(catalogues(folder) / NEW, catalogues(folder) / "en"))


def generate(folder: Path, *more: object) -> subprocess.CompletedProcess[str]:
    files = ("bank.toml", "roster.csv", "-o", "EXAM", "--force", "--reproducible", "words")
    return run(folder, "generate", *files, "--lang", NEW, "--jobs", 1, *more)


def test_an_exam_is_set_marked_and_explained_in_the_new_language(room: Path) -> None:
    assert faults(room) == []
    made = generate(room, "--also", "html")
    assert made.returncode == 0, made.stderr
    (page,) = sorted((room / "EXAM" / "papers").glob("*.html"))[:1]
    assert_only_new(page.read_text(encoding="utf-8"))
    write_answers(room)
    graded = run(room, "grade", "EXAM", "answers.csv", "-o", "MARKS")
    assert graded.returncode == 1, graded.stderr
    assert MARK in (room / "MARKS" / "complaints.csv").read_text(encoding="utf-8")
    told = run(room, "feedback", "EXAM", "MARKS", "-o", "FEEDBACK", "--format", "html", "--jobs", 1)
    assert told.returncode == 0, told.stderr
    for sheet in (room / "FEEDBACK").glob("*.html"):
        assert_only_new(sheet.read_text(encoding="utf-8"))
    reported = run(room, "report", "EXAM", "MARKS", "-o", "report.html")
    assert reported.returncode == 0, reported.stderr
    assert_only_new((room / "report.html").read_text(encoding="utf-8"))
    put = run(room, "quiz", "EXAM", "--to", "moodle-xml", "-o", "quiz.xml", "--jobs", 1)
    assert (put.returncode, MARK in (room / "quiz.xml").read_text(encoding="utf-8")) == (1, True)


def write_answers(folder: Path) -> None:
    with (folder / "EXAM" / "answers.csv").open(encoding="utf-8-sig", newline="") as stream:
        header, *rows = list(csv.reader(stream))
    rows[0][-1], rows[1][-1] = "?", "-0.5"
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([header, *rows])


def assert_only_new(page: str) -> None:
    """Every text of a page that has words begins as those of the new language."""
    plain = re.sub(r"<(style|script|svg|math)\b.*?</\1>", "", page, flags=re.DOTALL)
    texts = (text.strip() for text in re.split(r"<[^>]*>", plain))
    strangers = [text for text in texts if WORDS.search(text) and MARK not in text]
    assert strangers == []
    assert MARK in page


def test_the_terminal_speaks_the_new_language(room: Path) -> None:
    refused = run(room, "generate", "none.toml", "roster.csv", "-o", "E", LC_ALL="qq_QQ.UTF-8")
    assert refused.stderr.startswith(f"{MARK} error: none.toml: {MARK} ")
    assert f"{MARK} List the problem templates." in run(room, "list", "--help", LC_ALL=NEW).stdout


@pytest.fixture
def without(room: Path) -> Iterator[Path]:
    """The room, in which a step is undone; afterwards it is as before."""
    kept = room.parent / "kept"
    shutil.copytree(catalogues(room) / NEW, kept)
    translation = (room / f"crank.{NEW}.toml").read_text(encoding="utf-8")
    yield room
    shutil.rmtree(catalogues(room) / NEW, ignore_errors=True)
    shutil.copytree(kept, catalogues(room) / NEW)
    shutil.rmtree(kept)
    (room / f"crank.{NEW}.toml").write_text(translation, encoding="utf-8")


def test_without_a_catalogue_the_language_is_refused(without: Path) -> None:
    shutil.rmtree(catalogues(without) / NEW)
    refused = generate(without)
    assert refused.returncode == 2
    assert f'"{NEW}"' in refused.stderr
    assert "en" in refused.stderr


def test_a_catalogue_that_is_begun_names_every_entry_it_lacks(without: Path) -> None:
    shutil.rmtree(catalogues(without) / NEW)
    begin_catalogue(without)
    keys = read_messages(catalogues(without) / "en").keys()
    assert faults(without) == [f"{NEW}: {key}: not translated" for key in sorted(keys)]


def test_a_template_without_the_language_is_named(without: Path) -> None:
    (without / f"crank.{NEW}.toml").unlink()
    refused = generate(without)
    assert refused.returncode == 2
    assert "crank" in refused.stderr
    assert f"crank.{NEW}.toml" in refused.stderr
    assert "asks.v_x.means" in refused.stderr
