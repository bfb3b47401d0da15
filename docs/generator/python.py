"""The page of the public names, from their signatures and docstrings."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import is_dataclass

import kinegrade
from docs.generator.markdown import write_page
from kinegrade.public.problem import Problem


def write_python_page() -> str:
    """Every public name with what it takes, and what its docstring says."""
    names = [name for name in kinegrade.__all__ if not name.startswith("_")]
    return write_page(
        "# Python",
        str(kinegrade.__doc__).split("\n\n")[-1].strip(),
        *(block for name in names for block in _describe(name, getattr(kinegrade, name))),
    )


def _describe(name: str, value: Callable[..., object]) -> Iterator[str]:
    yield f"## {name}"
    if name.endswith("Options") or inspect.isfunction(value):
        yield _write_call(name, value)
    yield from _write_docstring(value)
    if hasattr(value, "read"):
        yield _write_call(f"{name}.read", value.read)
        yield from _write_docstring(value.read)
    if value is kinegrade.template:
        yield _write_call("template(...).solve", Problem.solve)
        yield from _write_docstring(Problem.solve)


def _write_call(name: str, value: Callable[..., object]) -> str:
    """How it is called, a parameter a line, and the type of what it gives; a star stands before the
    first that has to be named.
    """
    lines = ["```text", f"{name}("]
    signature = inspect.signature(value)
    for each in signature.parameters.values():
        if each.name == "self":
            continue
        if each.kind is inspect.Parameter.KEYWORD_ONLY and "    *," not in lines:
            lines.append("    *,")
        lines.append(f"    {_write_parameter(each)},")
    given = signature.return_annotation
    gives = "" if given in (None, "None", inspect.Signature.empty) else f" -> {given}"
    return "\n".join((*lines, f"){gives}", "```"))


def _write_parameter(parameter: inspect.Parameter) -> str:
    """Name, type and default; a default that has no short text of its own is left out."""
    stars = "**" if parameter.kind is inspect.Parameter.VAR_KEYWORD else ""
    written = f"{stars}{parameter.name}: {parameter.annotation}"
    default = parameter.default
    if is_dataclass(default) and not isinstance(default, type):
        return f"{written} = {type(default).__name__}()"
    unwritten = default is inspect.Parameter.empty or inspect.isfunction(default)
    if unwritten or repr(default) == "<factory>":
        return written
    return f"{written} = {default!r}"


def _write_docstring(value: object) -> Iterator[str]:
    """The paragraphs of a docstring; its examples as blocks."""
    for paragraph in (inspect.getdoc(value) or "").split("\n\n"):
        if paragraph.startswith(">>>"):
            yield f"```pycon\n{paragraph}\n```"
        else:
            yield paragraph
