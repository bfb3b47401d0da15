"""Papers per second: drawing, solving and typesetting by the product, against one pdflatex run per student.

The peer typesets a page of the same size that is already solved and drawn, so it has the easier work. Where no
pdflatex is on the machine the figure is left out, and the report says so.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from benchmarks.figure_of_merit import Figure, seconds
from kinegrade.exam.bank import read_bank
from kinegrade.exam.pages import paper_pages
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.setting import set_exam
from kinegrade.exam.typst import TypstPress
from kinegrade.problem.library import shipped

QUESTION = r"""\section*{Question}The crank $OA$, of length $r = \SI{0.25}{m}$, turns about $O$ with angular velocity
$\omega = \SI{7}{rad/s}$. Find $v_B = \frac{2\sqrt{3}}{3}\,\omega r$ at $\varphi = 60^\circ$, and $\omega_{AB}$.\par
\begin{tikzpicture}[scale=2]\draw[thick] (0,0) -- (0.5,0.866) -- (2,0); \draw (0,0) circle (0.04);
\draw (0.5,0.866) circle (0.04); \foreach \x in {-0.3,-0.2,...,0.3} \draw (\x,-0.1) -- (\x-0.1,-0.2);
\draw (0.4,0) arc (0:60:0.4) node[midway,right] {$\varphi$};\end{tikzpicture}\par
\begin{tabular}{lllr}$v_B$ & speed of $B$ & m/s & 3\\$\omega_{AB}$ & angular velocity & rad/s & 2\end{tabular}"""
PAPER = (r"\documentclass{article}\usepackage{amsmath,siunitx,tikz}\begin{document}" + QUESTION * 4
         + r"\end{document}")


def figures() -> Iterator[Figure]:
    """Seconds per paper of four questions with figures."""
    students = tuple(Student(str(number), f"Student {number}", "", str(number)) for number in range(400))
    setting = set_exam(read_bank(shipped("banks") / "demo.toml"), Roster(students, ()), "bench")
    press, papers = TypstPress(), setting.papers()
    ours = seconds(lambda: press.paper(paper_pages(setting.bank, next(papers), "en")), 40)
    if which("pdflatex") is None:
        print(f"papers: {1 / ours:.1f} per second; no pdflatex on this machine to compare with")
        return
    yield Figure("a paper of 4 questions against a pdflatex run", ours, seconds(run_pdflatex, 5), None)


def run_pdflatex() -> None:
    """One pdflatex run, shell escape off, in a folder of its own."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "paper.tex").write_text(PAPER, encoding="utf-8")
        subprocess.run(["pdflatex", "-no-shell-escape", "-interaction=batchmode", "paper.tex"], cwd=folder, check=True,
                       capture_output=True)
