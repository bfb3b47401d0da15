"""The formulas of the shipped templates in all writings and in words, read by a person once and held."""

from __future__ import annotations

from kinegrade.language.known import known_languages
from kinegrade.language.math.latex import TEX, write_latex_math
from kinegrade.language.math.mathml.formula import write_mathml
from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.math.runs import Run, split_symbol
from kinegrade.language.math.spoken.speaking import speak_math
from kinegrade.language.math.typst.formula import write_typst_math
from tests.golden_files import Hold
from tests.language.math.formulas import list_formulas


def write_run(run: Run) -> str:
    styles = ("italic" if run.italic else "") + (" bold" if run.bold else "")
    back = f" back {run.back:.2f}" if run.back else ""
    return f"[{run.text}]{styles}{back} {run.size:g}@{run.shift:.3g}"


def write_all(latex: str) -> str:
    return "\n  ".join(
        (
            latex,
            write_typst_math(latex, "corpus"),
            write_latex_math(latex, "corpus", TEX),
            write_mathml(latex, "corpus"),
            write_plain_math(latex, "corpus"),
            " ".join(map(write_run, split_symbol(latex, "corpus"))),
            *(speak_math(latex, "corpus", language) for language in known_languages()),
        )
    )


def test_every_formula_in_all_writings(hold: Hold) -> None:
    hold("formulas.txt", "\n".join(map(write_all, list_formulas())) + "\n")
