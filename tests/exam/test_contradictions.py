"""`generate` says where a statement contradicts the mechanism: nobody need have run `check`."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.exam.setting import contradictions
from tests.problem.crank import crank_text
from tests.small_class import kinegrade

BANK = """title = "Midterm"
course = "Mechanics"
[[questions]]
template = "{template}"
{rest}
"""
OWN = 'draw = {{ h = [1], r = [2], omega = "1 .. {most} step 1" }}'
ROSTER = "student,name\n1001,Ada\n1002,Emilie\n1003,Sofya\n"
END = (
    "and all instances go the other way - correct the template before papers are handed out; "
    "kinegrade check names all of it"
)
WRONG = [
    f'q1 (crank): statement: it says "turns clockwise with {{{{ omega }}}}", {END}',
    f'q1 (crank): statement: it says "The crank {{{{ r }}}} turns clockwise", {END}',
]


def generate(folder: Path, text: str, bank: str, *options: str) -> tuple[int, list[str]]:
    """The status and the complaints."""
    (folder / "crank.toml").write_text(text, encoding="utf-8")
    (folder / "bank.toml").write_text(bank, encoding="utf-8")
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    where = folder / "bank.toml", folder / "roster.csv", "-o", folder / "EXAM"
    made = kinegrade("generate", *where, "--no-papers", *options)
    said = made.stderr.splitlines()
    return made.exit_code, [line for line in said if line.startswith(("complaint", "error"))]


def test_a_statement_that_contradicts_the_mechanism_is_a_complaint(tmp_path: Path) -> None:
    """The exam was set without a word, with a key to another problem."""
    bank = BANK.format(template="crank.toml", rest=OWN.format(most=9))
    wrong = crank_text(("turns with {{ omega }}", "turns clockwise with {{ omega }}"))
    assert generate(tmp_path, crank_text(), bank) == (0, [])
    status, said = generate(tmp_path, wrong, bank, "--force", "--accept-changes")
    assert (status, said) == (1, [f"complaint: {line}" for line in WRONG])
    strict = generate(tmp_path, wrong, bank, "--force", "--accept-changes", "--strict")
    assert strict == (2, [f"error: {line}" for line in WRONG])


def test_a_first_proof_says_what_the_papers_would_contradict(tmp_path: Path) -> None:
    """What is read through before an exam is set is the paper that the complaint is about."""
    wrong = crank_text(("turns with {{ omega }}", "turns clockwise with {{ omega }}"))
    proof = tmp_path / "proof.pdf"
    for text, complaints in ((crank_text(), []), (wrong, WRONG)):
        (tmp_path / "crank.toml").write_text(text, encoding="utf-8")
        bank = BANK.format(template="crank.toml", rest=OWN.format(most=9))
        (tmp_path / "bank.toml").write_text(bank, encoding="utf-8")
        made = kinegrade("sample", tmp_path / "bank.toml", "-o", proof, "--force")
        assert proof.exists()
        assert made.stderr.splitlines() == [f"complaint: {line}" for line in complaints]
        assert made.exit_code == (1 if complaints else 0)


def test_shipped_templates_at_their_own_values_are_not_looked_at_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> list[object]:
        raise AssertionError

    monkeypatch.setattr(contradictions, "_find_contradictions", refuse)
    listed, beyond = (
        BANK.format(template="slider-crank", rest=f"draw = {{ phi = [{angle}] }}")
        for angle in ("30, 60", "33, 63")
    )
    assert generate(tmp_path, crank_text(), listed) == (0, [])
    (tmp_path / "other").mkdir()
    with pytest.raises(AssertionError):
        generate(tmp_path / "other", crank_text(), beyond)
