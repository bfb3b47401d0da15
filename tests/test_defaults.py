"""A default over our own types is found in every form that it takes, and nothing else is called one."""

from __future__ import annotations

import ast

import pytest

from tests.defaults import defaults
from tests.own_words import vocabulary

OWN = """
Joint = Pin | Slide | Chain
Driver = Spin | Push
Language = Literal["en", "zh", "fr"]
Level = Literal["velocity", "acceleration"]
WORDS: Mapping[Language, str] = {"en": "a", "zh": "b", "fr": "c"}
LETTERS = {"velocity": "v", "acceleration": "a"}
class Pin: ...
class Slide: ...
class Chain: ...
class Spin: ...
class Push: ...
class Stage:
    level: Level
def told(level: Level, language: Language, joint: Joint): ...
"""
FOUND = {
    "a last case that takes everything": """
match joint:
    case Pin():
        x = 1
    case _:
        x = 2
""",
    "a last case handed on to a function that does not ask": """
def f(joint: Joint):
    match joint:
        case Pin():
            return 1
        case _:
            return g(joint)
def g(joint: Slide | Chain):
    return 2
""",
    "a last case handed on to a function that takes anything": """
def f(joint: Joint):
    match joint:
        case Pin():
            return 1
        case _:
            return g(joint)
def g(joint: object):
    match joint:
        case Slide():
            return 2
        case Chain():
            return 3
        case _:
            raise TypeError("no such joint")
""",
    "a last case handed on to a function that matches something else": """
def f(joint: Joint, driver: Driver):
    match joint:
        case Pin():
            return 1
        case _:
            return g(joint, driver)
def g(joint: Slide | Chain, driver: Spin | Push):
    match driver:
        case Spin() | Push():
            return 2
        case _:
            assert_never(driver)
""",
    "a last case handed on to a function of another module": """
match joint:
    case Pin():
        x = 1
    case _:
        x = g(joint)
""",
    "a last case that does more than hand on": """
def f(joint: Joint):
    match joint:
        case Pin():
            return 1
        case _:
            return 1 + g(joint)
def g(joint: Slide | Chain):
    match joint:
        case Slide() | Chain():
            return 2
        case _:
            assert_never(joint)
""",
    "a name as the last case": """
match stage.level:
    case "velocity":
        x = 1
    case other:
        x = 2
""",
    "a positional pattern of a joint": """
match joint:
    case Pin(point, bodies):
        x = 1
""",
    "an else after isinstance": """
if isinstance(joint, Pin):
    x = 1
else:
    x = 2
""",
    "an else after several": """
if isinstance(joint, Pin):
    x = 1
elif isinstance(joint, Slide):
    x = 2
else:
    x = 3
""",
    "a fall-through": """
def f():
    if isinstance(joint, Pin | Slide):
        return 1
    return 2
""",
    "a fall-through to nothing after several": """
def f():
    if isinstance(joint, Pin):
        return 1
    if isinstance(joint, Slide):
        return 2
    return None
""",
    "a fall-through before a negation": """
def f():
    if not isinstance(joint, Pin):
        return 2
    return 1
""",
    "a conditional on a type": "x = 1 if isinstance(joint, Pin) else 2",
    "a conditional on a literal": 'x = "v" if stage.level == "velocity" else "a"',
    "a conditional the other way round": 'x = "v" if stage.level != "velocity" else "a"',
    "an else after ==": """
if level == "velocity":
    x = 1
else:
    x = 2
""",
    "an else after in": """
if level in ("velocity", "speed"):
    x = 1
else:
    x = 2
""",
    "a conditional on the language": 'x = "zh" if head.get("language") == "zh" else "en"',
    "a language compared with anything": 'x = 1 if whatever == "en" else 2',
    "a conditional on the outcome of a test": """
turns = joint.level == "velocity"
x = 1 if turns else 2
""",
    "a default of a named table": 'x = WORDS.get(language, "a")',
    "a default of a table without annotation": 'x = LETTERS.get(level, "v")',
    "a default of a table written there": 'x = {"en": 1, "zh": 2}.get(language, 1)',
}
FOUND_TWICE = """
def f(joint: Joint):
    match joint:
        case Pin():
            return 1
        case _:
            return g(joint)
def g(joint: Slide | Chain):
    match joint:
        case Slide():
            return 2
        case _:
            return 3
"""
PASSED = {
    "all named": """
match joint:
    case Pin(point=point) | Slide():
        x = 1
    case Chain():
        x = 2
    case _:
        assert_never(joint)
""",
    "a refusal": """
match joint:
    case Pin():
        x = 1
    case _:
        raise TypeError("no such joint")
""",
    "a last case handed on to a function that names the rest": """
def f(joint: Joint, scale: int):
    match joint:
        case Pin():
            return 1
        case _:
            return g(joint, scale)
def g(joint: Slide | Chain, scale: int):
    match joint:
        case Slide():
            return 2
        case Chain():
            return 3
        case _:
            assert_never(joint)
""",
    "a last case handed on by name": """
def f(joint: Joint):
    match joint:
        case Pin():
            x = 1
        case _:
            x = g(2, joint=joint)
    return x
def g(scale: int, joint: Slide | Chain):
    match joint:
        case Slide() | Chain():
            return 2
        case _:
            assert_never(joint)
""",
    "a chain that ends in assert_never": """
def f():
    if isinstance(joint, Pin):
        return 1
    if isinstance(joint, Slide):
        return 2
    assert_never(joint)
""",
    "a filter": """
def f():
    if not isinstance(joint, Pin):
        return None
    return joint.point
""",
    "a filter in a loop": """
for joint in joints:
    if not isinstance(joint, Pin):
        continue
    x = 1
""",
    "a filter in a conditional": 'x = joint.point if isinstance(joint, Pin) else ""',
    "something more for one kind": """
if isinstance(joint, Pin):
    x = 1
""",
    "a table indexed": "x = WORDS[language]",
    "foreign types": "x = 1 if isinstance(joint, str) else 2",
    "foreign texts": 'x = 1 if token == "{" else 2',
    "foreign tables": "x = names.get(name, name)",
    "a match over foreign texts": """
match token:
    case "{":
        x = 1
    case _:
        x = 2
""",
}


@pytest.mark.parametrize("form", FOUND)
def test_a_default_is_found_in_every_form_that_it_takes(form: str) -> None:
    tree = ast.parse(FOUND[form])
    assert len(list(defaults(tree, vocabulary([ast.parse(OWN)])))) == 1


def test_a_last_case_handed_on_to_a_default_is_found_in_both_functions() -> None:
    found = defaults(ast.parse(FOUND_TWICE), vocabulary([ast.parse(OWN)]))
    assert [line for line, _ in found] == [6, 12]


@pytest.mark.parametrize("form", PASSED)
def test_what_names_all_refuses_or_only_filters_is_no_default(form: str) -> None:
    tree = ast.parse(PASSED[form])
    assert list(defaults(tree, vocabulary([ast.parse(OWN)]))) == []
