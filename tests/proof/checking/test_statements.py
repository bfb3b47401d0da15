"""Letters and givens in which statement, figure and file disagree."""

from __future__ import annotations

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from tests.problem.crank import crank
from tests.proof.checking.changed import checked
from tests.said import all_said


def test_faults_of_the_statement_are_faults_of_the_template() -> None:
    fault = all_said(check(crank(("{{ h.value }} above", "above")), sample=18).faults)[0]
    assert (
        fault
        == "crank.toml: statement.en: the parameter h is not given to the student: write {{ h }}"
    )


def test_a_figure_that_marks_what_is_not_there_is_a_fault() -> None:
    radius = '[figure]\nradii = [{ symbol = "R", centre = "O" }]'
    [fault] = all_said(checked("[figure]", radius).faults)
    assert fault.startswith('figure.radii: no circle about "O"')


def test_a_radius_that_may_be_that_of_several_circles_is_a_fault() -> None:
    """It was drawn at the larger one, though the smaller one was meant, and nothing said so."""
    text = load_template("two-stage-belt-drive").file.text
    unnamed = text.replace(', through = "D"', "")
    assert unnamed != text
    report = check(read_template("two-stage-belt-drive", unnamed), sample=8)
    assert all_said(report.faults) == [
        'figure.radii: "r_2" may be the radius of several circles about "A", which are not alike - '
        'say which one, by through = "POINT", a point on it'
    ]  # both circles are of one body


def test_a_point_that_the_statement_names_and_the_figure_does_not_letter_is_remarked() -> None:
    named = ("$A$ is {{ h.value }} above $O$.", "$A$ is {{ h.value }} above $O$, as $P$ is.")
    remarks = all_said(check(crank(named), sample=18).remarks)
    assert (
        "the statement names P, which has no letter in the figure: put it on a body that it "
        'belongs to, or letter a fixed point in [figure], labels = { P = "P" }'
    ) in remarks
    fixed = ("[bodies]", '[figure]\nlabels = { P = "P" }\n\n[bodies]')
    assert not [
        each for each in all_said(check(crank(named, fixed), sample=18).remarks) if "P," in each
    ]
    lettered = ('OA = "O A"', 'OA = "O A P"')
    assert not [
        each for each in all_said(check(crank(named, lettered), sample=18).remarks) if "P," in each
    ]


def test_a_point_that_the_statement_names_and_the_file_has_not_is_remarked() -> None:
    named = ("$A$ is {{ h.value }} above $O$.", r"$\angle OAW$: $A$ is {{ h.value }} above $V_1$.")
    remarks = all_said(check(crank(named), sample=18).remarks)
    for letter in ("W", "V_1"):
        assert (
            f"the statement names {letter}, which is no point or body of the file: correct the "
            "letter, or declare the point"
        ) in remarks
    assert not [each for each in remarks if "statement names A" in each]


def test_a_point_with_another_letter_in_the_figure_is_remarked() -> None:
    renamed = ("[asks]\n", '[figure]\nlabels = { A = "K_1" }\n[asks]\n')
    said = (
        "the figure calls A K_1, and worked solutions and feedback A: call the point K_1 in the "
        "file"
    )
    assert said in all_said(check(crank(renamed), sample=18).remarks)
    same = ("[asks]\n", '[figure]\nlabels = { A = "A" }\n[asks]\n')
    assert said[:12] not in "".join(all_said(check(crank(same), sample=18).remarks))


def test_a_given_on_which_nothing_depends_is_remarked_and_makes_no_further_instances() -> None:
    idle = (
        "[parameters]\n",
        '[parameters]\nq = { unit = "m", draw = [1, 2, 3], means = "none" }\n',
    )
    report = check(crank(idle, ("turns with", "{{ q }} turns with")), sample=54)
    assert (
        "nothing that is asked, moves or is drawn depends on the given q: leave it out, or use "
        "it; its values make no further instances"
    ) in all_said(report.remarks)
    assert (report.examined, report.distinct) == (54, 2)
    assert not [each for each in all_said(check(crank(), 18).remarks) if "depends on" in each]
