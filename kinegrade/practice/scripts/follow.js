// @ts-check
// Follow-through: answers that follow from the student's own wrong answers to other asks. What
// follows is baked as a + b x + c x^2 in the student's value x, or as the root of that. See
// judging/follow.py.

const LEAST = 1 / 20;
const MOST = 60;
const SMALL = 1 / 2;
const TINY = 1 / 900;
const LARGE = 4;
const SIGN_ALONE = 1 / 100;

/**
 * @typedef {object} Following what follows for one ask from a value of another
 * @property {number} from
 * @property {number | null} beside the ask with whose right answer something else follows
 * @property {number} to
 * @property {[number, number, number] | null} coefficients null where they do not do
 * @property {boolean} isRoot whether it is the root of what they give
 * @property {boolean} ofItsSign whether they hold for values of the right sign alone
 */

/** @param {Draw} draw @returns {Following[]} */
function readFollows(draw) {
  return draw.follows.map((text) => {
    const ofItsSign = text.endsWith(" +");
    const isRoot = text.replace(" +", "").endsWith(" r");
    const [taken, to, ...numbers] = text.replace(" +", "").replace(" r", "").split(" ");
    const [from, beside = null] = taken.split("&").map(Number);
    const coefficients = numbers.length ? /** @type {[number, number, number]} */ (numbers.map(Number)) : null;
    return { from, beside, to: Number(to), coefficients, isRoot, ofItsSign };
  });
}

/** @param {Following} following one that has coefficients @param {number} value @returns {number} */
function workOut({ coefficients, isRoot }, value) {
  const [constant, linear, square] = coefficients ?? [NaN, NaN, NaN];
  const found = constant + linear * value + square * value * value;
  return isRoot ? Math.sqrt(Math.max(found, 0)) : found;
}

/**
 * The verdicts with those that follow-through improves; an error is charged once.
 * @param {Question} question
 * @param {Draw} draw
 * @param {Key[]} keys
 * @param {Verdict[]} verdicts
 * @returns {Verdict[]}
 */
function followThrough(question, draw, keys, verdicts) {
  const improved = [...verdicts];
  if (verdicts.some((verdict, place) => isAbsurd(verdict, keys[place]))) return improved;
  const follows = readFollows(draw);
  /** @type {Map<number, number[]>} on which wrong answers one that follows may rest */
  const basis = new Map();
  for (const to of orderByStage(question)) {
    if (!isOpen(verdicts[to])) continue;
    const usable = follows.filter(
      (each) => each.to === to && isOpen(verdicts[each.from]) && !rests(each.from, to, basis),
    );
    const isUnsigned = UNSIGNED.includes(question.asks[to].convention ?? "");
    const starts = [...new Set(usable.map((each) => each.from))];
    const listWays = (/** @type {number} */ from) => usable.filter((each) => each.from === from);
    if (!starts.some((from) => doesFollow(listWays(from), keys, verdicts, isUnsigned))) continue;
    // It may follow from all of them together, which is not baked
    basis.set(to, starts);
    improved[to] = { ...verdicts[to], kind: "follow-through", mistakes: [] };
  }
  return improved;
}

/** @param {Question} question the places of its asks: by stage, then by points, then the last */
function orderByStage({ asks }) {
  const places = asks.map((_, place) => place);
  return places.sort(
    (one, other) =>
      asks[one].stage - asks[other].stage || asks[other].points - asks[one].points || other - one,
  );
}

/** @param {Verdict} verdict whether it is a number that is not right */
function isOpen({ kind }) {
  return kind === "wrong" || kind === "mistake";
}

/** @param {Verdict} verdict @param {Key} key whether nothing sensible follows from it */
function isAbsurd({ value }, key) {
  const share = Math.abs(value / key.value);
  return Boolean(value && key.value) && (share < LEAST || share > MOST);
}

/** @param {number} place @param {number} other @param {Map<number, number[]>} basis @returns {boolean} */
function rests(place, other, basis) {
  const under = basis.get(place) ?? [];
  return place === other || under.some((each) => rests(each, other, basis));
}

/**
 * @param {Following[]} ways of going on from one answer to another
 * @param {Key[]} keys
 * @param {Verdict[]} verdicts
 * @param {boolean} isUnsigned whether what follows is a magnitude
 */
function doesFollow(ways, keys, verdicts, isUnsigned) {
  const [{ from, to }] = ways;
  const own = verdicts[from].value;
  const later = verdicts[to].value;
  const right = keys[from].value;
  if (!own || !right) return false;
  const known = ways.filter(
    ({ coefficients, ofItsSign }) => coefficients && (!ofItsSign || own * right > 0),
  );
  const fits = (/** @type {number} */ value, factor = 1) =>
    known.some((way) => {
      const found = workOut(way, value);
      return agrees(later, factor * (isUnsigned ? Math.abs(found) : found), keys[to]);
    });
  return fits(own) && !isCopied(later, own, keys[to], right) && !isTrivial(own, right, fits);
}

/** @param {number} later @param {number} own @param {Key} key @param {number} right */
function isCopied(later, own, key, right) {
  const sizes = Math.abs(Math.abs(own) - Math.abs(right));
  const worked = { ...key, value: Math.abs(key.value) };
  const same = Math.abs(later) === Math.abs(own) && sizes > SIGN_ALONE * Math.abs(right);
  return same && !agrees(Math.abs(right), worked.value, worked);
}

/**
 * Whether what follows cannot be distinguished from leaving terms out, because of the value.
 * @param {number} own
 * @param {number} right
 * @param {(value: number, factor?: number) => boolean} fits
 */
function isTrivial(own, right, fits) {
  const size = Math.abs(own / right);
  if (size < SMALL) return fits(right * TINY) && !fits(right);
  const drowns = (/** @type {number} */ power) =>
    fits(own / 2, 2 ** power) && !fits(right, (own / right) ** power);
  return size > LARGE && (drowns(1) || drowns(2));
}
