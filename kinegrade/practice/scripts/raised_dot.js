// @ts-check
// A raised dot between digits, 20·8: times for some, a decimal point for others. See
// typed/raised_dot.py.

const DECIMAL_MARKS = ".,．，";
const ONLY_TIMES = `[\\p{Nd}${DOTS}${SUPERSCRIPTS}⁻⁺]|[${DECIMAL_MARKS}]\\p{Nd}|\\s?(?:[\\^＾]|\\*\\*|＊＊)`;
const DOUBTFUL = new RegExp(
  `(?<![\\p{Nd}${DECIMAL_MARKS}'${DOTS}])(\\p{Nd}+)[${DOTS}](\\p{Nd}+)(?!${ONLY_TIMES})`,
  "u",
);

/** @param {string} text @returns {Unreadable | null} why it cannot be read; null where it can */
function findRaisedDot(text) {
  const found = DOUBTFUL.exec(text);
  if (!found) return null;
  const [typed, whole, decimals] = found;
  const point = `${whole}.${decimals}`;
  return new Unreadable("raised-dot", { typed: quote(typed), point, times: `${whole}*${decimals}` });
}
