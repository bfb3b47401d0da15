"""No choice over our own types, literals and languages ends in a default that takes a new thing for
an old one.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from kinegrade.language.known import known_languages
from tests.defaults import defaults
from tests.own_words import Vocabulary, vocabulary
from tests.package_files import GROUP, locate, package_files

pytestmark = GROUP
EXCEPTIONS = {
    "figure/mechanism/wheels/outlines.py: if rim.kind == 'cam'": "any other circle is its own outline, "
    "or one of several of a cam",
    "press/solutions/content.py: _draw(part) if isinstance(part, Pictures) else part": "whatever is no "
    "picture has been chained",
    "worked/formulas/expression.py: if not isinstance(tree, Operation)": "what is no operation has no "
    "factors",
    "worked/formulas/expression.py: if tree.sign == '+'": "of sums and differences alone, the other one",
    "worked/solution.py: (first, rounding) if isinstance(first, Heading) "
    "else (rounding, first)": "what stands below a heading stands above anything else",
    "press/solutions/shortening.py: match block: _": "what is neither a picture nor about a polygon "
    "stays",
    "press/solutions/shortening.py: if not isinstance(block, Pictures)": "pictures alone are left out",
    "worked/checks/seen.py: match tree: _": "any other quantity is no velocity seen from a frame",
    "proof/causes.py: if refused.reason == 'mistake'": "any other reason is of one cause at one ask or place",
    "proof/causes.py: detail.where if isinstance(detail, Fault) else detail": "what is no fault has no place "
    "and is one cause by what it says",
    "figure/mechanism/straight/welded_rods.py: _run_past(part, rods) if isinstance(part, Bar) "
    "else part": "only a bar has a slot that may run past a rod",
    "practice/sampling.py: np.linspace(*_find_way(path), count) if endless "
    "else spread(count)": "a path with any other end has its own spacing towards it",
    "worked/steps/used_points.py: found if MOTION_FUNCTIONS[call.function].level != 'acceleration' "
    "else ()": "an acceleration alone is never taken about the point of contact",
    "language/math/spoken/nodes.py: match row[place]: _": "nothing else spells a unit",
    "language/math/spoken/nodes.py: match upper: _": "any other exponent is said as it stands",
    "language/math/spoken/units.py: match node: _": "what no unit is spelt with spells none",
    "press/solutions/chains.py: match (block, following, third): _": "what stays together is named; "
    "a new block may be parted from its neighbours, which costs looks and nothing else",
    "press/solutions/settings.py: if not isinstance(display, "
    "MeasuredDisplay)": "only equations stand on the line of a sentence; what else follows stands by itself",
    "lms/grades/from_scratch.py: options.columns.get(item, '')": "what the instructor named no column for",
    "grading/judging/decision.py: if verdict.kind == 'right'": "whatever is not right goes on to be looked "
    "at for credit, by what was read, which is a choice of its own",
    "problem/template/meaning/meaning.py: if tree.sign == "
    "'**'": "the exponent is no operand; the other signs are matched below",
    "problem/template/meaning/meaning.py: if isinstance(kind, "
    "Unknown)": "what is not known fits anywhere; the slots are matched below",
    "worked/answers/poses.py: if first.relation == "
    "'='": "a value in another unit that is not exact stands after the exact ones",
    "problem/pole_names.py: match read_math(ask.symbol, ask.name): "
    "_": "what is not the coordinate of a point names no point",
    "problem/pole_names.py: match ask.quantity: _": "whatever else an ask asks for is no distance",
    "problem/pole_names.py: match row: _": "letters side by side; what is no letter is none below",
    "problem/pole_names.py: match node: _": "whatever else stands in a symbol names no point",
    "proof/causes.py: if cause.reason == 'figure'": "what helps with a figure is said there alone",
    "proof/ends.py: match template.scheme.points.get(name): _": "only `toward` says between what a point lies",
    "expressions/signs.py: match tree: _": "what is no product or quotient is its own only factor",
    "proof/reach.py: match tree: _": "two circles, or a circle and a line, may miss each other; nothing else does",
    "worked/answers/angles_between.py: match ask.quantity: _": "whatever else an ask asks for is no angle to a line",
    "worked/answers/answer_senses.py: match quantity: _": "whatever else an ask asks for is no "
    "component along or across a line",
    "worked/answers/answer_senses.py: match line: _": "a line from another point has no sense about it",
    "worked/vectors/arms.py: match step.tree: _": "only a midpoint halves a length",
    "grading/sheets/header_units.py: if one.kind != 'number'": "a unit by which a one is no number is none",
    "proof/ends.py: match joint.on: _": "a circle, or a line by its direction, has no ends",
    "worked/asked_senses.py: match tree: _": "whatever else is asked for has no circle about whose "
    "centre it counts",
    "worked/vectors/arms.py: match call: _": "whatever else constructs a point gives no distance",
    "worked/vectors/relatives.py: match read_symbol(symbol).row: "
    "_": "whatever else an ask is called leaves v_r to others",
    "worked/formulas/printed.py: enclose(self.print(notation)) if self.kind == 'sum' else "
    "self.print_after_sign(notation)": "only a sum needs brackets after a minus sign",
    "worked/formulas/functions.py: if self.argument.kind in ('function', 'closed', "
    "'sum')": "the others may be plain, which the next line decides",
    "worked/formulas/atoms.py: enclose(row) if self.number.kind == 'sum' else "
    "row": "only a sum needs brackets before a unit",
    "worked/formulas/symbols.py: first.base if isinstance(first, Scripts) else "
    "first": "a letter without an index is itself its base",
    "worked/formulas/symbols.py: if isinstance(first, "
    "Scripts)": "a letter without an index is itself its base",
    "worked/rates/driven.py: (*before, structs.replace(last, upper=None)) if isinstance(last, Scripts) else "
    "row": "what has no scripts has nothing above it",
    "worked/positions/vectors.py: if isinstance(factor, "
    "Quotient)": "a fraction stands before a vector, any other factor as an expression has it",
    "description/places.py: match (function, arguments): "
    "_": "what no sentence is for is said by its coordinates",
    "worked/formulas/leaves.py: match tree: "
    "_": "what is not the difference of two points is no vector between points",
    "lms/grades/item_groups.py: 'feedback' if known == 'feedback' else "
    "'percentage'": "the cells decide; a known word may only say that they are feedback",
    "grading/sheets/part.py: places.get(row.line, ())": "cells stand in their row, where no others "
    "are named",
    "problem/assembling/measures.py: if isinstance(value, (Vector, Line, Round, str))": "numbers of "
    "any arithmetic are taken, what is known to be no number is refused",
    "problem/assembling/parts.py: if isinstance(value, (Vector, Line, Round, str))": "angles of any "
    "arithmetic are taken, what is known to be none is refused",
}


@cache
def words_of_package() -> tuple[Mapping[str, ast.Module], Vocabulary]:
    """The syntax trees of the package by file, and what they define."""
    trees = {locate(file): file.tree for file in package_files()}
    words = vocabulary(list(trees.values()))
    return trees, replace(words, languages=frozenset(known_languages()))


def test_our_own_types_and_literals_are_known_from_the_package_itself() -> None:
    _, words = words_of_package()
    assert {
        "Pin",
        "Chain",
        "Rotation",
        "Label",
        "Heading",
        "Operation",
        "Line",
    } - words.classes == {"Chain"}
    assert {"Pin", "Slide", "Mesh", "Rotation", "Circulation"} <= words.unpositional
    assert words.languages >= {"en", "zh"}
    assert words.values["level"] == {"velocity", "acceleration"}
    assert {"moodle", "canvas", "qti21"} <= words.values["typing"]
    assert {"rotation", "sliding"} <= words.values["kind"]
    assert {"LETTERS", "_FILLS"} <= words.tables


@cache
def defaults_of_package() -> Mapping[str, str]:
    """Every default in the package, by its file and its text, with the lines that have it."""
    trees, words = words_of_package()
    found: dict[str, str] = {}
    for file, tree in trees.items():
        for line, text in defaults(tree, words):
            name = f"{file}: {text}"
            found[name] = f"{found[name]}, {line}" if name in found else f"{file}:{line}"
    return found


def test_a_new_joint_word_or_language_never_takes_the_place_of_an_old_one() -> None:
    found = defaults_of_package()
    assert {text: found[text] for text in found.keys() - EXCEPTIONS} == {}


def test_every_exception_is_still_there() -> None:
    assert EXCEPTIONS.keys() - defaults_of_package().keys() == set()
