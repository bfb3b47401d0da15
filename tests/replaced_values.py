"""A plugin of the type checker: which `replace` a value class takes, and which fields it has.

msgspec's structs look like dataclasses to a type checker, and are none: `dataclasses.replace` of one
passes it and is an error at run time, and `msgspec.structs.replace` takes any keyword there.
"""

from __future__ import annotations

from collections.abc import Callable

from mypy.nodes import TypeInfo
from mypy.plugin import FunctionContext, Plugin
from mypy.types import Instance, Type, TypeVarType, UnionType, get_proper_type

OF_DATACLASSES = "dataclasses.replace"
OF_STRUCTS = "msgspec.structs.replace"
STRUCT = "msgspec.Struct"


class ReplacedValues(Plugin):
    """Checks every call of either `replace`."""

    def get_function_hook(self, fullname: str) -> Callable[[FunctionContext], Type] | None:
        """The check of a function's calls; None for all but the two."""
        match fullname:
            case "dataclasses.replace":
                return _check_dataclass
            case "msgspec.structs.replace":
                return _check_struct
            case _:
                return None


def _check_dataclass(context: FunctionContext) -> Type:
    """No struct is given to `dataclasses.replace`."""
    for changed in _list_classes(context.arg_types[0][0]):
        if changed.has_base(STRUCT):
            what = f"{changed.name} is a struct: {OF_STRUCTS} changes it, not {OF_DATACLASSES}"
            context.api.fail(what, context.context)
    return context.default_return_type


def _check_struct(context: FunctionContext) -> Type:
    """What `msgspec.structs.replace` changes are fields of the struct."""
    for changed in _list_classes(context.arg_types[0][0]):
        for name in _list_keywords(context):
            if changed.get(name) is None:
                what = f"{changed.name} has no field {name} to change"
                context.api.fail(what, context.context)
    return context.default_return_type


def _list_classes(given: Type) -> list[TypeInfo]:
    """The classes that a value of a type may be of."""
    match get_proper_type(given):
        case Instance(type=one):
            return [one]
        case UnionType(items=items):
            return [one for item in items for one in _list_classes(item)]
        case TypeVarType(upper_bound=bound):
            return _list_classes(bound)
        case _:
            return []


def _list_keywords(context: FunctionContext) -> list[str]:
    """The names that a call changes."""
    return [name for names in context.arg_names for name in names if name is not None]


def plugin(version: str) -> type[Plugin]:
    """What the type checker asks for, whatever its `version`."""
    return ReplacedValues
