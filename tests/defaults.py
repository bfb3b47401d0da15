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
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

LANGUAGE = "Language"
POSITIONAL_REFUSED = ("Joint", "Driver")
Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Vocabulary:
    """Our own words in the trees.

    `classes`: the members of unions of our own classes. `values`: of each name (of a parameter, a
    field, a variable, a function) the literals that its annotation allows. `tables`: the names of
    mappings keyed by such literals. `languages`: the literals of the type Language. `unpositional`:
    the classes whose patterns name their fields. `answers`: in one module the names to which the
    outcome of a test is given, as `turns = kind == "rotation"`. `functions`: those of one module.
    """

    classes: frozenset[str]
    values: Mapping[str, frozenset[str]]
    tables: frozenset[str]
    languages: frozenset[str]
    unpositional: frozenset[str]
    answers: Mapping[str, Question] = field(default_factory=dict)
    functions: Mapping[str, Function] = field(default_factory=dict)

    @property
    def literals(self) -> frozenset[str]:
        """All literals of our own types."""
        return frozenset().union(*self.values.values())


@dataclass(frozen=True)
class Question:
    """A test of a choice: what is asked about, and which of our own things are asked for."""

    subject: str
    asked: frozenset[str]
    negated: bool


# --- what is our own
# -------------------------------------------------------------------------------------------------


def vocabulary(trees: Sequence[ast.AST]) -> Vocabulary:
    """The types and literals that some trees define for themselves."""
    nodes = [node for tree in trees for node in ast.walk(tree)]
    classes = {node.name for node in nodes if isinstance(node, ast.ClassDef)}
    unions = [members for members in map(_members, nodes) if len(members & classes) > 1]
    aliases = _literal_aliases(nodes)
    values: dict[str, frozenset[str]] = {}
    tables: set[str] = set()
    for name, annotation in _annotated(nodes):
        allowed = _allowed(annotation, aliases)
        if allowed:
            values[name] = values.get(name, frozenset()) | allowed
        if _keyed(annotation, aliases):
            tables.add(name)
    literals = frozenset().union(*aliases.values(), *values.values())
    return Vocabulary(
        frozenset().union(*unions) & frozenset(classes),
        values,
        frozenset(tables | set(_named_tables(nodes, literals))),
        aliases.get(LANGUAGE, frozenset()),
        _union_aliases(nodes, POSITIONAL_REFUSED),
    )


def _members(node: ast.AST) -> frozenset[str]:
    """The names in a union written with bars."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr):
        return _members(node.left) | _members(node.right)
    return frozenset({node.id}) if isinstance(node, ast.Name) else frozenset()


def _union_aliases(nodes: Sequence[ast.AST], names: Sequence[str]) -> frozenset[str]:
    found: frozenset[str] = frozenset()
    for name, value in _assigned(nodes):
        if name in names:
            found |= _members(value)
    return found


def _assigned(nodes: Sequence[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    for node in nodes:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            yield node.targets[0].id, node.value
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value:
            yield node.target.id, node.value


def _literal(node: ast.AST) -> frozenset[str]:
    """The texts of `Literal[...]`; nothing for anything else."""
    if isinstance(node, ast.Subscript) and _name(node.value) == "Literal":
        inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        return frozenset(_texts(inner))
    return frozenset()


def _literal_aliases(nodes: Sequence[ast.AST]) -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for name, value in _assigned(nodes):
        if _literal(value):
            found[name] = found.get(name, frozenset()) | _literal(value)
    return found


def _texts(nodes: Sequence[ast.expr | None]) -> list[str]:
    return [
        node.value
        for node in nodes
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]


def _annotated(nodes: Sequence[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    for node in nodes:
        if isinstance(node, ast.AnnAssign):
            yield _name(node.target), node.annotation
        elif isinstance(node, ast.arg) and node.annotation:
            yield node.arg, node.annotation
        elif isinstance(node, Function) and node.returns:
            yield node.name, node.returns


def _allowed(annotation: ast.expr, aliases: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """The literals of an annotation that is a literal type, or such a type or None."""
    if isinstance(annotation, ast.BinOp):
        return _allowed(annotation.left, aliases) | _allowed(annotation.right, aliases)
    if isinstance(annotation, ast.Name):
        return aliases.get(annotation.id, frozenset())
    return _literal(annotation)


def _keyed(annotation: ast.expr, aliases: Mapping[str, frozenset[str]]) -> bool:
    """Whether an annotation is that of a mapping from a literal type."""
    return (
        isinstance(annotation, ast.Subscript)
        and _name(annotation.value) in ("Mapping", "dict")
        and isinstance(annotation.slice, ast.Tuple)
        and bool(_allowed(annotation.slice.elts[0], aliases))
    )


def _named_tables(nodes: Sequence[ast.AST], literals: frozenset[str]) -> Iterator[str]:
    for name, value in _assigned(nodes):
        if isinstance(value, ast.Dict) and _is_table(value, literals):
            yield name


def _is_table(node: ast.Dict, literals: frozenset[str]) -> bool:
    keys = _texts(node.keys)
    return len(keys) == len(node.keys) > 1 and set(keys) <= literals


# --- what is asked
# ---------------------------------------------------------------------------------------------------


def _name(node: ast.AST) -> str:
    """The last word of what an expression names: `relation.source` -> source, `level_of(x)` ->
    level_of.
    """
    match node:
        case ast.Name():
            return node.id
        case ast.Attribute():
            return node.attr
        case ast.Call():
            return _name(node.func)
        case _:
            return ""


def _question(test: ast.expr, words: Vocabulary) -> Question | None:
    """What a plain test asks of our own things; None for any other test."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        inner = _question(test.operand, words)
        return Question(inner.subject, inner.asked, not inner.negated) if inner else None
    if isinstance(test, ast.Call) and _name(test.func) == "isinstance":
        asked = {_name(node) for node in ast.walk(test.args[1])} & words.classes
        return Question(ast.unparse(test.args[0]), frozenset(asked), False) if asked else None
    if isinstance(test, ast.Compare) and len(test.ops) == 1:
        return _comparison(test, words)
    return words.answers.get(test.id) if isinstance(test, ast.Name) else None


def _comparison(test: ast.Compare, words: Vocabulary) -> Question | None:
    negated = isinstance(test.ops[0], ast.NotEq | ast.NotIn)
    if not negated and not isinstance(test.ops[0], ast.Eq | ast.In):
        return None
    right = test.comparators[0]
    inner = right.elts if isinstance(right, ast.Tuple | ast.Set | ast.List) else [right]
    subject, asked = test.left, frozenset(_texts(inner))
    if not asked:
        subject, asked = right, frozenset(_texts([test.left]))
    own = asked & (words.values.get(_name(subject), frozenset()) | words.languages)
    return Question(ast.unparse(subject), own, negated) if own else None


# --- what is given otherwise
# -----------------------------------------------------------------------------------------


def _refuses(statement: ast.stmt) -> bool:
    """Whether a statement refuses what comes to it."""
    if isinstance(statement, ast.Raise):
        return True
    value = statement.value if isinstance(statement, ast.Expr | ast.Return) else None
    return isinstance(value, ast.Call) and _name(value.func) in ("assert_never", "unreachable")


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


# --- the walk
# --------------------------------------------------------------------------------------------------------


def defaults(tree: ast.AST, words: Vocabulary) -> Iterator[tuple[int, str]]:
    """The line and the text of every choice over our own things that ends in a default."""
    words = _here(tree, words)
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


def _here(tree: ast.AST, words: Vocabulary) -> Vocabulary:
    """The words as a module uses them: what it makes a dictionary of other keys is no table of ours
    there.
    """
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Assign)]
    others = {
        name
        for name, value in _assigned(nodes)
        if not (isinstance(value, ast.Dict) and _is_table(value, words.literals))
    }
    answers = {
        name: question for name, value in _assigned(nodes) if (question := _question(value, words))
    }
    functions = {
        node.name: node for node in ast.iter_child_nodes(tree) if isinstance(node, Function)
    }
    return replace(words, tables=words.tables - others, answers=answers, functions=functions)


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
    classes = {_name(part.cls) for part in patterns if isinstance(part, ast.MatchClass)}
    for part in patterns:
        if isinstance(part, ast.MatchClass) and part.patterns:
            if _name(part.cls) not in words.unpositional:
                continue
            yield part.lineno, f"positional pattern: {ast.unparse(part)}"
    values = _texts([part.value for part in patterns if isinstance(part, ast.MatchValue)])
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
    members = _members(parameter.annotation) if parameter.annotation else frozenset()
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
    found = [words.values.get(_name(part), frozenset()) for part in parts]
    return words.languages.union(*found)


def _of_conditional(node: ast.IfExp, words: Vocabulary) -> Iterator[tuple[int, str]]:
    question = _question(node.test, words)
    if question:
        otherwise = node.body if question.negated else node.orelse
        if not _empty(otherwise):
            yield node.lineno, ast.unparse(node)


def _of_lookup(node: ast.Call, words: Vocabulary) -> Iterator[tuple[int, str]]:
    if isinstance(node.func, ast.Attribute) and node.func.attr == "get" and len(node.args) == 2:
        table = node.func.value
        written = isinstance(table, ast.Dict) and _is_table(table, words.literals)
        if written or _name(table) in words.tables:
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
        questions = [question for test in chain if (question := _question(test, words))]
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
        further = _question(statement.test, words)
        return further is not None and further.subject == question.subject
    return False
