// @ts-check
// The score: for every question the best of the draws that were tried before their solution was
// seen.

/** Keeps it; `report` is told of every change. */
class Score {
  /** @param {Question[]} questions @param {(earned: number, total: number) => void} report */
  constructor(questions, report) {
    this.total = questions.reduce((sum, each) => sum + countPoints(each.asks), 0);
    this.best = questions.map(() => 0);
    this.report = report;
  }

  /** @returns {number} */
  get earned() {
    return this.best.reduce((sum, each) => sum + each, 0);
  }

  /** @param {number} question @param {number} earned on one draw */
  note(question, earned) {
    this.best[question] = Math.max(this.best[question], earned);
    this.report(this.earned, this.total);
  }
}

/** @param {Ask[]} asks */
function countPoints(asks) {
  return asks.reduce((sum, ask) => sum + ask.points, 0);
}

/** @param {Verdict} verdict @param {Key} key @returns {number} the share of the points it earns */
function findShare({ kind, mistakes }, key) {
  if (kind === "right" || kind === "follow-through") return 1;
  const named = key.mistakes.find(({ name }) => name.split(".")[0] === mistakes[0]);
  return kind === "mistake" ? named?.credit ?? 0 : 0;
}
