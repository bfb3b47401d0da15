r"""A paper as people write one in LaTeX: article, amsmath, siunitx, TikZ's `\draw`, an answer table
for each question.

It holds the statements, numbers, figures and answer boxes of our paper. It has less to print than
ours: no code to be scanned, no count of pages, no key.
"""

from __future__ import annotations

import re
from math import degrees

from kinegrade.figure.scene import Bow, Disc, Label, Outline, Pen, Primitive, Scene, Strokes
from kinegrade.language.math.latex_text import write_plain
from kinegrade.mechanics.vector import Vector
from kinegrade.press.sheet import AnswerRow, Paper, QuestionSheet

PREAMBLE = r"""\documentclass[10pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage[margin=20mm,headheight=14pt]{geometry}
\usepackage{amsmath}
\usepackage{siunitx}
\usepackage{tikz}
\usepackage{fancyhdr}
\usepackage{tabularx}
\usepackage{enumitem}
\sisetup{per-mode=symbol}
\pagestyle{fancy}
"""
FILLS = {"none": "", "white": "fill=white", "grey": "fill=black!9", "black": "fill=black"}
QUANTITY = re.compile(r"(-?[\d.]+)\\,\\unit\{([^}]*)\}")
DEGREES = re.compile(r"(-?[\d.]+)\^\\circ")


def ordinary_paper(paper: Paper) -> str:
    """The LaTeX source of one student's paper, to be typeset by one pdflatex run."""
    head = (
        rf"\fancyhf{{}}\lhead{{{write_plain(paper.course)}, "
        rf"{write_plain(paper.title)}}}\rhead{{Paper "
        rf"{write_plain(paper.code)}}}"
        rf"\lfoot{{{write_plain(paper.student)} {write_plain(paper.name)}}}\rfoot{{page \thepage}}"
    )
    title = rf"\section*{{{write_plain(paper.title)}}}" + "\n" + candidate(paper)
    rules = listed("itemize", [prose(rule) for rule in paper.rules])
    questions = listed("enumerate", [question(sheet) for sheet in paper.questions])
    return "\n".join(
        [PREAMBLE + head, r"\begin{document}", title, rules, questions, r"\end{document}", ""]
    )


def candidate(paper: Paper) -> str:
    """Who writes the paper, and the table for the marks."""
    numbers = "&".join(str(sheet.number) for sheet in paper.questions)
    points = "&".join(f"{float(sheet.points):g}" for sheet in paper.questions)
    columns = "|c" * len(paper.questions)
    return (
        rf"\noindent Name: \textbf{{{write_plain(paper.name)}}}\quad Student: "
        rf"\textbf{{{write_plain(paper.student)}}}\hfill"
        rf"\begin{{tabular}}{{|l{columns}|c|}}\hline Question&{numbers}&Total\\\hline "
        rf"Points&{points}&{float(paper.points):g}\\\hline "
        rf"Mark{'&' * len(paper.questions)}&\\\hline"
        r"\end{tabular}"
    )


def listed(kind: str, items: list[str]) -> str:
    """A list of enumitem's."""
    body = "\n".join(rf"\item {item}" for item in items)
    return rf"\begin{{{kind}}}[leftmargin=*]" + "\n" + body + "\n" + rf"\end{{{kind}}}"


def question(sheet: QuestionSheet) -> str:
    """A question: its title and points, its statement, its figure, its answer table."""
    figure = rf"\begin{{center}}{drawing(sheet.figure)}\end{{center}}" if sheet.figure else ""
    rows = "\n".join(map(row, sheet.rows))
    table = (
        r"\begin{tabularx}{\linewidth}{|X|r|p{40mm}|l|}\hline" + f"\n{rows}\n" + r"\end{tabularx}"
    )
    return "\n".join(
        [
            rf"\textbf{{{prose(sheet.title)}}}\hfill({float(sheet.points):g} points)\par",
            prose(sheet.statement),
            figure,
            rf"\noindent {table}",
        ]
    )


def row(answer: AnswerRow) -> str:
    """The box of one answer."""
    unit = "" if answer.unit == "1" else rf"\unit{{{written(answer.unit)}}}"
    return (
        rf"{prose(answer.meaning)} ({prose(answer.sign)})&${answer.symbol}=$&\hfill{unit}"
        rf"&{float(answer.points):g}\\[2ex]\hline"
    )


def prose(text: str) -> str:
    """Text with math in it, its quantities and angles by siunitx."""
    pieces = text.split("$")
    return "".join(
        f"${math(piece)}$" if index % 2 else write_plain(piece)
        for index, piece in enumerate(pieces)
    )


def math(latex: str) -> str:
    """A formula with its quantities and angles by siunitx."""
    with_units = QUANTITY.sub(lambda found: rf"\qty{{{found[1]}}}{{{written(found[2])}}}", latex)
    return DEGREES.sub(r"\\ang{\1}", with_units)


def written(unit: str) -> str:
    """A unit as siunitx reads it."""
    return r"\degree" if unit == "deg" else unit


def drawing(scene: Scene) -> str:
    """A figure by TikZ, one path for each part of it."""
    box = rf"\path[use as bounding box] (0,0) rectangle {at(Vector(scene.width, scene.height))};"
    parts = "\n".join(map(drawn, scene.primitives))
    options = "x=1mm,y=1mm,line cap=round,line join=round,font=\\small"
    return f"\\begin{{tikzpicture}}[{options}]\n{box}\n{parts}\n\\end{{tikzpicture}}"


def drawn(part: Primitive) -> str:
    """One part of a figure."""
    match part:
        case Label():
            return rf"\node[inner sep=0] at {at(part.centre)} {{${part.symbol}$}};"
        case Disc():
            return (
                rf"\path[{style(part.pen, part.fill)}] {at(part.centre)} "
                rf"circle[radius={number(part.radius)}];"
            )
        case Outline():
            end = " -- cycle" if part.closed else ""
            return (
                rf"\path[{style(part.pen, part.fill)}] {' -- '.join(map(at, part.corners))}{end};"
            )
        case Bow():
            return bow(part)
        case Strokes():
            lines = " ".join(f"{at(start)} -- {at(end)}" for start, end in part.lines)
            return rf"\draw[{style(part.pen)}] {lines};"


def bow(part: Bow) -> str:
    """A circular arc, from where it begins."""
    start, sweep = degrees(part.start), degrees(part.sweep)
    arc = (
        f"arc[start angle={number(start)},delta angle={number(sweep)},radius={number(part.radius)}]"
    )
    return rf"\draw[{style(part.pen)}] {at(part.path()[0])} {arc};"


def style(pen: Pen | None, fill: str = "none") -> str:
    """The options of a path."""
    dash = {"solid": [], "dashed": ["dashed"], "dash-dotted": ["dash dot"]}
    line = ["draw", f"line width={number(pen.width)}mm", *dash[pen.dash]] if pen else []
    return ",".join([*line, *filter(None, [FILLS[fill]])])


def at(point: Vector) -> str:
    """A point in millimetres."""
    return f"({number(point.x)},{number(point.y)})"


def number(value: float) -> str:
    """A number of at most three decimals."""
    return f"{round(value, 3) + 0.0:g}"
