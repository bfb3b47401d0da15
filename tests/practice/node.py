"""Runs the script of practice sheets in node, to compare what it says with what Python says."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec
import pytest

from kinegrade.practice.document import PracticeSheet
from kinegrade.practice.poses import PracticeMotion
from kinegrade.practice.script import JUDGE, MOTION, READER, read_scripts
from kinegrade.practice.vocabulary import list_vocabulary
from tests.tools import complaint, missing_tools

_READ = """
const { vocabulary, cases } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const reader = new AnswerReader(vocabulary);
const read = cases.map(({ typed, ask }) => {
  const { kind, value, reason } = reader.read(typed, ask);
  return { kind, value, reason: reason ? reason.key : "" };
});
process.stdout.write(JSON.stringify(read));
"""
_JUDGE = """
const { vocabulary, sheet, typed } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const reader = new AnswerReader(vocabulary);
const judged = sheet.questions.map((question, place) =>
  question.draws.map((draw, number) => {
    const keys = readKeys(question, draw);
    const verdicts = question.asks.map((ask, row) =>
      judge(reader.read(typed[place][number][row], ask), keys[row]));
    const judged = followThrough(question, draw, keys, verdicts);
    const cutOff = isCutOff(question, draw, keys, judged);
    return judged.map(({ kind, mistakes }) => ({ kind, mistakes, is_cut_off: cutOff }));
  }));
process.stdout.write(JSON.stringify(judged));
"""
_MOVE = """
const { motions, shares, poles } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const shown = motions.map((motion) => {
  const poses = new Poses(motion);
  return shares.map((share) => {
    const place = share * poses.last;
    const rates = poses.rates(place);
    const found = poles.map((points) => findPole(poses, points, place));
    return { input: poses.inputAt(place), points: poses.at(place), ...rates, poles: found };
  });
});
process.stdout.write(JSON.stringify({ shown, instants: motions.map((each) => new Poses(each).instant) }));
"""
_TRACE = """
const { motion } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const poses = new Poses(motion);
const traced = motion.curves.map((curve) => {
  const values = sumUp(curve[2]).map((value) => value / CURVE_STEPS);
  const graph = Object.assign(Object.create(Graph.prototype), { poses, values, gaps: poses.repeat(curve[3]) });
  return graph.parts(curve[3]).map((part) => part.map((place) => [poses.inputAt(place), graph.valueAt(place)]));
});
process.stdout.write(JSON.stringify(traced));
"""
Typed = Sequence[Sequence[Sequence[str]]]  # of a question, of a draw, for an ask


@dataclass(frozen=True)
class Shown:
    """What a page says of an answer: its verdict, the mistakes it names; `is_cut_off` where it says
    that it cannot tell what follows.
    """

    kind: str
    mistakes: tuple[str, ...]
    is_cut_off: bool


def read_in_node(cases: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """What the script reads in typed texts: each case has a text and what is asked."""
    return list(_run(_READ, {"cases": list(cases)}))


def judge_in_node(sheet: PracticeSheet, typed: Typed) -> list[list[list[Shown]]]:
    """The script's verdicts on what was typed, in the same order."""
    return msgspec.convert(_run(_JUDGE, {"sheet": sheet, "typed": typed}), list[list[list[Shown]]])


def move_in_node(
    motions: Sequence[PracticeMotion],
    shares: Sequence[float],
    poles: Sequence[tuple[int, int]] = (),
) -> dict[str, Any]:
    """For each motion what the script shows at shares of its cycle, with the poles of the bodies
    that have these points, and the place of its instant.
    """
    return dict(_run(_MOVE, {"motions": motions, "shares": shares, "poles": poles}))


def trace_in_node(motion: PracticeMotion) -> list[list[list[list[float]]]]:
    """For each curve of a motion its parts: places of the input, as it is shown, each with the part
    of the way from the least to the greatest value.
    """
    return list(_run(_TRACE, {"motion": motion}))


def _run(driver: str, given: Mapping[str, Any]) -> Any:
    if "node" in missing_tools():
        pytest.fail(complaint(missing_tools()), pytrace=False)
    script = read_scripts((*READER, *JUDGE, *MOTION)) + driver
    told = msgspec.json.encode({"vocabulary": list_vocabulary(), **given}).decode()
    run = subprocess.run(
        ["node", "-e", script], input=told, capture_output=True, text=True, check=True
    )
    return json.loads(run.stdout)
