// @ts-check
// What the page cannot tell: answers that may follow in a way that is not baked.

// An answer that is off by a share moves what follows by at most about so many times that share
const LEVER = 10;

/**
 * Whether there are wrong answers from which another may follow in a way that is not baked: that
 * has no such coefficients, or rests on several of them, or on right ones that are rounded.
 * @param {Question} question
 * @param {Draw} draw
 * @param {Key[]} keys
 * @param {Verdict[]} judged
 */
function isCutOff(question, draw, keys, judged) {
  const follows = readFollows(draw);
  const listWrong = (/** @type {number} */ to) =>
    follows.filter(
      (each) =>
        each.to === to &&
        judged[each.from].kind !== "right" &&
        Number.isFinite(judged[each.from].value) &&
        (each.beside === null || judged[each.beside].kind === "right"),
    );
  return question.asks.some((_, to) => {
    if (!isOpen(judged[to])) return false;
    const wrong = listWrong(to);
    const behind = wrong.filter((each) => !isOpen(judged[each.from])).flatMap((each) => listWrong(each.from));
    const places = new Set([...wrong, ...behind].map((each) => each.from).filter((from) => from !== to));
    return (
      places.size > 1 ||
      wrong.some((each) => !isKnown(each, keys, judged)) ||
      wrong.some((each) => isWithinRounding(each, question, keys, judged))
    );
  });
}

/** @param {Following} following @param {Key[]} keys @param {Verdict[]} judged whether what follows is baked */
function isKnown({ from, coefficients, ofItsSign }, keys, judged) {
  const hasItsSign = keys[from].value * judged[from].value >= 0;
  return coefficients !== null && (hasItsSign || !ofItsSign);
}

/**
 * Whether an answer is so near to what follows with all other values right to the last digit, that
 * it may follow from the student's own ones, which are right as far as the tolerance goes.
 * @param {Following} following
 * @param {Question} question
 * @param {Key[]} keys
 * @param {Verdict[]} judged
 */
function isWithinRounding(following, question, keys, judged) {
  const { from, to, coefficients, isRoot } = following;
  const error = Math.max(...judged.map((each, place) => findError(each, keys[place])));
  if (coefficients === null || error === 0) return false;
  const own = judged[from].value;
  const later = judged[to].value;
  const found = workOut(following, own);
  const follows = UNSIGNED.includes(question.asks[to].convention ?? "") ? Math.abs(found) : found;
  const [constant, linear, square] = coefficients;
  const largest = Math.max(...[constant, linear * own, square * own * own].map(Math.abs));
  const reach = LEVER * error * (isRoot ? Math.sqrt(largest) : largest);
  const nearest = Math.min(Math.max(later, follows - reach), follows + reach);
  return agrees(later, nearest, keys[to]);
}

/** @param {Verdict} verdict @param {Key} key the share by which an answer that counts as right is off */
function findError({ kind, value }, key) {
  return kind === "right" && key.value ? Math.abs(value / key.value - 1) : 0;
}
