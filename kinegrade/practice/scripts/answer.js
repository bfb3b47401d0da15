// @ts-check
// What was typed into one box: a number or formula, its unit, its sense in words. See
// typed/answers.py.

/**
 * @typedef {object} AskedFor what reading an answer takes
 * @property {string} unit
 * @property {string | null} convention the keyword of the sign convention
 * @property {string} sign the convention in words
 */

/**
 * @typedef {object} Reading
 * @property {"number" | "blank" | "unreadable" | "wrong unit"} kind
 * @property {number} value in the unit of the ask; NaN where nothing was read
 * @property {Said | null} reason why it is unreadable, or its unit wrong
 */

const LONGEST_ANSWER = 200;
const TEXT_MARK = /^'(?=[-+.,\p{Nd}])/u;
const LABEL =
  /^(?:\|?(?!sqrt|pi(?![\p{L}\p{N}_])|π\s*=|\p{Nd})[\p{L}\p{N}_][\p{L}\p{N}_'′^{}()|\\, ]{0,30}(?:[=≈]|:(?!=))\s*|=\s*)/iu;
const ABOUT = "[≈~≃≅∼]";
const TAIL = /[\s.;,!、]+$/;
const NEXT_NUMBER = /^[\s.,;'、~=≈]*(?:[+-]\s*)?\(?\s*[0-9]/;
const OTHER_NUMBER =
  /(?:^|\s)(?:[\p{L}\p{Nl}\p{No}]+\.?\s+|[\u4e00-\u9fff]+\s*|[|&]\s*)[+-]?[0-9]/u;
const SHARE_OF_TIME = new RegExp(`^(?:\\s*1\\s*/\\s*${LETTER}|\\s*\\(\\s*1\\s*/)`, "u");

/** Reads answers with the words of a vocabulary. */
class AnswerReader {
  /** @param {Vocabulary} vocabulary */
  constructor(vocabulary) {
    this.units = new UnitReader(vocabulary);
    this.senses = new SenseReader(vocabulary.senses);
    this.beginnings = compileBeginnings(vocabulary.words.root);
    const words = vocabulary.words.about.map(escapePattern).join("|");
    this.about = new RegExp(`^(?:${ABOUT}|${words})\\s*`, "iu");
  }

  /** @param {string} typed @param {AskedFor} ask @returns {Reading} never throws Unreadable */
  read(typed, ask) {
    const trimmed = trim(typed);
    if (trimmed.length > LONGEST_ANSWER) {
      return refuse("unreadable", new Unreadable("too-long", { most: LONGEST_ANSWER }));
    }
    if (TEXT_MARK.test(trimmed)) return this.read(trimmed.slice(1), ask);
    const raised = findRaisedDot(trimmed);
    if (raised) return refuse("unreadable", raised);
    const text = fold(trimmed);
    if (!text.replace(/[- ]/g, "")) return { kind: "blank", value: NaN, reason: null };
    try {
      return { kind: "number", value: this.readFolded(text, trimmed, ask), reason: null };
    } catch (fault) {
      if (!(fault instanceof Unreadable)) throw fault;
      return refuse(fault instanceof WrongUnit ? "wrong unit" : "unreadable", fault);
    }
  }

  /** @param {string} text @param {string} typed @param {AskedFor} ask @returns {number} */
  readFolded(text, typed, ask) {
    const [unsensed, sense] = this.senses.split(this.undress(text).replace(TAIL, ""));
    const answer = this.undress(unsensed).replace(TAIL, "");
    const signed = /^([+-]?)\s*/.exec(answer);
    const sign = signed?.[1] ?? "";
    const minus = sign === "-";
    const found = scanValue(answer, signed?.[0].length ?? 0, this.beginnings, typed, minus);
    if (!found) throw new Unreadable("not-a-number", { typed: quote(typed) });
    const rest = answer.slice(found.end);
    if (NEXT_NUMBER.test(rest) && !SHARE_OF_TIME.test(rest)) {
      throw new Unreadable("more-than-one", { typed: quote(typed) });
    }
    const factor = this.convert(typed, rest, ask.unit);
    if (found.pi && ask.unit === "deg" && !rest.trim()) throw new Unreadable("pi-for-degrees");
    const turn = sense ? findDirection(sense, sign, ask) : 1;
    const size = (found.work ? found.work() : found.value) * factor;
    // The minus before a formula is in what it is worth
    return requireFinite(minus && !found.work ? -size * turn : size * turn);
  }

  /**
   * What the text behind a number makes of it; of two numbers with a word between, the whole is said.
   * @param {string} typed
   * @param {string} rest
   * @param {string} unit
   * @returns {number}
   */
  convert(typed, rest, unit) {
    try {
      return this.units.convert(rest, unit);
    } catch (fault) {
      const unknown = fault instanceof Unreadable && !(fault instanceof WrongUnit);
      if (!unknown || !OTHER_NUMBER.test(rest)) throw fault;
      throw new Unreadable("more-than-one", { typed: quote(typed) });
    }
  }

  /** @param {string} text @returns {string} without a label before the number (v_B =) or "about" */
  undress(text) {
    const label = LABEL.exec(text);
    const kept = label && !this.senses.isNamed(label[0]) ? text.slice(label[0].length) : text;
    return kept.replace(this.about, "").trim();
  }
}

/** @param {"unreadable" | "wrong unit"} kind @param {Unreadable} fault @returns {Reading} */
function refuse(kind, fault) {
  return { kind, value: NaN, reason: { key: fault.key, parts: fault.parts } };
}

/** @param {number} value */
function requireFinite(value) {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || size > LARGEST || (size > 0 && size < SMALLEST)) {
    throw new Unreadable("beyond", { largest: "1e99", smallest: "1e-99" });
  }
  return value;
}
