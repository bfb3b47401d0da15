"""By what a template is found and chosen: its title, family, source, tags, and the method of its
worked solution.
"""

from __future__ import annotations

import re

from kinegrade.errors import FieldError
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, found
from kinegrade.language.message import Message
from kinegrade.problem.template.sections.values import words
from kinegrade.problem.template.template import METHODS, About
from kinegrade.problem.template.translations import translated

_TAG = re.compile(r"[a-z][a-z0-9-]{0,29}", re.ASCII)


def read_about(table: Table) -> About | None:
    """What the file says of the template as a whole; None after a fault."""
    title = table.required("title", translated)
    family = table.required("family", words)
    source = table.required("source", words)
    tags = table.listing("tags", _read_tag)
    method = table.optional("method", choice(METHODS))
    if title is None or family is None or source is None:
        return None
    return About(title, family, source, tags, method)


def _read_tag(value: object) -> str:
    """One of the author's words."""
    if isinstance(value, str) and _TAG.fullmatch(value):
        return value
    raise FieldError(found(value), Message("template.a-tag"))
