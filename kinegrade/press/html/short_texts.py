"""Symbols and short prose of templates as HTML: formulas as MathML; what cannot be read is left as
text.

Every incoming character is escaped.
"""

from __future__ import annotations

from html import escape

from markupsafe import Markup

from kinegrade.errors import TypesetError
from kinegrade.language.math.mathml.formula import write_mathml
from kinegrade.language.prose.html import write_page_line


def write_symbol_html(latex: str) -> Markup:
    r"""A symbol, given as LaTeX math.

    >>> print(write_symbol_html(r"\omega_{1}"), write_symbol_html("<b>"))
    <math><msub><mi>ω</mi><mn>1</mn></msub></math> <math><mo>&lt;</mo><mi>b</mi><mo>&gt;</mo></math>
    """
    try:
        return Markup(write_mathml(latex, "symbol"))
    except TypesetError:  # in a key that was changed by hand: a page of marks is shown all the same
        return Markup(escape(latex))


def write_prose_html(prose: str) -> Markup:
    """A line of Markdown with `$...$` math.

    >>> print(write_prose_html("**speed** of $B$ < $c$"))
    <strong>speed</strong> of <math><mi>B</mi></math> &lt; <math><mi>c</mi></math>
    """
    try:
        return Markup(write_page_line(prose, "text"))
    except TypesetError:  # as above
        return Markup(escape(prose))
