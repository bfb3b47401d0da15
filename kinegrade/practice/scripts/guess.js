// @ts-check
// What probably went wrong with a number, judging by the number alone. See judging/hints.py.

const LARGEST_POWER = 6;
const WIDEST = 0.02;
const CLOSE = 0.05;

/** @typedef {{kind: string, reversed: boolean, power: number}} Guess */

/** @param {number} value @param {Key} key @param {string} unit @returns {Guess | null} */
function guessSlip(value, key, unit) {
  const right = key.value;
  if (!right || !value) return null;
  const ratio = value / right;
  const allowed = Math.max(key.rule.relative * Math.abs(right), key.rule.absolute);
  const room = Math.min(allowed / Math.abs(right), WIDEST);
  for (const [guess, factor] of listFactors(unit)) {
    if (Math.abs(ratio - factor) <= room * Math.abs(factor)) return guess;
  }
  return Math.abs(ratio - 1) <= CLOSE ? { kind: "close", reversed: false, power: 0 } : null;
}

/** @param {string} unit @returns {[Guess, number][]} the likeliest first */
function listFactors(unit) {
  const powers = Array.from({ length: LARGEST_POWER }, (_, index) => [-index - 1, index + 1]).flat();
  /** @type {[Guess, number][]} */
  const found = [[{ kind: "opposite", reversed: false, power: 0 }, -1]];
  for (const sign of [1, -1]) {
    const reversed = sign < 0;
    for (const power of powers) {
      const kind = power > 0 ? "too-large" : "too-small";
      found.push([{ kind, reversed, power }, sign * 10 ** power]);
    }
    for (const [kind, factor] of [...DOUBLED, ...listAngularFactors(unit)]) {
      found.push([{ kind, reversed, power: 0 }, sign * factor]);
    }
  }
  return found;
}

/** @type {[string, number][]} */
const DOUBLED = [
  ["twice", 2],
  ["half", 0.5],
];

/** @param {string} unit @returns {[string, number][]} */
function listAngularFactors(unit) {
  /** @type {[string, number][]} */
  const forgotten = [
    ["degrees-for-radians", 180 / Math.PI],
    ["radians-for-degrees", Math.PI / 180],
  ];
  if (unit === "rad/s") {
    forgotten.push(["turns-per-minute", 30 / Math.PI], ["turns-per-second", 1 / (2 * Math.PI)]);
  }
  return unit.startsWith("rad") || unit.startsWith("deg") ? forgotten : [];
}
