"""Questions of a bank's own, with named steps in place of a mechanism: dealt, printed, solved and
marked as those of templates are.
"""

from __future__ import annotations

import csv
import json
import shutil
from pathlib import Path
from unicodedata import normalize

import pytest
from pypdf import PdfReader

from tests.small_class import kinegrade, table

CAR = """title = { en = "Test", zh = "测验" }
course = "Mechanics"
credit = { mistakes = { half-forgotten = "1/2" } }

[[questions]]
name = "car-from-rest"
title = { en = "A car starts", zh = "汽车起步" }
statement = { en = "A car starts with {{ a }}; find $v$ and $s$ after {{ t }}.", zh = "汽车以 {{ a }} 起步，求 {{ t }} 后的 $v$ 和 $s$。" }
parameters.a = { unit = "m/s^2", draw = [2] }
parameters.t = { unit = "s", draw = [5] }
steps.v = "a*t"
steps.s = "v*t/2"
asks.v = { unit = "m/s", points = 3, means = { en = "its speed", zh = "速度" } }
asks.s = { unit = "m", points = 2.5, means = { en = "its way", zh = "路程" } }
mistakes.half-forgotten = { steps.s = "v*t", means = { en = "It is not at its final speed all the time.", zh = "平均速度是末速度的一半。" } }
same = true
"""
BALL = """
[[questions]]
name = "ball"
statement = "{{ u }}, {{ phi }}, {{ T }}, {{ d }}"
parameters.u = { unit = "km/h", draw = [72] }
parameters.phi = { unit = "deg", draw = [60] }
parameters.T = { unit = "s", draw = [2] }
parameters.d = { unit = "mm", draw = [500] }
steps.v_x = "u*cos(phi)"
steps.v_y = "-u*sin(phi)"
steps.beta = "atan(v_y/v_x)"
steps.omega = "2*pi/T"
steps.w = "omega*d"
steps.psi = "phi + omega*T/8"
asks.v_x = { unit = "m/s", points = 1, means = "one component" }
asks.v_y = { unit = "m/s", points = 1, means = "the other", sign = "+y" }
asks.beta = { unit = "deg", points = 1, means = "its direction", sign = "ccw" }
asks.w = { unit = "cm/s", points = 1, means = "the speed of the rim" }
asks.psi = { unit = "deg", points = 1, means = "an angle" }
same = true
"""
TURNS = """
[[questions]]
name = "turns"
statement = "{{ t }}"
parameters.t = { unit = "deg", draw = [105] }
steps.h = "atan2(sin(t), cos(t))"
steps.g = "h + pi/6"
steps.k = "t/2"
steps.j = "t/3"
asks.h = { unit = "deg", points = 1, means = "a direction", sign = "ccw" }
asks.g = { unit = "deg", points = 1, means = "another", sign = "ccw" }
asks.k = { unit = "deg", points = 1, means = "a third", sign = "ccw", cyclic = true }
asks.j = { unit = "deg", points = 1, means = "how far it has turned", sign = "ccw" }
same = true
"""
STUDENTS = "1001", "1002", "1003"
ROSTER = "student,name\n1001,Ada\n1002,Sofya\n1003,Lise\n"


def set_exam(folder: Path, bank: str, *options: str) -> Path:
    """The exam that a bank makes for three students."""
    (folder / "bank.toml").write_text(bank, encoding="utf-8")
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    made = kinegrade("generate", *files, "-o", folder / "EXAM", "--jobs", "1", *options)
    assert made.exit_code == 0, made.stderr
    return folder / "EXAM"


def read_pdf(path: Path) -> str:
    """The text of all pages in plain letters, without blanks."""
    text = "".join(page.extract_text() for page in PdfReader(path).pages)
    return "".join(normalize("NFKC", text).replace("·", "⋅").split())


def refuse(folder: Path, *changes: tuple[str, str]) -> list[str]:
    """What `sample` says of the car with these changes, line by line without the file."""
    bank = CAR
    for old, new in changes:
        assert bank.count(old) == 1, old
        bank = bank.replace(old, new)
    file = folder / "bank.toml"
    file.write_text(bank, encoding="utf-8")
    said = kinegrade("sample", file, "-o", folder / "sample.pdf")
    assert said.exit_code == 2
    return [line.replace(str(file), "bank") for line in said.stderr.splitlines()]


@pytest.fixture(scope="module")
def car(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the car with its worked solutions."""
    return set_exam(tmp_path_factory.mktemp("car"), CAR, "--solutions")


def read_key(exam: Path) -> dict[str, dict[str, object]]:
    """The asks of the first question of the first paper."""
    line = (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()[0]
    asks: dict[str, dict[str, object]] = json.loads(line)["questions"][0]["asks"]
    return asks


def test_the_answers_are_exact_and_the_authors_mistake_is_in_the_key(car: Path) -> None:
    asks = read_key(car)
    stated = {name: (ask["exact"], ask["unit"], ask["points"]) for name, ask in asks.items()}
    assert stated == {"v": ("10", "m/s", 3), "s": ("25", "m", 2.5)}
    mistakes = asks["s"]["mistakes"]
    assert isinstance(mistakes, dict)
    assert mistakes["half-forgotten"] == "50"
    assert "half-forgotten" not in dict(asks["v"]["mistakes"])  # type: ignore[call-overload]


def test_the_paper_has_no_figure_and_no_rule_of_axes(car: Path) -> None:
    paper = read_pdf(car / "papers" / "1001.pdf")
    assert "Acarstartswitha=2m/s2;findvandsaftert=5s." in paper
    assert "itsspeed" in paper
    assert "5.5points" in paper
    assert "Thexaxis" not in paper
    assert "drawntoscale" not in paper


def test_the_solution_goes_by_the_steps_in_symbols_and_in_numbers(car: Path) -> None:
    solution = read_pdf(car / "solutions" / "1001.pdf")
    assert "v=at=2m/s2⋅5s=10m/s" in solution
    assert "s=vt2=10m/s⋅5s2=25m" in solution
    assert "rounded" not in solution  # nothing is


def test_units_are_converted_and_angles_are_angles(tmp_path: Path) -> None:
    exam = set_exam(tmp_path, CAR.partition("[[")[0].replace("credit", "#") + BALL, "--solutions")
    asks = read_key(exam)
    values = {name: str(ask["decimal"])[:9] for name, ask in asks.items()}
    assert values == {
        "v_x": "10",  # 72 km/h cos 60°
        "v_y": "-17.32050",
        "beta": "-60",
        "w": "157.07963",  # 50 cm times pi
        "psi": "105",  # 60° and an eighth of a turn
    }
    solution = read_pdf(exam / "solutions" / "1001.pdf")
    assert "Numbersafter≈arerounded,to4significantdigits" in solution
    assert "InSIunits:u=72km/h=20m/sd=500mm=0.5m" in solution
    assert "20m/s⋅cos60°=10m/s" in solution
    assert "2π2s≈3.142rad/s" in solution
    assert "1.571m/s≈157.1cm/s" in solution


def test_a_direction_is_right_with_full_turns_more_or_less(tmp_path: Path) -> None:
    exam = set_exam(tmp_path, 'title = "T"\ncourse = "C"\n' + TURNS)
    answers = tmp_path / "answers.csv"
    turned = "465,-225,412.5,395", "105,135,52.5,35", "-255,495,-307.5,-325"
    rows = [f"{student},{cells}" for student, cells in zip(STUDENTS, turned, strict=True)]
    answers.write_text("\n".join(["student,q1.h,q1.g,q1.k,q1.j", *rows]), encoding="utf-8")
    marks = tmp_path / "MARKS"
    assert kinegrade("grade", exam, answers, "-o", marks).exit_code in (0, 1)
    earned = [[row["student"], row["total"]] for row in table(marks / "grades.csv")]
    assert earned == [["1001", "3"], ["1002", "4"], ["1003", "3"]]


@pytest.mark.left(beside="test_the_paper_has_no_figure_and_no_rule_of_axes")
def test_latex_and_chinese_print_the_same_question(tmp_path: Path) -> None:
    exam = set_exam(tmp_path, CAR, "--solutions", "--engine", "latex", "--lang", "zh")
    assert "汽车起步" in read_pdf(exam / "papers" / "1001.pdf")
    solution = read_pdf(exam / "solutions" / "1001.pdf")
    assert "10m/s⋅5s" in solution


@pytest.fixture(scope="module")
def marks(car: Path) -> Path:
    """One carries on from a slip, one makes the author's mistake, one is right."""
    answers = car.parent / "answers.csv"
    rows = ["student,q1.v,q1.s", "1001,10,25", "1002,12,30", "1003,10,50"]
    answers.write_text("\n".join(rows) + "\n", encoding="utf-8")
    marked = kinegrade("grade", car, answers, "-o", car.parent / "MARKS")
    assert marked.exit_code == 0, marked.stderr
    return car.parent / "MARKS"


def test_own_values_are_carried_on_and_the_authors_mistake_has_its_credit(marks: Path) -> None:
    with (marks / "marks.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = {(row["student"], row["ask"]): row for row in csv.DictReader(file)}
    verdicts = {place: (row["verdict"], row["points"]) for place, row in rows.items()}
    assert verdicts == {
        ("1001", "v"): ("right", "3"),
        ("1001", "s"): ("right", "2.5"),
        ("1002", "v"): ("wrong", "0"),
        ("1002", "s"): ("follow-through", "2.5"),  # 12 * 5 / 2
        ("1003", "v"): ("right", "3"),
        ("1003", "s"): ("mistake", "1.25"),
    }
    assert rows["1003", "s"]["mistakes"] == "half-forgotten"


def test_feedback_tells_the_mistake_in_the_authors_words(car: Path, marks: Path) -> None:
    folder = car.parent / "FEEDBACK"
    written = kinegrade("feedback", car, marks, "-o", folder, "--format", "md")
    assert written.exit_code == 0, written.stderr
    sheet = (folder / "sheets" / "1003.md").read_text(encoding="utf-8")
    assert "It is not at its final speed all the time." in sheet
    assert "## Question 1 · A car starts (4.25 / 5.5)" in sheet
    assert kinegrade("report", car, marks, "-o", car.parent / "report.html").exit_code == 0


@pytest.mark.parametrize("to", ["moodle-xml", "qti12", "qti21", "blackboard"])
def test_a_quiz_asks_it_without_a_figure(car: Path, to: str) -> None:
    quiz = car.parent / f"quiz.{to}"
    made = kinegrade("quiz", car, "--to", to, "--variants", "1", "--solutions", "-o", quiz)
    assert made.exit_code in {0, 1}, made.stderr  # 1 with complaints of what a system lacks
    assert quiz.stat().st_size > 500
    if to == "moodle-xml":
        text = quiz.read_text(encoding="utf-8")
        assert "It is not at its final speed all the time." in text
        assert "<file" not in text


def test_a_paper_is_printed_again_and_the_key_is_solved_again(car: Path) -> None:
    alone = car.parent / "alone.pdf"
    assert kinegrade("paper", car, "1002", "-o", alone).exit_code == 0
    assert alone.read_bytes() == (car / "papers" / "1002.pdf").read_bytes()
    assert "3 of 3 papers solved again" in kinegrade("verify", car).stderr


def test_a_late_student_gets_it_and_its_text_is_corrected(car: Path, tmp_path: Path) -> None:
    exam = Path(shutil.copytree(car, tmp_path / "EXAM"))
    late = tmp_path / "late.csv"
    late.write_text("student,name\n1004,Emmy\n", encoding="utf-8")
    files = car.parent / "bank.toml", car.parent / "roster.csv"
    added = kinegrade("generate", *files, "-o", exam, "--add", late)
    assert added.exit_code == 0, added.stderr
    kept = exam / "templates" / "car-from-rest.toml"
    corrected = tmp_path / "car-from-rest.toml"
    text = kept.read_text(encoding="utf-8").replace("A car starts with", "A lorry starts with")
    corrected.write_text(text, encoding="utf-8")
    again = kinegrade("reprint", exam, "--template", corrected, "--jobs", "1")
    assert again.exit_code == 0, again.stderr
    assert "Alorrystartswith" in read_pdf(exam / "papers" / "1004.pdf")
    corrected.write_text(text.replace("v*t/2", "v*t/3"), encoding="utf-8")
    assert kinegrade("reprint", exam, "--template", corrected).exit_code != 0
    corrected.write_text(text.replace("v*t/2", "v*t/2 + t"), encoding="utf-8")
    wrong = kinegrade("reprint", exam, "--template", corrected, "--accept-changes", "--jobs", "1")
    assert (wrong.exit_code, "steps.s: " in wrong.stderr) == (2, True), wrong.stderr


def test_all_faults_of_a_question_are_told_at_once(tmp_path: Path) -> None:
    changes = (
        ('"a*t"', '"b*t"'),
        ("asks.v = ", "asks.z = "),
        ("points = 2.5, ", ""),
        ("same = true", "smae = true"),
    )
    assert refuse(tmp_path, *changes) == [
        'error: bank:11: questions[1].steps.v: unknown name "b" - known here: a, pi, t',
        "error: bank:13: questions[1].asks.z: no step of that name - known here: s, v",
        "error: bank:14: questions[1].asks.s.points: missing - expected a number of zero or more "
        "like 2.5, at most 9 digits before the point and 12 after it",
        'error: bank:16: questions[1].smae: unknown key - did you mean "same" or "space"?',
    ]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"a*t"', '"s*t"', "[1].steps.v: the step s comes later - put each step after those that "
         "it names"),
        ('"a*t"', '"v*t"', "[1].steps.v: the step v comes later - put each step after those that "
         "it names"),
        ('"a*t"', '"__import__(1)"', '[1].steps.v: unknown function "__import__" - did you mean '
         '"sqrt(l**2 - h**2)", "tan(phi)" or "sin(phi)"? (all of them: kinegrade words points)'),
        ('"v*t/2"', '"v**99999"', "[1].steps.s: a power must be a whole number of at most 16: for "
         "roots write sqrt(...)"),
        ('unit = "m",', 'unit = "m/s",', '[1].asks.s.unit: this is a length (m): it cannot be '
         'counted in "m/s" - write unit = "m", or ask for something else'),
        ('steps.s = "v*t",', 'steps.s = "v",', "[1].mistakes.half-forgotten.steps.s: s: a length "
         "(m) and a velocity (m/s) do not go together - check the units"),
        ('steps.s = "v*t",', 'steps.s = "v*t/2",', "[1].mistakes.half-forgotten.steps.s: the step "
         "itself, which is no mistake"),
        ('steps.s = "v*t",', 'steps.z = "v*t",', "[1].mistakes.half-forgotten.steps.z: no step of "
         "that name - known here: s, v"),
        ('steps.s = "v*t",', "steps = {},", "[1].mistakes.half-forgotten.steps: missing - expected "
         'the steps that are mistaken, like steps.s = "v*t"'),
        ("mistakes.half-forgotten", "mistakes.Half", "[1].mistakes.Half: not usable as a name - expected "
         'small letters, digits and hyphens, like "half-forgotten"'),
        ("mistakes.half-forgotten", "mistakes.sense-reversed", "[1].mistakes.sense-reversed: "
         'kinegrade knows another mistake by the name "sense-reversed" - choose another name'),
        (" after {{ t }}.", ".", "[1].statement: the parameter t is not given to the student: "
         "write {{ t }}"),
        ('"car-from-rest"', '"../car"', '[1].name: "../car" - expected small letters, digits and '
         'hyphens, like "car-from-rest"'),
        ('steps.v = "a*t"\nsteps.s = "v*t/2"', "steps = {}", "[1].steps: missing - expected a "
         "table that every question with steps has"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(tmp_path: Path, old: str, new: str, said: str) -> None:
    credit = ('credit = { mistakes = { half-forgotten = "1/2" } }\n', "\n")
    first, *_ = refuse(tmp_path, credit, (old, new))
    assert first.split(": questions", 1)[1] == said


def test_far_too_many_steps_are_refused(tmp_path: Path) -> None:
    many = "\n".join(f'steps.k{number} = "a*t"' for number in range(40))
    (said,) = refuse(tmp_path, ('steps.v = "a*t"', f'steps.v = "a*t"\n{many}'))
    assert said.endswith("questions[1].steps: 42 steps - expected at most 40")


@pytest.mark.parametrize(
    ("formula", "why"),
    [
        ("v*t/(t/t - 1)", "car-from-rest: steps.s: division by zero"),
        ("-v*t/2", "s is negative, though papers would say that it is not"),
        ("v*t*10**9", "s is 50000000000 m"),
        ("v*sqrt(-t*t)", "car-from-rest: steps.s: "),
    ],
)
def test_draws_without_a_fit_answer_are_refused_with_the_reason(
    tmp_path: Path, formula: str, why: str
) -> None:
    (said,) = refuse(tmp_path, ('"v*t/2"', f'"{formula}"'))
    assert "q1 (car-from-rest): none of the 1 combination" in said
    assert f"; the first: {why}" in said


def test_only_draws_at_which_a_step_has_a_value_are_dealt(tmp_path: Path) -> None:
    bank = CAR.replace("draw = [5]", "draw = [4, 5, 6, 7]").replace("v*t/2", "v*t*t/(t - 5)")
    exam = set_exam(tmp_path, bank.replace("same = true", "repeats = true"))
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert head["questions"][0]["refused"] == {"degenerate": 2}


def test_a_draw_at_which_the_mistake_is_right_is_not_dealt(tmp_path: Path) -> None:
    bank = CAR.replace("draw = [5]", "draw = [2, 3, 4, 5]").replace(
        's = "v*t"', 's = "v*(t + 2)/4"'
    )
    exam = set_exam(tmp_path, bank.replace("same = true", ""))
    lines = (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    times = {json.loads(line)["questions"][0]["drawn"]["t"] for line in lines}
    assert times == {"3", "4", "5"}


def test_a_missing_language_and_two_explanations_are_complained_of(tmp_path: Path) -> None:
    (said,) = refuse(tmp_path, ('en = "its speed", ', ""))
    assert said == (
        'error: car-from-rest: no text in "en" (asks.v.means) - expected every text in "en" - '
        "write the missing ones into the bank, or use --lang zh"
    )
    (said,) = refuse(tmp_path, ('zh = "速度"', 'de = "v"'), ('en = "its speed", ', ""))
    assert said.endswith("- write the missing ones into the bank")
    entry = CAR[CAR.index("[[") :].replace("car-from-rest", "van").replace("It is not", "No:")
    (said,) = refuse(tmp_path, ("same = true\n", f"same = true\n{entry}"))
    assert said.endswith(
        'mistakes.half-forgotten: another question explains "half-forgotten" in other words - use '
        "the same words, or another name"
    )
    said, *_ = refuse(
        tmp_path, ("same = true\n", f"same = true\n{entry.replace('van', 'car-from-rest', 1)}")
    )
    assert said.endswith("- choose another name")


def test_steps_in_a_templates_file_are_refused(tmp_path: Path, car: Path) -> None:
    file = shutil.copy(car / "templates" / "car-from-rest.toml", tmp_path / "mine.toml")
    said = kinegrade("check", file)
    assert said.exit_code == 2
    assert said.stderr.splitlines()[0].endswith(
        "steps: steps in a template's file - write the question into a bank, as an entry "
        "[[questions]]"
    )
