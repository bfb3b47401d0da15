"""From the TOML text of a template to a Template; every fault of the file is reported at once.

TOML is pure data, and expressions have a small grammar. So a template from a stranger is safe to
open. `sections` reads the tables of the file, one module for each.
"""

from __future__ import annotations

from collections.abc import Set

from msgspec.structs import replace

from kinegrade.errors import TemplateError
from kinegrade.files.fields.table import Table
from kinegrade.language.known import read_language
from kinegrade.language.message import Message
from kinegrade.problem.template.beside import Translations
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.sections.about import read_about
from kinegrade.problem.template.sections.asks import read_asks
from kinegrade.problem.template.sections.figure import Names, read_figure
from kinegrade.problem.template.sections.keys import NAMES
from kinegrade.problem.template.sections.names import Declared, check_names, declared_names
from kinegrade.problem.template.sections.opening import (
    Mechanisms,
    Opened,
    no_mechanisms,
    open_template,
)
from kinegrade.problem.template.sections.parameters import read_parameters
from kinegrade.problem.template.sections.published import read_published
from kinegrade.problem.template.sections.repeated import note_repeated
from kinegrade.problem.template.sections.scheme import (
    read_bodies,
    read_body_names,
    read_conditions,
    read_drivers,
    read_expressions,
    read_joints,
)
from kinegrade.problem.template.sections.stated_language import state_language
from kinegrade.problem.template.sections.statement_texts import read_texts
from kinegrade.problem.template.sections.uses import check_uses
from kinegrade.problem.template.sections.values import words
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.translations import translated

_NO_TRANSLATIONS: Translations = {}


def read_template(
    name: str,
    text: str,
    mechanisms: Mechanisms = no_mechanisms,
    translations: Translations = _NO_TRANSLATIONS,
    *,
    kept: bool = False,
    steps: bool = False,
) -> Template:
    """The template of that name. Raises TemplateError with all faults, each with its place.

    `name` is the file's name without `.toml`: letters, digits and hyphens. `mechanisms` gives the
    mechanism that the template shares with others, `translations` the texts of the files that
    translate it. A template that is `kept` with an exam is read without a look at dimensions, so
    that no later rule closes an exam's folder; only such a one, or one that corrects it, may have
    `steps` in place of a mechanism.
    """
    opened = open_template(name, text, mechanisms, translations)
    table = opened.table
    if "steps" in table:
        # Loads the reading of expressions, and most templates have a mechanism
        from kinegrade.problem.template.library.stepwise import read_stepwise  # noqa: PLC0415

        if not kept and not steps:
            do = Message("template.steps-into-bank")
            table.fault("steps", Message("template.steps-in-file"), do=do)
        template = read_stepwise(name, table, opened.file, kept=kept)
    else:
        template = _read_whole(name, opened, kept=kept)
    problems = [problem for faults in opened.faults for problem in faults.raised().faults]
    if template is None or problems:
        raise TemplateError(*problems)
    return template


def _read_whole(name: str, opened: Opened, *, kept: bool) -> Template | None:
    """The template of a file with a mechanism; None where it lacks what every one has."""
    draft = _read_draft(opened.table, opened.strays)
    if _has_names(opened.table):
        check_uses(draft, opened.table.faults)
        if not kept:
            # Loads the meanings of expressions, which an exam does not look at again
            from kinegrade.problem.template.meaning.consistency import (  # noqa: PLC0415
                note_inconsistencies,
            )

            note_inconsistencies(draft, opened.table.faults)
            note_repeated(draft, opened.table.faults)
    return draft.template(name, opened.file)


def _read_draft(table: Table, strays: Set[str]) -> Draft:
    """What can be read of a template's tables; names of `strays` are not missed."""
    declared = declared_names(table)
    check_names(table, declared)
    draft = Draft(
        about=read_about(table),
        statement=table.required("statement", translated),
        texts=read_texts(table),
        parameters=read_parameters(table),
        lengths=read_expressions(table, "lengths"),
        reasons=table.table("reasons").entries(translated),
        points=read_expressions(table, "points"),
        bodies=read_bodies(table),
        joints=read_joints(table),
        drivers=read_drivers(table),
        conditions=read_conditions(table),
        asks=read_asks(table),
        published=read_published(table),
        figure=_read_figure(table, declared),
        called=read_body_names(table),
    )
    draft = replace(draft, faulty=_find_unread(declared, draft) | strays)
    language = table.optional("language", lambda value: read_language(words(value)))
    return draft if language is None else state_language(draft, language)


def _has_names(table: Table) -> bool:
    """Whether the tables are there without which nothing that names their entries makes sense."""
    return all(table.holds_table(key) for key in NAMES)


def _read_figure(table: Table, declared: Declared) -> FigureHints:
    if not _has_names(table):
        return FigureHints()
    return read_figure(table, Names(set(declared["points"]), set(declared["bodies"])))


def _find_unread(declared: Declared, draft: Draft) -> frozenset[str]:
    """The names that are declared by something that could not be read."""
    read = (draft.parameters, draft.lengths, draft.points, draft.bodies, draft.asks, draft.texts)
    return frozenset().union(*declared.values()).difference(*read)
