"""The axes, what is given, and the lengths that follow from it, as the statement prints them."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.description.motions import find_said
from kinegrade.description.subject import Subject
from kinegrade.expressions.tree import find_names
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message, list_plainly
from kinegrade.problem.given import list_givens


def say_givens(subject: Subject) -> Iterator[Message]:
    """How directions count; the givens, without those that the motions say; lengths that follow."""
    yield Message("description.axes")
    printed = list(_list_printed(subject))
    if printed:
        yield Message("description.givens", givens=list_plainly(printed))
    lengths = list(_list_lengths(subject))
    if lengths:
        yield Message("description.lengths", lengths=list_plainly(lengths))


def _list_printed(subject: Subject) -> Iterator[str]:
    drivers = subject.case.solution.assembly.mechanism.drivers
    said = [driven for driver in drivers if (driven := find_said(driver, subject)) is not None]
    moving = {given for driven in said for given in driven.givens}
    for name, given in list_givens(subject.template, subject.case.solution.parameters).items():
        if name in subject.printed - moving:
            yield write_decimals_of_prose(str(given), subject.case.language)


def _list_lengths(subject: Subject) -> Iterator[str]:
    """The lengths of the template that circles of its joints or its points name."""
    shapes = [shape for _, joint in subject.joints for shape in (joint.circle, joint.on)]
    trees = [shape for shape in shapes if shape is not None]
    trees_of_points = [step.tree for step in subject.steps]
    named = {name for tree in (*trees, *trees_of_points) for name in find_names(tree)}
    for name, tree in subject.template.scheme.lengths.items():
        if name in named:
            letter = subject.case.text(subject.instance.symbols[name])
            length = subject.telling.text(subject.numbers.name(tree))
            yield f"${letter} = {length}$"
