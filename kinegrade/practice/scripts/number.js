// @ts-check
// Decimal numbers as they are typed: grouped in threes, with a point or a comma, with powers of
// ten. See typed/number_text.py.

const MOST_DIGITS = 40;
const LARGEST_EXPONENT = 99;
const LARGEST = 1e99;
const SMALLEST = 1e-99;
const BODY =
  "(?:(?<body>[0-9]+(?:[.,'\\u2009][0-9]+| [0-9]{3}(?![0-9]))*)(?<last>[.,](?![0-9√π(½-¾]))?" +
  "|(?<decimals>[.,][0-9]+))";
const TEN = "\\s?(?:\\*|[xX](?=\\s?10\\s?(?:\\^|\\*\\*)))\\s?10\\s?(?:\\^|\\*\\*)\\s?";
const NO_MORE = "(?![0-9]|[.,][0-9])";
const BY_LETTER = "[eE](?<power>[+-]?[0-9]+)";
const POWER =
  `(?:${BY_LETTER}|${TEN}\\((?<inside>[+-]?[0-9]+)${NO_MORE}\\)` +
  `|${TEN}(?<ten>[+-]?[0-9]+)${NO_MORE})?`;
const DIGITS = new RegExp(BODY, "y");
const WITH_LETTER = new RegExp(`${BODY}(?:${BY_LETTER})?`, "y");
const RUN = new RegExp(BODY + POWER, "y");
const SEPARATOR = /[.,'\u2009 ]/g;

/** That what was typed is not one number in a unit; `key` and `parts` say why. */
class Unreadable extends Error {
  /** @param {string} key @param {Record<string, unknown>} [parts] */
  constructor(key, parts = {}) {
    super(key);
    this.key = key;
    this.parts = parts;
  }
}

/**
 * @typedef {object} TypedNumber
 * @property {number} value
 * @property {string} digits in plain form, with a point
 * @property {number} end where it ends
 */

/**
 * The number at a place of a folded text, null where none begins there.
 * @param {string} text
 * @param {number} place
 * @param {RegExp} [run] DIGITS for one without a power of ten, WITH_LETTER for one with 2e3 alone
 * @returns {TypedNumber | null}
 */
function scanNumber(text, place, run = RUN) {
  const found = matchAt(run, text, place);
  if (!found?.groups) return null;
  const { body, decimals, power, inside, ten } = found.groups;
  const shown = power ?? inside ?? ten;
  const written = body ?? decimals;
  const pieces = written.split(SEPARATOR);
  const separators = written.match(SEPARATOR) ?? [];
  const mark = findDecimalMark(separators);
  if (!isWellFormed(pieces, separators, mark)) {
    throw new Unreadable("many-numbers", { typed: quote(found[0]) });
  }
  const whole = pieces.slice(0, mark ? -1 : undefined).join("");
  const fraction = mark ? pieces[pieces.length - 1] : "";
  requireBounded(whole + fraction, shown ?? "0");
  const plain = `${whole || "0"}${fraction ? "." : ""}${fraction}`;
  const exponent = Number(shown ?? "0");
  const digits = exponent ? `${plain}e${exponent}` : plain;
  return { value: Number(digits), digits, end: place + found[0].length };
}

/**
 * The mark before the decimals; a single one before three digits is one, as on papers.
 * @param {string[]} separators
 * @returns {string | null}
 */
function findDecimalMark(separators) {
  const last = separators[separators.length - 1];
  const earlier = separators.slice(0, -1);
  if (last === undefined || (earlier.length && earlier.every((each) => each === last))) return null;
  return earlier.length || ".,".includes(last) ? last : null;
}

/**
 * Whether the separators are used as in some country.
 * @param {string[]} pieces
 * @param {string[]} separators
 * @param {string | null} mark
 */
function isWellFormed(pieces, separators, mark) {
  const kinds = new Set(separators);
  if (mark === null) return !kinds.size || (kinds.size === 1 && isGrouped(pieces));
  const once = separators.filter((each) => each === mark).length === 1;
  const grouped = separators.length < 2 || isGrouped(pieces.slice(0, -1));
  return once && ".,".includes(mark) && kinds.size <= 2 && grouped;
}

/** @param {string[]} pieces one to three digits, then always three */
function isGrouped(pieces) {
  return /^[1-9][0-9]{0,2}$/.test(pieces[0]) && pieces.slice(1).every((each) => each.length === 3);
}

/** @param {string} digits @param {string} power */
function requireBounded(digits, power) {
  if (digits.replace(/^0+/, "").length > MOST_DIGITS) {
    throw new Unreadable("many-digits", { most: MOST_DIGITS });
  }
  if (power.length > 6 || Math.abs(Number(power)) > LARGEST_EXPONENT) {
    throw new Unreadable("large-power", { largest: LARGEST_EXPONENT });
  }
}

/** @param {string} text as it stands, in quotation marks */
function quote(text) {
  return `"${text}"`;
}
