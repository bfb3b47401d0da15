"""What holds for every tree: it can be written, and what is written is what it says."""

from __future__ import annotations

from xml.etree import ElementTree

import typst
from hypothesis import example, given, settings
from hypothesis import strategies as st

from kinegrade.language.math.latex import MATHJAX, PANDOC, TEX, write_latex_row
from kinegrade.language.math.mathml.formula import write_mathml_row
from kinegrade.language.math.plain import write_plain_row
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Environment, Fenced, Letter, Node, Row, Scripts
from kinegrade.language.math.typst.formula import write_typst_row
from tests.language.math.formulas import SCRIPTS, SOURCE, TREES


@given(TREES)
def test_a_tree_written_as_latex_is_read_again_as_the_same_tree(row: Row) -> None:
    assert read_math(write_latex_row(row, SOURCE), "law") == row


NOTHING = Environment("aligned", ())


@settings(max_examples=12, deadline=None)
@example([(Scripts(NOTHING, (), 0, ()),), (Fenced("(", (Scripts(NOTHING, (), 0, None),), ")"),)])
@given(st.lists(TREES, min_size=20, max_size=20))
def test_every_tree_compiles_in_typst(rows: list[Row]) -> None:
    source = "\n\n".join(f"${write_typst_row(row)}$" for row in rows)
    typst.compile(source.encode(), format="svg", ignore_system_fonts=True)


@given(SCRIPTS)
@example(Scripts(NOTHING, (Letter("a"),), 0, None))
def test_scripts_in_typst_begin_with_what_carries_them(node: Node) -> None:
    """Without it, they would be those of whatever stands before, or of nothing."""
    assert not write_typst_row((node,)).startswith(("_", "^", "'"))


@given(TREES)
def test_mathml_is_well_formed(row: Row) -> None:
    math = ElementTree.fromstring(write_mathml_row(row))
    assert math.tag == "math"
    children = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munder": 2, "mroot": 2}
    for element in math.iter():
        assert len(element) == children.get(element.tag, len(element))


@given(TREES)
def test_plain_text_is_one_line(row: Row) -> None:
    text = write_plain_row(row)
    assert "\n" not in text
    assert "  " not in text


@given(TREES)
def test_no_dialect_of_latex_lets_a_comment_or_a_code_through(row: Row) -> None:
    for dialect in (TEX, MATHJAX, PANDOC):
        written = write_latex_row(row, dialect).replace(r"\\", "").replace(r"\%", "")
        assert "^^" not in written
        assert "%" not in written
