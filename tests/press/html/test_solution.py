"""Worked solutions as HTML: everything that the printed ones say but the pictures, ending with the
key's numbers.
"""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from kinegrade.language import Language
from kinegrade.press.html.solution import IN_MATHML, write_blocks
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Display, Heading, Prose, TermTable
from kinegrade.worked.solution import write_worked_solution
from tests.press.tables import find_table_faults, read_html_tables
from tests.worked.telling import read_display, read_term

NAMES = ("slider-crank", "bar-through-swivelling-sleeve", "planetary-gear-external-rim-velocities")


@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("name", NAMES)
def test_a_solution_is_told_whole(name: str, language: Language) -> None:
    template = load_template(name)
    asked = template.asked()
    solution = solve_template(template, {}, asked)
    worked = write_worked_solution(solution, asked, language)
    html = write_blocks(worked.blocks, language)
    tree = ElementTree.fromstring(f"<div>{html}</div>")
    kinds = [type(block) for block in worked.blocks]
    assert sum(child.tag in ("h4", "h5") for child in tree) == kinds.count(Heading)
    assert len(list(tree.iter("table"))) == kinds.count(TermTable)
    assert html.count(r"\begin{aligned}") == kinds.count(Display)
    assert html.count(r"\boxed{") == len(asked)
    assert list(find_table_faults(read_html_tables(html))) == []


def test_the_blocks_one_by_one() -> None:
    terms = (
        read_term("", "v_B", "?", "$\\parallel x$"),
        read_term("=", "v_A", "$r\\omega$", "a < b"),
    )
    html = write_blocks(
        (
            Heading("Step $1$", 2),
            Prose("Thus:"),
            read_display(("v &= a + b = c", "w &= 1")),
            TermTable(terms),
        ),
        "en",
    )
    assert html.splitlines() == [
        r"<h5>Step \(1\)</h5>",
        "<p>Thus:</p>",
        r"<p>\[\begin{aligned} v &amp;= a + b = c \\ w &amp;= 1 \end{aligned}\]</p>",
        "<table><thead>",
        '<tr><th scope="col">vector</th>' + head(r"\(v_{B}\)") + head(r"\(= {}v_{A}\)") + "</tr>",
        "</thead><tbody>",
        row("magnitude", "?", r"\(r\omega\)"),
        row("direction", r"\(\parallel x\)", "a &lt; b"),
        "</tbody></table>",
    ]


def head(symbol: str) -> str:
    placed = 'style="padding:0 .5em;text-align:center"'
    return f'<th scope="col" {placed}>{symbol}</th>'


def row(head: str, *cells: str) -> str:
    entries = (f'<td style="padding:0 .5em;text-align:center">{cell}</td>' for cell in cells)
    return f'<tr><th scope="row">{head}</th>{"".join(entries)}</tr>'


def test_a_formula_over_a_column_of_a_page_is_said_in_words() -> None:
    terms = (read_term("=", "v_A", "?", "?"),)
    html = write_blocks((TermTable(terms),), "de", IN_MATHML)
    assert (
        '<th scope="col" style="padding:0 .5em;text-align:center"><math aria-label="gleich v A">'
        in html
    )
