// @ts-check
// What keyboards produce, in one alphabet: digits, signs, brackets, blanks. See typed/keyboard.py.

const INVISIBLE = "\u00ad\u061c\ufeff\u200b\u200c\u200d\u200e\u200f\u2060" +
  "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069";
const CONTROLS = "\t\n\v\f\r\x1c-\x1f"; // they group no digits
const SPACES = " \x85\xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000" + INVISIBLE;
const BLANKS = CONTROLS + SPACES;
const SURROUNDING = new RegExp(`^[${BLANKS}]+|[${BLANKS}]+$`, "g");
const CONTROL = new RegExp(`[${CONTROLS}]`, "g");
const SPACE = new RegExp(`[${SPACES}]`, "g");
const INVISIBLES = new RegExp(`[${INVISIBLE}]`, "g");
// A letter, or a numeral that is no digit (Ⅳ): [^\W\d] of Python
const LETTER = "[\\p{L}\\p{Nl}\\p{No}_]";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const DOTS = "·⋅•∙・";
const RAISED = new RegExp(`[⁺⁻]?[${SUPERSCRIPTS}]+(?=([0-9])?)`, "g");

/** @type {[RegExp, string][]} */
const FOLDED = [
  [new RegExp(`[${DOTS}]`, "g"), "*"],
  [/[。｡．]/g, "."],
  [/[\u2212\u2010-\u2015\u2043\u02d7\ufe58\ufe63]/g, "-"],
  [/[×✕✖]/g, "*"],
  [/[÷\u2044\u2215]/g, "/"],
  [/[\u2019\u2018\u02bc]/g, "'"],
  [/【/g, "["],
  [/】/g, "]"],
  [/〔/g, "("],
  [/〕/g, ")"],
];

/** @param {string} text @returns {string} without blanks around it */
function trim(text) {
  return text.replace(SURROUNDING, "");
}

/** @param {string} text @returns {string} the text in ASCII digits, signs and brackets */
function fold(text) {
  const marked = text.replace(/[\u00a0\u2007\u2009\u202f]/g, "\u2009");
  return marked.split("\u2009").map(foldSigns).join("\u2009").replace(RAISED, writeRaised);
}

/** @param {string} text */
function foldSigns(text) {
  let folded = text;
  for (const [signs, sign] of FOLDED) folded = folded.replace(signs, sign);
  const narrow = folded.replace(/[\uff01-\uff5e]/g, (wide) =>
    String.fromCharCode(wide.charCodeAt(0) - 0xfee0),
  );
  return narrow.replace(INVISIBLES, "").replace(CONTROL, "\t").replace(SPACE, " ");
}

/** @param {string} raised @param {string | undefined} digit what follows */
function writeRaised(raised, digit) {
  const plain = [...raised].map((sign) => {
    const value = SUPERSCRIPTS.indexOf(sign);
    if (value >= 0) return String(value);
    return sign === "⁺" ? "+" : "-";
  });
  return `^${plain.join("")}${digit === undefined ? "" : " "}`;
}

/** @param {string} text @returns {string} the text in a regular expression */
function escapePattern(text) {
  return text.replace(/[\\^$.*+?()[\]{}|/]/g, "\\$&");
}

/**
 * What a pattern finds exactly at a place of a text.
 * @param {RegExp} pattern a sticky one
 * @param {string} text
 * @param {number} place
 * @returns {RegExpExecArray | null}
 */
function matchAt(pattern, text, place) {
  pattern.lastIndex = place;
  return pattern.exec(text);
}
