"""What every target has in common: what is refused, all faults at once, and no target is half
made.
"""

from __future__ import annotations

from types import ModuleType

import pytest

from kinegrade.errors import TypesetError
from kinegrade.language import ENGLISH, Language
from kinegrade.language.prose import html, latex, pandoc, plain, typst
from kinegrade.language.prose.rendering import ProseRenderer, make_reader

Target = ModuleType
TARGETS = (typst, latex, html, plain, pandoc)


def said(target: ModuleType) -> tuple[Language, ...]:
    """The language in which a target says formulas, if it does."""
    return (ENGLISH,) if target is typst else ()


@pytest.mark.parametrize(
    ("markdown", "name"),
    [
        ("![a](b.png)", "an image (a)"),
        ("<b>x</b>", "raw HTML (<b>)"),
        ("<div>", "raw HTML (<div>)"),
        ("[a](b)", "a link"),
        ("# a", "a heading"),
        ("> a", "a quotation"),
        ("`a`", "code (a)"),
        ("```\na\n```", "code (a)"),
        ("    a", "code (a line indented by four blanks) (a)"),
        ("---", "a rule across the page"),
        ("$$\nx\n$$ (eq)", "a labelled formula (x)"),
    ],
)
@pytest.mark.parametrize("target", TARGETS)
def test_anything_else_is_refused_by_name(target: Target, markdown: str, name: str) -> None:
    with pytest.raises(TypesetError) as refusal:
        target.write_prose(markdown, "q1, statement", *said(target))
    expected = (
        f"q1, statement: {name} cannot be printed - expected text, **bold**, *emphasis*, "
        "lists and $math$"
    )
    assert refusal.value.problems[0].startswith(expected)


@pytest.mark.parametrize("target", TARGETS)
def test_all_faults_of_a_text_are_reported_at_once(target: Target) -> None:
    with pytest.raises(TypesetError) as refusal:
        target.write_prose("# a\n\n`b` $\\foo$ $\\baz$", "q1", *said(target))
    assert len(refusal.value.problems) == 4


@pytest.mark.parametrize("target", TARGETS)
def test_a_line_is_refused_as_prose_is(target: Target) -> None:
    with pytest.raises(TypesetError, match="^q1: an image .* cannot be printed - expected text"):
        target.write_line("![a](b.png)", "q1", *said(target))


@pytest.mark.parametrize("kind", sorted(ProseRenderer.__abstractmethods__))
def test_a_target_that_lacks_a_kind_of_node_cannot_be_made(kind: str) -> None:
    methods = dict.fromkeys(ProseRenderer.__abstractmethods__ - {kind}, str)
    incomplete = type("Incomplete", (ProseRenderer,), methods)
    with pytest.raises(TypeError, match=kind):
        make_reader(incomplete)


def test_every_kind_of_node_that_the_reader_knows_is_written_or_refused() -> None:
    """Of a text with all that Markdown has, no node is left without a name."""
    everything = """# a
> b

- c
1. d

***

    e

```
f
```

<div>

g **h** *i* `j` ![k](l) [m](n) <b> $o$ $$p$$ &amp;\\*
q  \nr <http://s.t>

$$
u
$$

$$
v
$$ (w)
"""
    with pytest.raises(TypesetError) as refusal:
        typst.write_prose(everything, "q1", ENGLISH)
    assert [
        problem for problem in refusal.value.problems if " cannot be printed" not in problem
    ] == []
    assert len(refusal.value.problems) == 11  # both links are one fault


@pytest.mark.parametrize(
    ("lines", "printed"),
    [
        ("转动，\n$B$ 在下方", "转动，B 在下方"),
        ("转动\n（向右）", "转动（向右）"),
        ("$A$\n，$B$", "A，B"),
        ("转动\n向右", "转动向右"),
        ("位于\n$B$", "位于 B"),
        ("turns;\n$B$ is below", "turns; B is below"),
    ],
)
def test_a_line_that_ends_at_chinese_punctuation_prints_no_blank(lines: str, printed: str) -> None:
    assert plain.write_prose(lines, "q1") == printed
