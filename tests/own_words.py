"""The types, literals and languages that a package defines for itself, and the questions that its
choices ask of them, read from its syntax trees.

`tests.defaults` is the next storey up.
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


def vocabulary(trees: Sequence[ast.AST]) -> Vocabulary:
    """The types and literals that some trees define for themselves."""
    nodes = [node for tree in trees for node in ast.walk(tree)]
    classes = {node.name for node in nodes if isinstance(node, ast.ClassDef)}
    unions = [members for members in map(list_members, nodes) if len(members & classes) > 1]
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


def narrow_vocabulary(tree: ast.AST, words: Vocabulary) -> Vocabulary:
    """The words as a module uses them: what it makes a dictionary of other keys is no table of ours
    there.
    """
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Assign)]
    others = {
        name
        for name, value in list_assigned(nodes)
        if not (isinstance(value, ast.Dict) and is_table(value, words.literals))
    }
    answers = {
        name: question
        for name, value in list_assigned(nodes)
        if (question := find_question(value, words))
    }
    functions = {
        node.name: node for node in ast.iter_child_nodes(tree) if isinstance(node, Function)
    }
    return replace(words, tables=words.tables - others, answers=answers, functions=functions)


def list_members(node: ast.AST) -> frozenset[str]:
    """The names in a union written with bars."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr):
        return list_members(node.left) | list_members(node.right)
    return frozenset({node.id}) if isinstance(node, ast.Name) else frozenset()


def _union_aliases(nodes: Sequence[ast.AST], names: Sequence[str]) -> frozenset[str]:
    found: frozenset[str] = frozenset()
    for name, value in list_assigned(nodes):
        if name in names:
            found |= list_members(value)
    return found


def list_assigned(nodes: Sequence[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    for node in nodes:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            yield node.targets[0].id, node.value
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value:
            yield node.target.id, node.value


def _literal(node: ast.AST) -> frozenset[str]:
    """The texts of `Literal[...]`; nothing for anything else."""
    if isinstance(node, ast.Subscript) and find_name(node.value) == "Literal":
        inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        return frozenset(list_texts(inner))
    return frozenset()


def _literal_aliases(nodes: Sequence[ast.AST]) -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for name, value in list_assigned(nodes):
        if _literal(value):
            found[name] = found.get(name, frozenset()) | _literal(value)
    return found


def list_texts(nodes: Sequence[ast.expr | None]) -> list[str]:
    return [
        node.value
        for node in nodes
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]


def _annotated(nodes: Sequence[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    for node in nodes:
        if isinstance(node, ast.AnnAssign):
            yield find_name(node.target), node.annotation
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
        and find_name(annotation.value) in ("Mapping", "dict")
        and isinstance(annotation.slice, ast.Tuple)
        and bool(_allowed(annotation.slice.elts[0], aliases))
    )


def _named_tables(nodes: Sequence[ast.AST], literals: frozenset[str]) -> Iterator[str]:
    for name, value in list_assigned(nodes):
        if isinstance(value, ast.Dict) and is_table(value, literals):
            yield name


def is_table(node: ast.Dict, literals: frozenset[str]) -> bool:
    keys = list_texts(node.keys)
    return len(keys) == len(node.keys) > 1 and set(keys) <= literals


def find_name(node: ast.AST) -> str:
    """The last word of what an expression names: `relation.source` -> source, `level_of(x)` ->
    level_of.
    """
    match node:
        case ast.Name():
            return node.id
        case ast.Attribute():
            return node.attr
        case ast.Call():
            return find_name(node.func)
        case _:
            return ""


def find_question(test: ast.expr, words: Vocabulary) -> Question | None:
    """What a plain test asks of our own things; None for any other test."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        inner = find_question(test.operand, words)
        return Question(inner.subject, inner.asked, not inner.negated) if inner else None
    if isinstance(test, ast.Call) and find_name(test.func) == "isinstance":
        asked = {find_name(node) for node in ast.walk(test.args[1])} & words.classes
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
    subject, asked = test.left, frozenset(list_texts(inner))
    if not asked:
        subject, asked = right, frozenset(list_texts([test.left]))
    own = asked & (words.values.get(find_name(subject), frozenset()) | words.languages)
    return Question(ast.unparse(subject), own, negated) if own else None
