"""The templates that entries of a bank name, or draw by family or tag: shipped ones, files beside
the bank, or the copies that an exam keeps.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from msgspec import Struct

from kinegrade.errors import FieldError, KinegradeError, suggest
from kinegrade.exam.bank.shipped_templates import Grouping, Shelf, read_shelf
from kinegrade.files.fields.document import read_text, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.values import found, text
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.library.library import load_kept_template, load_template
from kinegrade.problem.template.sections.opening import TEMPLATE
from kinegrade.problem.template.template import Template

_TEMPLATE_FILE = re.compile(r"[\w. -]{1,100}\.toml")


class NamedTemplates(Struct, frozen=True, dict=True):
    """Finds templates; `folder` holds the shipped ones, others are in the folder `beside`.

    For a bank that is `kept` with an exam, `folder` holds exactly the templates that were chosen,
    including those that were beside the bank; rules introduced after the exam do not refuse them.
    """

    faults: Faults
    folder: Path
    beside: Path
    kept: bool

    @property
    def has_shipped(self) -> bool:
        """Whether there are templates to draw from."""
        return bool(self._shelf.templates)

    def check_statements(self, templates: Iterable[Template]) -> None:
        """Notes what the statements of templates lack that may be drawn; others are not held up."""
        # An exam's own copies have been checked
        from kinegrade.problem.statement_faults import check_statements  # noqa: PLC0415

        for template in templates:
            try:
                check_statements(template)
            except KinegradeError as error:
                self.faults.note_error((), error)

    def having(self, by: Grouping, word: object) -> tuple[Template, ...]:
        """The shipped templates of a family or with a tag."""
        having = self._shelf.having(by, str(word))
        if not having:
            what = Message(f"bank.unknown-{by}", name=found(word))
            raise FieldError(what, do=suggest(str(word), self._shelf.known(by)))
        return having

    @cached_property
    def _shelf(self) -> Shelf:
        """All shipped templates, read when an entry first draws from them; none after a fault."""
        try:
            return read_shelf(self.folder, kept=self.kept)
        except KinegradeError as error:
            self.faults.note_error((), error)
        return Shelf({}, {"family": {}, "tag": {}})

    def named(self, value: object) -> Template:
        """A shipped template, or a file beside the bank; the exam's copy where the bank is kept."""
        name = text(value)
        beside = name.endswith(".toml")
        if beside and not _TEMPLATE_FILE.fullmatch(name):
            raise FieldError(found(name), Message("bank.file-beside"))
        if self.kept:
            return load_kept_template(name.removesuffix(".toml"), self.folder)
        template = load_template(str(self.beside / name) if beside else name, self.folder)
        if not beside:
            _require_alone(template, self.beside / f"{name}.toml")
        from kinegrade.problem.statement_faults import check_statements  # noqa: PLC0415

        check_statements(template)
        return template


def _require_alone(shipped: Template, own: Path) -> None:
    """Raises FieldError where a file beside the bank has the name of a shipped template, and
    another text: it may be the one that is meant, unless it is a bank itself.
    """
    text = read_text(own, TEMPLATE) if own.exists() else shipped.file.text
    if text != shipped.file.text and "questions" not in toml_table(own.name, text, TEMPLATE):
        what = Message("bank.own-and-shipped", file=Quoted(own.name))
        raise FieldError(what, do=Message("bank.name-own", file=Quoted(own.name)))
