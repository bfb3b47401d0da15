"""`kinegrade.template`: a problem, solved at any values."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from os import PathLike, fspath

from kinegrade.description.description import describe
from kinegrade.description.said import Description
from kinegrade.errors import KinegradeError
from kinegrade.exam.printing.pages import QuestionPlace, ShownInstance, lay_out_question
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import ENGLISH, Language
from kinegrade.language.html_text import write_plain_html
from kinegrade.press.html.notebook import write_question
from kinegrade.press.sheet import QuestionSheet
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import list_statement_languages
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.public.cycles import Animation, animate
from kinegrade.students.mistaking.consequences import attach_mistakes


@dataclass(frozen=True, repr=False)
class Problem:
    """A template with its solver; a notebook shows its statement and its figure."""

    template: Template

    def __repr__(self) -> str:
        return f"<{self.template.name}>"

    def solve(self, /, **values: str | int | float) -> Solution:
        """The solution at the given values, each a number or an exact text in the parameter's unit.

        What is not given takes its published value, or the first drawable one. A float counts as
        the decimal that it prints as. Answers have `.value`, `.exact`, `.unit`, `.decimal(digits)`,
        and `.mistakes` with what known mistakes lead to. Raises TemplateError for unknown names and
        unreadable values, MechanismError with the reason in mechanics.

        >>> template("slider-crank").solve(phi=90, k="sqrt(3)")["omega_AB"].value
        0.0
        >>> template("slider-crank").solve(psi=90)
        Traceback (most recent call last):
        kinegrade.errors.TemplateError: slider-crank: no parameter "psi": did you mean "phi"? ...
        """
        given = {name: str(value) for name, value in values.items()}
        return attach_mistakes(solve_template(self.template, given))

    def animate(self, /, **values: str | int | float) -> Animation:
        """The figure moving through its whole cycle from the given values, which a notebook plays;
        its `.html` needs no other file.

        Values as for `solve`. Raises TemplateError, and MechanismError where nothing can move.

        >>> template("slider-crank").animate(phi=30).html.count("<svg")
        1
        >>> template("pose-four-bar-coupler").animate()
        Traceback (most recent call last):
        kinegrade.errors.MechanismError: pose-four-bar-coupler: no driver moves the mechanism: ...
        """
        return animate(self.solve(**values), self._language)

    def describe(
        self, language: str | None = None, /, **values: str | int | float
    ) -> Description | None:
        """The figure at the given values in words, in a language of the template (by default its
        own), for those who cannot see it; None where there is no figure.

        `.short` is what stands for the image, `.long` paragraphs from which the problem can be set
        up without it. Values as for `solve`. Raises TemplateError.

        >>> template("slider-crank").describe(phi=30).short
        'Slider-crank mechanism, drawn to scale: points O, A, B; OA turns clockwise'
        >>> template("slider-crank").describe("fr")
        Traceback (most recent call last):
        kinegrade.errors.TemplateError: no text in "fr" - expected one of en, zh or de
        """
        spoken = self._language if language is None else Language(language)
        self.template.about.title.in_language(spoken)
        return describe(self.solve(**values), spoken)

    def _repr_html_(self) -> str:
        language = self._language
        try:
            sheet = self._lay_out()
            asks = self.template.asks.items()
            return write_question(
                sheet, {name: ask.means.in_language(language) for name, ask in asks}, language
            )
        except KinegradeError as error:  # a notebook would print a traceback
            return f"<pre>{write_plain_html(str(error))}</pre>"

    def _repr_svg_(self) -> str | None:
        with suppress(KinegradeError):  # the HTML says why
            figure = self._lay_out().figure
            return None if figure is None else to_svg(figure)
        return None

    @property
    def _language(self) -> Language:
        """English where the template has it, else its first language."""
        known = list_statement_languages(self.template)
        return ENGLISH if ENGLISH in known or not known else known[0]

    def _lay_out(self) -> QuestionSheet:
        """The question at its default values. Raises KinegradeError."""
        solution = self.solve()
        mechanism = solution.assembly.mechanism.map(float)
        shown = ShownInstance(
            self.template, solution.parameters, mechanism, tuple(self.template.asks)
        )
        place = QuestionPlace(1, self.template.name)
        sheet = lay_out_question(place, shown, (), self._language)
        return replace(sheet, described=describe(solution, self._language))


def template(name: str | PathLike[str]) -> Problem:
    """The problem of that name (see `kinegrade list`), or of a template file, whose path ends in
    .toml. Raises TemplateError.

    >>> list(template("slider-crank").solve())[:2]
    ['v_B', 'omega_AB']
    >>> template("slider-krank")
    Traceback (most recent call last):
    kinegrade.errors.TemplateError: no template "slider-krank": did you mean "slider-crank"?
    """
    return Problem(load_template(fspath(name)))
