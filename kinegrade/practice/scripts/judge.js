// @ts-check
// Right or wrong, and which known mistake leads there. See judging/judge.py and
// judging/decision.py.

/** @typedef {{relative: number, absolute: number, figures: number | null}} Rule */

/**
 * @typedef {object} Mistake
 * @property {string} name
 * @property {number} value what it leads to
 * @property {number} credit the share of the points that the bank gives for it
 */

/**
 * @typedef {object} Key what is right for one ask of one draw
 * @property {number} value
 * @property {Rule} rule
 * @property {number} period a full turn of an angle, 0 where turns count
 * @property {Mistake[]} mistakes
 */

/**
 * @typedef {object} Verdict
 * @property {"right" | "follow-through" | "mistake" | "wrong" | "wrong unit" | "blank" | "unreadable"} kind
 * @property {string[]} mistakes the likeliest first
 * @property {Said | null} reason of what could not be read
 * @property {number} value
 */

// Keys have 12 digits: what cannot be distinguished from a bound counts as on it
const SLACK = 1e-11;
// Between an answer and the key, at most: more are degrees typed for radians
const MOST_TURNS = 3;

/** @param {Reading} reading @param {Key} key @returns {Verdict} */
function judge(reading, key) {
  const { kind, value, reason } = reading;
  if (kind !== "number") return { kind, mistakes: [], reason, value };
  if (agrees(value, key.value, key)) return { kind: "right", mistakes: [], reason, value };
  const mistakes = listMistakes(value, key);
  return { kind: mistakes.length ? "mistake" : "wrong", mistakes, reason, value };
}

/** @param {number} value @param {number} other @param {Key} key whether they agree by its rule */
function agrees(value, other, key) {
  let difference = value - other;
  const turns = key.period && Math.round(difference / key.period);
  if (Math.abs(turns) <= MOST_TURNS) difference -= turns * key.period;
  const [low, high] = findInterval(other, key.rule);
  const slack = SLACK * Math.max(Math.abs(low), Math.abs(high));
  return low - slack <= other + difference && other + difference <= high + slack;
}

/** @param {number} exact @param {Rule} rule @returns {[number, number]} */
function findInterval(exact, rule) {
  const room = Math.max(rule.relative * Math.abs(exact), rule.absolute);
  const low = exact - room;
  const high = exact + room;
  if (!rule.figures || !exact) return [low, high];
  const unit = 10 ** (findLeadingPower(exact) - rule.figures + 1);
  const below = (Math.ceil(exact / unit - 0.5 - SLACK) - 0.5) * unit;
  const above = (Math.floor(exact / unit + 0.5 + SLACK) + 0.5) * unit;
  return [Math.min(low, below), Math.max(high, above)];
}

/** @param {number} exact the power of ten of its first significant figure */
function findLeadingPower(exact) {
  return Number(Math.abs(exact).toExponential().split("e")[1]);
}

/**
 * The mistakes that lead to a value: the best credit first, then the nearest, then by name.
 * @param {number} value
 * @param {Key} key
 * @returns {string[]}
 */
function listMistakes(value, key) {
  const leading = key.mistakes.filter((mistake) => agrees(value, mistake.value, key));
  const distance = (/** @type {Mistake} */ mistake) => Math.abs(mistake.value - value);
  leading.sort(
    (one, other) =>
      other.credit - one.credit ||
      distance(one) - distance(other) ||
      (one.name < other.name ? -1 : 1),
  );
  const identifiers = leading.map(({ name }) => name.split(".")[0]);
  const [first, ...others] = identifiers;
  if (first === undefined) return [];
  return [first, ...[...new Set(others)].filter((each) => each !== first).sort()];
}
