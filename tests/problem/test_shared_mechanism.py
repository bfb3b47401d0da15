"""Templates that share a mechanism: own tables lie over the shared ones, and a fault names the file
it stands in.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.errors import TemplateError
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import (
    find_shipped,
    find_template_names,
    list_names,
    load_template,
)
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.sections.keys import MAX_CHARACTERS
from kinegrade.problem.template.template import MechanismFile, Template
from tests.problem.crank import crank

MECHANISM = """
joints = ["pin O: ground OA"]
conditions = ["omega < 10000000"]

[parameters]
r     = { unit = "m", draw = [1, 2], means = { en = "length of the crank", zh = "曲柄的长度" } }
h     = { unit = "m", means = { en = "height of A", zh = "A 的高度" } }

[points]
O = "(0, 0)"
P = "(0, h)"
A = "meet(circle(O, r), line(P, 0), right)"

[bodies]
OA = "O A"

[figure]
lengths = [{ symbol = "r", from = "O", to = "A" }]
labels = { P = "P" }
"""
OWN = r"""
family = "crank"
title = { en = "A crank", zh = "曲柄" }
source = "by hand"
mechanism = "arm"
inputs = [{ motion = "OA turns", velocity = "omega" }]

[statement]
en = '''The crank {{ r }} turns with {{ omega }}; $A$ is {{ h.value }} above $O$.'''
zh = '''曲柄 {{ r }} 以 {{ omega }} 转动，$A$ 高于 $O$ {{ h.value }}。'''

[parameters]
h     = { draw = [0, "1/2", 3] }
omega = { unit = "rad/s", draw = [2, 1000000, 20000000], means = { en = "angular velocity", zh = "角速度" } }

[asks]
v_x = { quantity = "x(velocity(A))", unit = "m/s", sign = "+x", points = 2, means = { en = "along x", zh = "沿 x 轴" } }
v_y = { quantity = "y(velocity(A))", unit = "m/s", sign = "+y", means = { en = "along y", zh = "沿 y 轴" } }

[[published]]
source = "by hand"
gives = { v_x = "-omega*h" }
"""
Change = tuple[str, str]


def changed(text: str, *changes: Change) -> str:
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return text


def sharing(own: tuple[Change, ...] = (), shared: tuple[Change, ...] = ()) -> Template:
    """The crank that shares its mechanism, with passages of either file replaced."""
    mechanisms = {"arm": MechanismFile("arm", changed(MECHANISM, *shared))}
    return read_template("crank", changed(OWN, *own), mechanisms.__getitem__)


def faults(own: tuple[Change, ...] = (), shared: tuple[Change, ...] = ()) -> list[str]:
    with pytest.raises(TemplateError) as caught:
        sharing(own, shared)
    assert [problem for problem in caught.value.problems if "\n" in problem] == []
    return list(caught.value.problems)


def with_files(folder: Path, own: str = OWN, **mechanisms: str) -> Path:
    """The crank's file with the files of these mechanisms beside it."""
    (folder / "mechanisms").mkdir()
    for name, text in mechanisms.items():
        (folder / "mechanisms" / f"{name}.toml").write_text(text, encoding="utf-8")
    (folder / "crank.toml").write_text(own, encoding="utf-8")
    return folder / "crank.toml"


def refusals(file: Path) -> list[str]:
    with pytest.raises(TemplateError) as caught:
        load_template(str(file))
    return list(caught.value.problems)


def test_a_template_that_shares_is_the_template_that_stands_alone() -> None:
    found, alone = sharing(), crank()
    assert found.file.mechanism == MechanismFile("arm", MECHANISM)
    assert alone.file.mechanism is None
    assert replace(found, file=alone.file, figure=alone.figure) == alone
    assert list(found.parameters) == list(alone.parameters)
    assert solve_template(found, {"h": "0"})["v_y"].exact == "2"


def test_own_entries_win_by_name_and_a_parameter_key_by_key() -> None:
    own = (
        ('h     = { draw = [0, "1/2", 3] }', 'h = { draw = [0] }\nr = { published = "2" }'),
        ("[asks]", '[points]\nP = "(0, h/2)"\nQ = "(0, r)"\n[bodies]\nOA = "O A P"\n[asks]'),
    )
    template = sharing(own)
    assert list(template.parameters) == ["r", "h", "omega"]
    assert (template.parameters["r"].choices, template.parameters["r"].published) == (
        ("1", "2"),
        "2",
    )
    assert list(template.scheme.points) == ["O", "P", "A", "Q"]
    assert solve_template(template, {"h": "1"})["v_x"].exact == "-1"
    assert template.scheme.bodies[0].points == ("O", "A", "P")


def test_own_lists_follow_the_shared_ones_and_the_figure_is_laid_over_key_by_key() -> None:
    own = (
        ('mechanism = "arm"', 'mechanism = "arm"\nconditions = ["h < r"]'),
        ("[asks]", '[figure]\naxes = "aside"\nlabels = { O = "C" }\n[asks]'),
    )
    template = sharing(own)
    assert [condition.text for condition in template.scheme.conditions] == [
        "omega < 10000000",
        "h < r",
    ]
    assert (len(template.figure.lengths), template.figure.axes) == (1, "aside")
    assert dict(template.figure.labels) == {"O": "C"}


@pytest.mark.parametrize(
    ("shared", "reported"),
    [
        (
            ('en = "length of the crank", ', 'ef = "length of the crank", '),
            'mechanisms/arm.toml:6: parameters.r.means: unknown: "ef" - expected a language',
        ),
        (('P = "(0, h)"', 'P = "(0, k)"'), 'mechanisms/arm.toml:11: points.P: unknown name "k" - '),
        (('OA = "O A"', 'OA = "O B"'), 'mechanisms/arm.toml:15: bodies.OA: no point "B" - '),
        (
            ("pin O: ground OA", "pin O: ground OC"),
            'mechanisms/arm.toml:2: joints[1]: no body "OC" - ',
        ),
        (
            ("pin O: ground OA", "glue O"),
            'mechanisms/arm.toml:2: joints[1]: "glue O": no such joint - ',
        ),
        (
            ("omega < 10000000", "omega"),
            'mechanisms/arm.toml:3: conditions[1]: "omega" - expected "left < right"',
        ),
        (
            ("[bodies]", "1X = '(0, 0)'\n[bodies]"),
            "mechanisms/arm.toml:14: points.1X: not usable as a name - ",
        ),
        (
            ('labels = { P = "P" }', "axes = 1"),
            "mechanisms/arm.toml:19: figure.axes: 1 - expected origin or aside",
        ),
        (
            ("h     = { unit", "h     = { unti"),
            'mechanisms/arm.toml:7: parameters.h.unti: unknown key - did you mean "unit"?',
        ),
    ],
)
def test_a_fault_of_the_mechanism_is_reported_with_its_file(shared: Change, reported: str) -> None:
    assert [problem for problem in faults(shared=(shared,)) if problem.startswith(reported)]


@pytest.mark.parametrize(
    ("own", "reported"),
    [
        (
            ('mechanism = "arm"', 'mechanism = "arm"\nconditions = ["h"]\njoints = ["glue"]'),
            'crank.toml:6: conditions[1]: "h" - ',
        ),
        (
            ('mechanism = "arm"', 'mechanism = "arm"\njoints = ["glue"]'),
            'crank.toml:6: joints[1]: "glue": no such joint - ',
        ),
        (
            ("[asks]", "[points]\nP = '(0, k)'\n[asks]"),
            'crank.toml:17: points.P: unknown name "k" - ',
        ),
        (
            ("[asks]", "[figure]\naxes = 1\n[asks]"),
            "crank.toml:17: figure.axes: 1 - expected origin or aside",
        ),
        (
            ("[asks]", "[figure]\nlabels = 1\n[asks]"),
            "crank.toml:17: figure.labels: 1 - expected a table",
        ),
        (
            ('mechanism = "arm"', 'mechanism = "arm"\npoints = 3'),
            "crank.toml:6: points: 3 - expected a table",
        ),
        (
            ("x(velocity(A))", "x(velocity(B))"),
            'crank.toml:17: asks.v_x.quantity: unknown name "B" - ',
        ),
    ],
)
def test_a_fault_of_the_template_is_reported_with_its_own_file(own: Change, reported: str) -> None:
    assert [problem for problem in faults((own,)) if problem.startswith(reported)]


def test_what_a_mechanism_cannot_hold_is_refused_with_all_other_faults() -> None:
    shared = (
        ("[points]", "[asks]\n[tags]\n[points]"),
        ("conditions = ", 'mechanism = "leg"\nconditions = '),
        ('[bodies]\nOA = "O A"', "[other]"),
        ("\njoints = [", "\nbodies = 1\njoints = ["),
    )
    remedy = (
        "leave it to the templates: known here: "
        "bodies, conditions, figure, joints, lengths, parameters, points, reasons"
    )
    assert faults((('family = "crank"', 'famly = "crank"'),), shared) == [
        'crank.toml:2: famly: unknown table or key - did you mean "family"?',
        "mechanisms/arm.toml:2: bodies: 1 - expected a table",
        "mechanisms/arm.toml:4: mechanism: a mechanism cannot build on a further one - "
        "write all its tables in this file",
        f"mechanisms/arm.toml:11: asks: cannot be shared - {remedy}",
        f"mechanisms/arm.toml:12: tags: cannot be shared - {remedy}",
        f"mechanisms/arm.toml:18: other: cannot be shared - {remedy}",
    ]


@pytest.mark.parametrize(
    "name", ['"../arm"', '"arm.toml"', '""', '"/arm"', '"Arm"', '"arm\\n"', "3", '["arm"]']
)
def test_a_mechanism_is_called_by_a_plain_name(name: str) -> None:
    (fault,) = faults((('mechanism = "arm"', f"mechanism = {name}"),))
    assert fault.startswith("crank.toml:5: mechanism: ")
    assert fault.endswith(
        " - expected a file's name in mechanisms/ without .toml: small letters, digits, hyphens and underscores"
    )


def test_a_mechanism_that_cannot_be_had_says_why(tmp_path: Path) -> None:
    file = with_files(
        tmp_path, changed(OWN, ('source = "by hand"\nmechanism', "mechanism")), arms=MECHANISM
    )
    assert refusals(file) == [
        "crank.toml: source: missing - expected in every template",
        'crank.toml:4: mechanism: no mechanism "arm" in mechanisms/ beside the template - '
        'did you mean "arms"? (known here: arms)',
    ]
    shared = tmp_path / "mechanisms" / "arm.toml"
    shared.write_text("#" * (MAX_CHARACTERS + 1), encoding="utf-8")
    assert refusals(file)[1:] == [
        f"mechanisms/arm.toml: {MAX_CHARACTERS + 1} characters - "
        f"expected a template of at most {MAX_CHARACTERS} - shorten it"
    ]
    shared.write_text("joints = [", encoding="utf-8")
    assert refusals(file)[1].endswith(" - expected a template in TOML - fix it")
    shared.write_bytes(b"title = '\xff'")
    assert refusals(file)[1].startswith("crank.toml:4: mechanism: ")
    assert "not UTF-8 at byte 9" in refusals(file)[1]


def test_a_text_alone_has_no_mechanisms_beside_it() -> None:
    with pytest.raises(TemplateError) as caught:
        read_template("crank", OWN)
    assert caught.value.problems == (
        'crank.toml:5: mechanism: no folder to look for "arm" in - load the template from its file',
    )


def test_a_mechanism_is_found_beside_its_template_and_is_no_template(tmp_path: Path) -> None:
    file = with_files(tmp_path, arm=MECHANISM)
    assert load_template(str(file)) == load_template("crank", tmp_path) == sharing()
    mechanisms = set(list_names(find_shipped("templates") / "mechanisms"))
    assert mechanisms
    assert not mechanisms & set(find_template_names())


def test_every_shipped_mechanism_is_shared() -> None:
    shared = [
        template.file.mechanism.name
        for template in map(load_template, find_template_names())
        if template.file.mechanism
    ]
    files = {path.stem for path in (find_shipped("templates") / "mechanisms").iterdir()}
    assert set(shared) == files
    assert [name for name in files if shared.count(name) < 2] == []
