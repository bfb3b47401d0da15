"""A variant of a pool is known by the text of its question alone, as a system gives that back:
without its mark-up.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.language import Language
from tests.lms.pooled_quiz import Drawn, download, perfect, pool
from tests.lms.test_canvas_pool import analysis, groups, pooled
from tests.problem.crank import crank_text
from tests.small_class import kinegrade, table

SHIPPED = (
    "slider-crank",
    "bar-through-swivelling-sleeve",
    "pose-cam-tappet",
    "planetary-gear-external-rim-velocities",
    "rolling-wheel-rim-points",
)
HEAD = """title = "Quiz"
course = "Mechanics"
tolerance = { relative = "1 %" }
"""
STUDENTS = ("S1", "S2", "S3", "S4")
TEXT_ALONE = ("Question", "Response")
# the crank turns either way, by a word and by a sign: the same numbers for four mechanisms
WORDS = (
    ("The crank {{ r }} turns with {{ omega }};", "The crank {{ r }} turns {{ sense }}, {{ s }};"),
    ("曲柄 {{ r }} 以 {{ omega }} 转动，", "曲柄 {{ r }} {{ sense }}，{{ s }}；"),
    (
        "[parameters]",
        '[text]\nsense = [{ if = "s > 0", en = "counter-clockwise with {{ omega }}", zh = "以 {{ '
        'omega }} 逆时针转动" }, '
        '{ en = "clockwise with {{ omega }}", zh = "以 {{ omega }} 顺时针转动" }]\n\n'
        '[parameters]\ns = { unit = "1", draw = [1, -1], means = { en = "sense", zh = "转向" } }',
    ),
    ('velocity = "omega"', 'velocity = "s*omega"'),
    ('v_x = "-omega*h"', 'v_x = "-s*omega*h"'),
)
WORDS_BANK = f"""{HEAD}
[[questions]]
template = "crank.toml"
draw = {{ h = ["1/2"], r = [1], omega = [2, -2], s = [1, -1] }}
asks = {{ v_x = 1 }}
"""
# an angular acceleration, which nothing that is asked needs
UNPRINTED = (
    ("with {{ omega }};", "with {{ omega }} {{ change }};"),
    ("转动，", "转动 {{ change }}，"),
    ('"omega" }', '"omega", acceleration = "alpha" }'),
    (
        "[parameters]",
        '[text]\nchange = [{ en = "and {{ alpha }}", zh = "，{{ alpha }}" }]\n\n[parameters]\n'
        'alpha = { unit = "rad/s^2", draw = [1, 2, 3, 4], means = { en = "rate", zh = "角加速度" } }',
    ),
)
UNPRINTED_BANK = f"""{HEAD}
[[questions]]
template = "crank.toml"
draw = {{ h = ["1/2"], r = [1], omega = [2] }}
asks = {{ v_x = 1 }}
"""


def set_exam(folder: Path, bank: str) -> Path:
    (folder / "bank.toml").write_text(bank, encoding="utf-8")
    rows = "".join(f"{student},Name\n" for student in STUDENTS)
    (folder / "roster.csv").write_text(f"student,name\n{rows}", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    words = "--reproducible", "spring"
    done = kinegrade("generate", *files, "-o", folder / "EXAM", *words)
    assert done.exit_code in (0, 1), done.output
    return folder / "EXAM"


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of some shipped templates."""
    questions = "".join(f'[[questions]]\ntemplate = "{name}"\npoints = 8\n' for name in SHIPPED)
    return set_exam(tmp_path_factory.mktemp("shipped"), HEAD + questions)


def moodle_rows(quiz: Path) -> list[tuple[str, list[Drawn], list[list[str]]]]:
    """Every student is put another variant than that of the own paper, and answers it right."""
    drawn = [
        [each[(place + 1) % len(each)] for each in pool(quiz).values()]
        for place in range(len(STUDENTS))
    ]
    return [(student, each, perfect(each)) for student, each in zip(STUDENTS, drawn, strict=True)]


def totals(exam: Path, responses: Path, source: str) -> list[str]:
    """The totals, and that nothing was complained of."""
    marks = responses.with_suffix(".marks")
    done = kinegrade("grade", exam, responses, "-o", marks, "--from", source)
    assert done.exit_code == 0, done.stderr
    return [row["total"] for row in table(marks / "grades.csv")]


@pytest.mark.sampled(2, by="form", first=1)
@pytest.mark.parametrize("form", ["cloze", "numerical"])
@pytest.mark.parametrize("language", ["en", "zh"])
def test_variants_of_shipped_templates_are_known_by_moodle_s_text_alone(
    shipped: Path, tmp_path: Path, language: Language, form: str
) -> None:
    quiz = tmp_path / "pool.xml"
    options = ("--variants", "4", "--lang", language, "--as", form, "-o", quiz)
    done = kinegrade("quiz", shipped, "--to", "moodle-xml", *options)
    assert done.exit_code in (0, 1), done.stderr
    (tmp_path / "r.csv").write_text(download(moodle_rows(quiz), TEXT_ALONE), encoding="utf-8-sig")
    assert totals(shipped, tmp_path / "r.csv", "moodle") == ["40"] * len(STUDENTS)


@pytest.mark.parametrize("language", ["en", "zh"])
def test_variants_of_shipped_templates_are_known_by_canvas_s_text(
    shipped: Path, tmp_path: Path, language: Language
) -> None:
    package = tmp_path / "pool.zip"
    pooled(shipped, package, 4, "--lang", language)
    answers = {
        student: [
            (variant, group[variant].right)
            for group in groups(package)
            for variant in [(place + 1) % len(group)]
        ]
        for place, student in enumerate(STUDENTS)
    }
    (tmp_path / "a.csv").write_text(analysis(package, answers), encoding="utf-8")
    assert totals(shipped, tmp_path / "a.csv", "canvas") == ["40"] * len(STUDENTS)


@pytest.mark.parametrize("language", ["en", "zh"])
def test_variants_that_differ_in_a_word_or_a_sign_alone_are_told_apart(
    tmp_path: Path, language: Language
) -> None:
    (tmp_path / "crank.toml").write_text(crank_text(*WORDS), encoding="utf-8")
    exam = set_exam(tmp_path, WORDS_BANK)
    package = tmp_path / "pool.zip"
    pooled(exam, package, 4, "--lang", language)
    [group] = groups(package)
    assert len({item.text for item in group}) == 4
    answers = {
        student: [((place + 1) % 4, group[(place + 1) % 4].right)]
        for place, student in enumerate(STUDENTS)
    }
    (tmp_path / "a.csv").write_text(analysis(package, answers), encoding="utf-8")
    assert totals(exam, tmp_path / "a.csv", "canvas") == ["1"] * 4


def test_variants_that_differ_in_what_is_not_printed_alone_count_as_one(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(crank_text(*UNPRINTED), encoding="utf-8")
    exam = set_exam(tmp_path, UNPRINTED_BANK)
    package = tmp_path / "pool.zip"
    pooled(exam, package, 4)
    [group] = groups(package)
    assert len({item.text for item in group}) == 1
    answers = {student: [(place, group[place].right)] for place, student in enumerate(STUDENTS)}
    (tmp_path / "a.csv").write_text(analysis(package, answers), encoding="utf-8")
    assert totals(exam, tmp_path / "a.csv", "canvas") == ["1"] * 4
