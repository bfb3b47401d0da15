"""Formulas for tests: those of the shipped templates, one for each node, and trees at random."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import pairwise

from hypothesis import strategies as st

from kinegrade.exam.quiz.paper import show_instance
from kinegrade.language import Language
from kinegrade.language.math.latex import LatexDialect
from kinegrade.language.math.letters import FUNCTIONS, GREEK, SIGNS
from kinegrade.language.math.tokens import (
    ACCENTS,
    BRACKETS,
    ENVIRONMENTS,
    FRACTIONS,
    SPACES,
    STYLES,
)
from kinegrade.language.math.tree import (
    PRIME,
    Accent,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Text,
    Unit,
)
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.library.library import find_template_names, load_template

ONE_OF_EACH = (
    "ab",
    "12.5",
    "1{,}5",
    r"\varphi \phi \epsilon \Omega",
    r"-a \cdot b = -2 \pm c",
    r"\sin^2\varphi + \cos x \sin(\alpha)",
    r'\text{from }A\text{ m/s^2 "#x" }',
    r"3\,\unit{m/s^2}\quad\unit{deg}",
    r"{ab}^2",
    r"a_{BA}^{\mathrm{n}} O_1' 30^\circ B^\prime {}_2 \sum_{i}^{n} x_1_2",
    r"\frac{a, b}{c} \dfrac12 \tfrac{(}{:}",
    r"\sqrt{3} \sqrt[3]{x y}",
    r"\mathrm{AB} \mathbf{a} \mathit{AB} \bm{v}",
    r"\vec{v} \bar{v} \hat{v} \tilde{v} \dot{v} \ddot{v} \overline{AB} \overrightarrow{AB}",
    r"\underbrace{a + b}_{c} \widehat{AB} = \boxed{2\,\unit{m}}",
    r"\left(\frac{1}{2}\right] \left|x\right| \left.y\right\}",
    r"\begin{cases} x = 1 & a \\ y < 2 \end{cases}",
    r"\begin{aligned} x &= 1 \\ y &= 2 \end{aligned}",
    r"a \\ [b]",
    "(a] [0, 1) | 5 \\% ! ? ; : / *",
)
_FORMULA = re.compile(r"\$+([^$]+)\$+")
LANGUAGES: tuple[Language, ...] = ("en", "zh")
# As authors write it
SOURCE = LatexDialect(lambda text: rf"\text{{{text}}}", lambda unit: rf"\unit{{{unit}}}")


def list_formulas() -> list[str]:
    """Every formula of the shipped templates as first drawn, and one for each node."""
    found = dict.fromkeys(ONE_OF_EACH)
    for name in find_template_names():
        found |= dict.fromkeys(_list_formulas_of(name))
    return list(found)


def _list_formulas_of(name: str) -> Iterator[str]:
    template = load_template(name)
    shown = show_instance(template, {}, template.asks).parameters
    symbols = [*template.parameters.values(), *template.asks.values()]
    yield from (each.symbol for each in symbols)
    for language in LANGUAGES:
        texts = [write_statement(template, shown, language)]
        texts += [each.means.in_language(language) for each in symbols]
        for text in texts:
            yield from _FORMULA.findall(text)


def _is_canonical(row: Row) -> bool:
    """Whether LaTeX can say a row in one way only: two numbers side by side are one."""
    for before, node in pairwise(row):
        base = node.base if isinstance(node, Scripts) else node
        if isinstance(base, Number) and isinstance(before, Number | Sign):
            return False
    return True


def _rows(nodes: st.SearchStrategy[Node]) -> st.SearchStrategy[Row]:
    return st.lists(nodes, max_size=4).map(tuple).filter(_is_canonical)


def _scripts(nodes: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    carriers = nodes.filter(
        lambda node: not isinstance(node, Scripts | Space | Mark | LineBreak) and node != Group(())
    )
    rows = _rows(nodes)
    raised = rows.filter(lambda row: not row or any(node != PRIME for node in row))
    return st.builds(
        Scripts,
        st.none() | carriers,
        st.none() | rows,
        st.integers(0, 2),
        st.none() | raised,
    ).filter(lambda node: node.lower is not None or node.primes > 0 or node.upper is not None)


@st.composite
def _nodes(draw: st.DrawFn, levels: int) -> Node:
    """A node of so many levels at most: a strategy with a name, which is shown in place of all that
    it is made of.
    """
    return draw(_LEAVES if levels == 1 else _LEAVES | _parents(levels - 1))


@cache
def _parents(levels: int) -> st.SearchStrategy[Node]:
    """Nodes with parts of so many levels at most."""
    nodes = _nodes(levels)
    rows = _rows(nodes)
    unclosed = rows.filter(lambda row: Sign("]") not in row)
    brackets = st.sampled_from(sorted(BRACKETS))
    return st.one_of(
        st.builds(Group, rows),
        _scripts(nodes),
        st.builds(Quotient, st.sampled_from(sorted(FRACTIONS)), rows, rows),
        st.builds(Root, rows, st.none() | unclosed),
        st.builds(Lettering, st.sampled_from(sorted(set(STYLES.values()))), rows),
        st.builds(Accent, st.sampled_from(sorted(ACCENTS)), rows),
        st.builds(Fenced, brackets, rows, brackets),
        st.builds(Environment, st.sampled_from(sorted(ENVIRONMENTS)), rows),
    )


_WORDS = st.text(st.characters(exclude_characters="{}", exclude_categories=["Cs"]), max_size=6)
_LEAVES: st.SearchStrategy[Node] = st.one_of(
    st.builds(Letter, st.sampled_from([*"abvABC", *sorted(GREEK)])),
    st.builds(Number, st.from_regex(r"[0-9]{1,3}(\.[0-9]{1,2})?", fullmatch=True)),
    st.builds(Sign, st.sampled_from(sorted(SIGNS))),
    st.builds(Function, st.sampled_from(sorted(FUNCTIONS))),
    st.builds(Text, _WORDS),
    st.builds(Unit, st.sampled_from(["m/s^2", "deg", "1", "N*m"]) | _WORDS),
    st.builds(Space, st.sampled_from(sorted(SPACES))),
    st.just(LineBreak()),
    st.just(Mark()),
)
TREES = _rows(_nodes(4))
SCRIPTS = _scripts(_nodes(3))
