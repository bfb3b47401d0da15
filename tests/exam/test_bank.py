"""A bank is read whole, exactly and safely; every fault of the file is told at once, with its
place.
"""

from __future__ import annotations

import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import BankError, ExamError
from kinegrade.exam.bank.bank import find_bank, read_bank, read_blueprint
from kinegrade.files.fields.document import FileKind, parsed_table
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.template.library.library import find_shipped, list_names
from kinegrade.problem.template.translated import Translated
from kinegrade.stated_marking import read_credit
from tests.exam.written_banks import HEAD, QUESTION, bank, faults
from tests.problem.crank import crank_text


def tolerances(folder: Path, text: str) -> list[Tolerance]:
    return [ask.tolerance for question in bank(folder, text).questions for ask in question.asks]


def test_the_least_a_bank_must_say(tmp_path: Path) -> None:
    found = bank(tmp_path, HEAD + QUESTION)
    (question,) = found.questions
    assert found.title == Translated(plain="Midterm")
    assert (found.course.in_language("zh"), found.date) == ("力学", "")
    assert (question.identifier, question.template.name, question.domains) == (
        "q1",
        "slider-crank",
        {},
    )
    assert [ask.name for ask in question.asks] == list(question.template.asked())
    assert question.points == sum(question.template.asks[ask.name].points for ask in question.asks)
    assert found.text == HEAD + QUESTION


def test_asks_and_domains_of_the_bank_replace_the_templates(tmp_path: Path) -> None:
    text = HEAD + QUESTION + 'asks = { a_B = 2.5, v_B = 1 }\ndraw = { k = ["sqrt(3)", 2] }'
    (question,) = bank(tmp_path, text).questions
    assert [(ask.name, ask.points) for ask in question.asks] == [
        ("a_B", Fraction(5, 2)),
        ("v_B", Fraction(1)),
    ]
    assert question.points == Fraction(7, 2)
    assert question.domains == {"k": ("sqrt(3)", "2")}


@pytest.mark.parametrize(
    ("written", "tolerance"),
    [
        ('{ relative = "1 %" }', (Fraction(1, 100), 0)),
        ('{ relative = "0.5%" }', (Fraction(1, 200), 0)),
        ("{ relative = 0.01 }", (Fraction(1, 100), 0)),
        ("{ absolute = 0.002 }", (0, Fraction(1, 500))),
        ('{ relative = "2 %", absolute = 1 }', (Fraction(1, 50), 1)),
        ("{ relative = 0.999999999 }", (Fraction(999999999, 10**9), 0)),
    ],
)
def test_tolerances_are_read_exactly(
    tmp_path: Path, written: str, tolerance: tuple[Fraction, Fraction]
) -> None:
    found = tolerances(tmp_path, f"{HEAD}tolerance = {written}\n{QUESTION}")
    assert set(found) == {Tolerance(Fraction(tolerance[0]), Fraction(tolerance[1]))}


@pytest.mark.parametrize(
    ("written", "relative", "figures"),
    [
        ("{ figures = 3 }", 0, 3),
        ('{ figures = 2, relative = "2 %" }', Fraction(1, 50), 2),
        ("{ figures = 5 }", 0, 5),
    ],
)
def test_significant_figures_may_be_asked_for(
    tmp_path: Path, written: str, relative: Fraction, figures: int
) -> None:
    text = HEAD + f"carry = 6\n{QUESTION}tolerance = {written}\n{QUESTION}"
    found = tolerances(tmp_path, text)
    assert Tolerance(Fraction(relative), Fraction(0), figures) in found
    assert found[-1].figures is None


@pytest.mark.parametrize(
    ("written", "tolerance"),
    [
        ('"honest"', Tolerance(Fraction(1, 100))),
        ('{ relative = "2 %", honest = true }', Tolerance(Fraction(1, 50))),
        (
            "{ relative = 0.01, absolute = 0.5, honest = true }",
            Tolerance(Fraction(1, 100), Fraction(1, 2)),
        ),
    ],
)
def test_a_tolerance_may_be_honest_for_the_exam_a_question_or_an_ask(
    tmp_path: Path, written: str, tolerance: Tolerance
) -> None:
    def honest(text: str) -> list[tuple[bool, bool]]:
        found = bank(tmp_path, text)
        return [
            (ask.honest, ask.honest and ask.tolerance == tolerance)
            for question in found.questions
            for ask in question.asks
        ]

    stated = f"tolerance = {written}\n"
    plain = 'tolerance = { relative = "1 %", honest = false }\n'
    asked = f"asks = {{ v_B = 1, a_B = {{ points = 2, tolerance = {written} }} }}\n"
    assert set(honest(HEAD + stated + QUESTION)) == {(True, True)}
    assert set(honest(HEAD + stated + QUESTION + plain)) == {(False, False)}
    assert set(honest(HEAD + QUESTION + stated)) == {(True, True)}
    assert honest(HEAD + plain + QUESTION + asked) == [(False, False), (True, True)]
    assert bank(tmp_path, HEAD + QUESTION).honest  # where nothing is stated
    assert bank(tmp_path, HEAD + stated + QUESTION).honest


def test_students_are_asked_to_carry_four_figures_unless_the_bank_says_otherwise(
    tmp_path: Path,
) -> None:
    assert bank(tmp_path, HEAD + QUESTION).carry == 4
    for carry in (3, 4, 5, 6):
        assert bank(tmp_path, f"carry = {carry}\n{HEAD}{QUESTION}").carry == carry


@pytest.mark.parametrize(
    ("carry", "tolerance", "figures", "do"),
    [
        (3, "{ figures = 3 }", 4, "write carry = 4, or allow more"),
        (3, '{ relative = "0.5 %" }', 4, "write carry = 4, or allow more"),
        (4, "{ relative = 0.0005 }", 5, "write carry = 5, or allow more"),
        (6, "{ figures = 6 }", 7, "allow more"),
    ],
)
def test_a_tolerance_that_the_figures_carried_cannot_meet_is_refused(
    tmp_path: Path, carry: int, tolerance: str, figures: int, do: str
) -> None:
    entry = f"{QUESTION}asks = {{ v_B = 1, a_B = {{ points = 2, tolerance = {tolerance} }} }}\n"
    (fault,) = faults(tmp_path, f"{HEAD}carry = {carry}\n{entry}")
    assert fault == (
        f"bank.toml:4: questions[1]: the tolerance of a_B takes {figures} significant figures "
        f"- expected one that {carry} carried figures can meet - {do}"
    )
    if figures <= 6:
        bank(tmp_path, f"{HEAD}carry = {figures}\n{entry}")


def test_the_nearest_tolerance_holds(tmp_path: Path) -> None:
    text = (
        HEAD
        + 'tolerance = { relative = "3 %" }\n'
        + QUESTION
        + QUESTION
        + "tolerance = { absolute = 0.1 }\n"
        'asks = { v_B = 1, a_B = { points = 2, tolerance = { relative = "5 %" } } }'
    )
    found = tolerances(tmp_path, text)
    assert set(found[:-2]) == {Tolerance(Fraction(3, 100), Fraction(0))}
    assert found[-2:] == [
        Tolerance(Fraction(0), Fraction(1, 10)),
        Tolerance(Fraction(1, 20), Fraction(0)),
    ]
    assert tolerances(tmp_path, HEAD + QUESTION)[0] == Tolerance(Fraction(1, 100), Fraction(0))


def test_points_left_out_are_the_templates(tmp_path: Path) -> None:
    (question,) = bank(
        tmp_path, HEAD + QUESTION + 'asks = { v_B = { tolerance = { relative = "2 %" } } }'
    ).questions
    assert question.points == question.template.asks["v_B"].points > 0


def test_a_template_file_may_lie_beside_the_bank(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(crank_text(), encoding="utf-8")
    (question,) = bank(tmp_path, HEAD + '[[questions]]\ntemplate = "crank.toml"').questions
    assert question.template.name == "crank"
    assert question.template.file.text == crank_text()


@pytest.mark.parametrize(
    "name",
    [
        "../../x.toml",
        "/etc/x.toml",
        "sub/x.toml",
        "..\\\\x.toml",
        "C:x.toml",
        "x\\u0000.toml",
        "x\\n.toml",
        "a" * 300 + ".toml",
    ],
)
def test_a_template_file_lies_nowhere_else(tmp_path: Path, name: str) -> None:
    (fault,) = faults(tmp_path, HEAD + f'[[questions]]\ntemplate = "{name}"')
    assert fault.startswith('bank.toml:4: questions[1].template: "')
    assert fault.endswith(" - expected a file beside the bank, without folders")


def test_a_template_that_is_not_there_or_faulty_is_told_with_its_place(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(
        crank_text(("{{ h.value }} above", "above")), encoding="utf-8"
    )
    found = faults(
        tmp_path,
        HEAD + '[[questions]]\ntemplate = "crank.toml"\n[[questions]]\ntemplate = "mine.toml"\n'
        '[[questions]]\ntemplate = "slidercrank"\n[[questions]]\ntemplate = "../slider-crank"',
    )
    assert found[0] == (
        "bank.toml:4: questions[1].template: crank.toml: statement.en: the parameter h is not given to the "
        "student: write {{ h }}"
    )
    assert found[1].startswith(
        f"bank.toml:6: questions[2].template: {tmp_path / 'mine.toml'}: cannot be read (No such file"
    )
    assert found[2].startswith(
        'bank.toml:8: questions[3].template: no template "slidercrank": did you mean "slider-crank"?'
    )
    assert found[3].startswith(
        'bank.toml:10: questions[4].template: no template "../slider-crank": '
    )


def test_two_templates_of_one_name_cannot_be_kept_in_one_exam(tmp_path: Path) -> None:
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    mine = HEAD + QUESTION + '[[questions]]\ntemplate = "slider-crank.toml"'
    (tmp_path / "slider-crank.toml").write_text(text, encoding="utf-8")
    shutil.copy(find_shipped("templates") / "slider-crank.de.toml", tmp_path)
    assert len(bank(tmp_path, mine).questions) == 2
    (tmp_path / "slider-crank.de.toml").unlink()
    assert faults(tmp_path, mine) == [
        "bank.toml:6: questions[2].template: another template of this bank has the name "
        '"slider-crank" - rename the file'
    ]


def test_a_shipped_template_is_not_taken_for_the_file_of_its_name_beside_the_bank(
    tmp_path: Path,
) -> None:
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    (tmp_path / "slider-crank.toml").write_text(text + "# mine", encoding="utf-8")
    assert faults(tmp_path, HEAD + QUESTION) == [
        "bank.toml:4: questions[1].template: this is a shipped template, and "
        '"slider-crank.toml" beside the bank is another - write "slider-crank.toml" for your own, '
        "or rename the file"
    ]


def test_a_bank_may_have_the_name_of_a_shipped_template(tmp_path: Path) -> None:
    (tmp_path / "slider-crank.toml").write_text(HEAD + QUESTION, encoding="utf-8")
    assert len(bank(tmp_path, HEAD + QUESTION).questions) == 1


def test_a_bank_may_say_what_typesets_it(tmp_path: Path) -> None:
    assert bank(tmp_path, HEAD + QUESTION).engine == "typst"
    assert bank(tmp_path, 'engine = "latex"\n' + HEAD + QUESTION).engine == "latex"


def test_a_bank_may_say_that_it_goes_to_canvas(tmp_path: Path) -> None:
    assert not bank(tmp_path, HEAD + QUESTION).four_decimals
    assert bank(tmp_path, 'lms = "canvas"\n' + HEAD + QUESTION).four_decimals
    assert faults(tmp_path, 'lms = "Canvas"\n' + HEAD + QUESTION) == [
        'bank.toml:1: lms: "Canvas" - expected canvas'
    ]


def test_an_editor_may_have_put_a_byte_order_mark(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(HEAD + "date = 2026-05-01\n" + QUESTION, encoding="utf-8-sig")
    assert read_bank(file).date == "2026-05-01"


def test_a_part_of_what_a_template_asks_and_points_shared_out(tmp_path: Path) -> None:
    (question,) = bank(tmp_path, HEAD + QUESTION + 'asks = "velocity"\npoints = 8').questions
    assert {ask.name: ask.points for ask in question.asks} == {
        "v_B": 5,
        "omega_AB": 3,
    }  # weighed 3 to 2
    (question,) = bank(tmp_path, HEAD + QUESTION + 'asks = "acceleration"').questions
    assert {ask.name: ask.points for ask in question.asks} == {"alpha_AB": 2, "a_B": 3}


POINTS = {"demo": 34, "velocity-quiz": 30, "acceleration-midterm": 60, "final": 100}


@pytest.mark.parametrize("name", list_names(find_shipped("banks")))
def test_shipped_banks_are_sound_and_found_by_name(name: str) -> None:
    plan = read_blueprint(find_bank(Path(name)))
    for secret in ("spring", "autumn", "resit"):
        exam = plan.bank(secret)
        assert exam.title.in_language("en") != exam.title.in_language("zh")
        assert sum(question.points for question in exam.questions) == POINTS[name]


def test_a_bank_is_found_by_path_or_by_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "demo").mkdir()  # a folder in the way is no bank
    assert find_bank(Path("demo")) == find_shipped("banks") / "demo.toml"
    (tmp_path / "final").write_text("mine", encoding="utf-8")
    assert find_bank(Path("final")) == Path("final")
    assert find_bank(Path("mine.toml")) == Path("mine.toml")
    with pytest.raises(BankError, match='no bank "fnial": did you mean "final"') as caught:
        find_bank(Path("fnial"))
    assert caught.value.problems[0].endswith("; or give a bank file")


def test_credit_is_read_exactly_and_kept_as_text(tmp_path: Path) -> None:
    credit = (
        'credit = { follow-through = "1/3", wrong-unit = "50 %", mistakes = { coriolis-halved '
        "= 0.25 } }\n"
    )
    found = bank(tmp_path, HEAD + credit + "solutions = true\n" + QUESTION)
    assert (found.credit.follow_through, found.credit.wrong_unit) == (
        Fraction(1, 3),
        Fraction(1, 2),
    )
    assert found.credit.record() == {
        "follow-through": "1/3",
        "wrong-unit": "1/2",
        "mistakes": {"coriolis-halved": "1/4"},
    }
    assert found.solutions
    plain = bank(tmp_path, HEAD + QUESTION)
    assert (plain.credit.record(), plain.solutions) == ({}, False)


def test_credit_of_many_digits_is_read_again_as_it_was_kept(tmp_path: Path) -> None:
    stated = "credit = { wrong-unit = 0.123456789012, follow-through = '12.345678901237 %' }\n"
    credit = bank(tmp_path, HEAD + stated + QUESTION).credit
    kind = FileKind("exam", ExamError, 100)
    again = read_credit(parsed_table("exam.json", {"credit": credit.record()}, kind), list)
    assert again == credit
