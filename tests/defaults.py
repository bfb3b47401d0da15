"""Finds choices over our own types that end in a default: what mypy does not see, from the syntax
trees alone.

A choice is a `match`, a chain of `if`s or a conditional expression that asks which of our own
types, literals or languages it has. A default is what such a choice gives to whatever it has not
asked for: a thing added later gets it without a word. Asking for one kind alone and giving nothing
otherwise (None, False, an empty text or tuple, the next round of a loop) is a filter and no choice.
Nor is a match in two parts a default, whose last case hands what it matches on to a function of the
module that says which types it takes and refuses all others: mypy sees that these are what is left.
Which types and literals are our own is read from the same syntax trees.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from tests.own_words import (
    Function,
    Question,
    Vocabulary,
    find_name,
    find_question,
    is_table,
    list_members,
    list_texts,
    narrow_vocabulary,
)


def _refuses(statement: ast.stmt) -> bool:
    """Whether a statement refuses what comes to it."""
    if isinstance(statement, ast.Raise):
        return True
    value = statement.value if isinstance(statement, ast.Expr | ast.Return) else None
    return isinstance(value, ast.Call) and find_name(value.func) in ("assert_never", "unreachable")


def _empty(value: ast.expr | None) -> bool:
    """Whether a value says nothing: None, False, an empty text or collection."""
    match value:
        case None | ast.Constant(value=None | False | ""):
            return True
        case ast.Tuple(elts=[]) | ast.List(elts=[]) | ast.Dict(keys=[]):
            return True
        case _:
            return False


def _nothing(statement: ast.stmt) -> bool:
    """Whether a statement gives nothing: returns what is empty, or goes on to the next round."""
    if isinstance(statement, ast.Return):
        return _empty(statement.value)
    return isinstance(statement, ast.Continue | ast.Break | ast.Pass)


def _leaves(body: Sequence[ast.stmt]) -> bool:
    return isinstance(body[-1], ast.Return | ast.Raise | ast.Continue | ast.Break)


def defaults(tree: ast.AST, words: Vocabulary) -> Iterator[tuple[int, str]]:
    """The line and the text of every choice over our own things that ends in a default."""
    words = narrow_vocabulary(tree, words)
    for node in ast.walk(tree):
        match node:
            case ast.Match():
                yield from _of_match(node, words)
            case ast.IfExp():
                yield from _of_conditional(node, words)
            case ast.Call():
                yield from _of_lookup(node, words)
            case ast.Lambda():
                pass
            case _:
                for block in _blocks(node):
                    yield from _of_block(block, words)


def _blocks(node: ast.AST) -> Iterator[list[ast.stmt]]:
    for part in ("body", "orelse", "finalbody"):
        block = getattr(node, part, None)
        if not isinstance(block, list) or not block or not isinstance(block[0], ast.stmt):
            continue
        further = isinstance(node, ast.If) and part == "orelse" and isinstance(block[0], ast.If)
        if not further:
            yield block


def _of_match(node: ast.Match, words: Vocabulary) -> Iterator[tuple[int, str]]:
    patterns = [part for case in node.cases for part in ast.walk(case.pattern)]
    classes = {find_name(part.cls) for part in patterns if isinstance(part, ast.MatchClass)}
    for part in patterns:
        if isinstance(part, ast.MatchClass) and part.patterns:
            if find_name(part.cls) not in words.unpositional:
                continue
            yield part.lineno, f"positional pattern: {ast.unparse(part)}"
    values = list_texts([part.value for part in patterns if isinstance(part, ast.MatchValue)])
    own = classes & words.classes or set(values) & (_values_of(node.subject, words))
    last = node.cases[-1]
    takes_all = isinstance(last.pattern, ast.MatchAs) and last.pattern.pattern is None
    if not own or not takes_all or last.guard:
        return
    if not _refuses(last.body[0]) and not _hands_on(last.body[0], node.subject, words):
        yield last.pattern.lineno, f"match {ast.unparse(node.subject)}: {ast.unparse(last.pattern)}"


def _hands_on(statement: ast.stmt, subject: ast.expr, words: Vocabulary) -> bool:
    """Whether a statement does no more than call a function of the module that names the types
    which are left of the subject, and refuses all others.
    """
    call = statement.value if isinstance(statement, ast.Assign | ast.Expr | ast.Return) else None
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name):
        return False
    function = words.functions.get(call.func.id)
    if function is None:
        return False
    parameters = function.args.args
    given = [*zip(parameters, call.args, strict=False), *_named_arguments(parameters, call)]
    return any(
        ast.dump(argument) == ast.dump(subject) and _takes_up(function, parameter, words)
        for parameter, argument in given
    )


def _named_arguments(
    parameters: Sequence[ast.arg], call: ast.Call
) -> Iterator[tuple[ast.arg, ast.expr]]:
    by_name = {parameter.arg: parameter for parameter in parameters}
    for keyword in call.keywords:
        if keyword.arg in by_name:
            yield by_name[keyword.arg], keyword.value


def _takes_up(function: Function, parameter: ast.arg, words: Vocabulary) -> bool:
    """Whether a function says which of our types a parameter has, and matches it without a
    default.
    """
    members = list_members(parameter.annotation) if parameter.annotation else frozenset()
    if not members or not members <= words.classes:
        return False
    return any(
        isinstance(node, ast.Match)
        and ast.unparse(node.subject) == parameter.arg
        and _refuses(node.cases[-1].body[0])
        for node in function.body
    )


def _values_of(subject: ast.expr, words: Vocabulary) -> frozenset[str]:
    parts = subject.elts if isinstance(subject, ast.Tuple) else [subject]
    found = [words.values.get(find_name(part), frozenset()) for part in parts]
    return words.languages.union(*found)


def _of_conditional(node: ast.IfExp, words: Vocabulary) -> Iterator[tuple[int, str]]:
    question = find_question(node.test, words)
    if question:
        otherwise = node.body if question.negated else node.orelse
        if not _empty(otherwise):
            yield node.lineno, ast.unparse(node)


def _of_lookup(node: ast.Call, words: Vocabulary) -> Iterator[tuple[int, str]]:
    if isinstance(node.func, ast.Attribute) and node.func.attr == "get" and len(node.args) == 2:
        table = node.func.value
        written = isinstance(table, ast.Dict) and is_table(table, words.literals)
        if written or find_name(table) in words.tables:
            yield node.lineno, ast.unparse(node)


def _of_block(block: Sequence[ast.stmt], words: Vocabulary) -> Iterator[tuple[int, str]]:
    """The choices made by the `if`s of a block, each with those that follow it about the same
    thing.
    """
    asked: dict[str, int] = {}
    for place, statement in enumerate(block):
        if not isinstance(statement, ast.If):
            continue
        chain = _chain(statement)
        questions = [question for test in chain if (question := find_question(test, words))]
        if not questions:
            continue
        first = questions[0]
        asked[first.subject] = asked.get(first.subject, 0) + len(questions)
        rest = _otherwise(statement, _after(block[place + 1 :]), first)
        if rest is None or _refuses(rest[0]) or _asks_on(rest[0], first, words):
            continue
        if asked[first.subject] == 1 and _nothing(rest[0]):
            continue
        yield statement.lineno, f"if {ast.unparse(statement.test)}"


def _after(following: Sequence[ast.stmt]) -> Sequence[ast.stmt]:
    """What follows, without further `if`s that leave where the last word is a refusal."""
    place = 0
    while place < len(following) and _is_exit(following[place]):
        place += 1
    ends = place < len(following) and _refuses(following[place])
    return following[place:] if ends else following


def _is_exit(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.If) and not statement.orelse and _leaves(statement.body)


def _chain(statement: ast.If) -> list[ast.expr]:
    """The tests of an `if` and its `elif`s."""
    tests = [statement.test]
    while len(statement.orelse) == 1 and isinstance(statement.orelse[0], ast.If):
        statement = statement.orelse[0]
        tests.append(statement.test)
    return tests


def _otherwise(
    statement: ast.If, following: Sequence[ast.stmt], question: Question
) -> Sequence[ast.stmt] | None:
    """What is done with a thing that was not asked for; None where a lone `if` only adds
    something.
    """
    end = statement
    while len(end.orelse) == 1 and isinstance(end.orelse[0], ast.If):
        end = end.orelse[0]
    if question.negated:
        return statement.body if statement.orelse or _leaves(statement.body) else None
    if end.orelse:
        return end.orelse
    return following if _leaves(statement.body) and following else None


def _asks_on(statement: ast.stmt, question: Question, words: Vocabulary) -> bool:
    """Whether a statement goes on to ask about the same thing."""
    if isinstance(statement, ast.Match):
        return ast.unparse(statement.subject) == question.subject
    if isinstance(statement, ast.If):
        further = find_question(statement.test, words)
        return further is not None and further.subject == question.subject
    return False
