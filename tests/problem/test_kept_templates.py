"""An exam that was set before a rule on templates came can still be exported."""

from __future__ import annotations

from pathlib import Path

from tests.problem.crank import crank_text
from tests.small_class import VANISHING, generate, kinegrade, write_class

WRONG = (
    '\n[asks]\nw = { quantity = "x(acceleration(A))", unit = "m/s", means = { en = "w", zh = '
    '"w 量" } }\n'
)


def test_an_exam_whose_template_later_rules_refuse_is_still_exported(tmp_path: Path) -> None:
    assert generate(write_class(tmp_path)).exit_code in (0, 1)
    kept = tmp_path / "EXAM" / "templates" / "crank.toml"
    kept.write_text(crank_text(VANISHING, ("\n[asks]\n", WRONG)), encoding="utf-8")
    assert kinegrade("check", kept).exit_code == 2
    shown = kinegrade("quiz", tmp_path / "EXAM", "--to", "moodle-xml", "-o", tmp_path / "q.xml")
    assert "w: this is" not in shown.stderr
    assert (tmp_path / "q.xml").read_text(encoding="utf-8").count("<question ") >= 4
