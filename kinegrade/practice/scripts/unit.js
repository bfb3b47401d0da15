// @ts-check
// Units as people write them, and what a number in one is in another. See typed/unit_spelling.py
// and typed/conversion.py.

/**
 * @typedef {object} Vocabulary
 * @property {Record<string, string[]>} words
 * @property {[string, boolean][]} per words for "per", and whether blanks stand around them
 * @property {Record<string, string[]>} senses
 * @property {Record<string, string>} names the standard name of a unit by each of its spellings
 * @property {Record<string, string>} short what some units stand for: rpm
 * @property {Record<string, [number, number, string]>} units size, power of pi, what it measures
 */

/**
 * @typedef {object} WrittenUnit factor * pi**pi in SI units; the rest are exponents
 * @property {number} factor
 * @property {number} pi
 * @property {number} length
 * @property {number} time
 * @property {number} angle
 */

/** @typedef {Map<string, number>} Powers the exponent of each unit by name */

/** A well-written unit that measures something other than what is asked. */
class WrongUnit extends Unreadable {}

const RUN_TOGETHER = /(?<![\p{L}\p{N}_])((?:k|c|m)?m|rad)s(?=\^?\(?-?[0-9])/gu;
const FACTOR =
  /(\p{L}+|°|%)(?:(?:\s*(?:\^|\*\*)\s*)?(?:([+-]?[0-9])|\(([+-]?[0-9])\)|\{([+-]?[0-9])\}))?/uy;
const LINK = /\s*(\*|\/|\.|)\s*/y;
const SHARE = /1\s*(?=\/)|(?=\/)/y;
const TIMES = new RegExp(`^\\*\\s*(?=${LETTER}|°)`, "u");
/** @type {Record<string, string>} by the exponents of length, time and angle */
const KINDS = {
  "0,0,0": "kind-number",
  "1,0,0": "kind-length",
  "0,1,0": "kind-time",
  "1,-1,0": "kind-speed",
  "1,-2,0": "kind-acceleration",
  "0,0,1": "kind-angle",
  "0,-1,1": "kind-angular-velocity",
  "0,-2,1": "kind-angular-acceleration",
  "0,-1,0": "kind-rate",
  "0,-2,0": "kind-rate-of-rate",
};

/** Reads units with the words of a vocabulary. */
class UnitReader {
  /** @param {Vocabulary} vocabulary */
  constructor(vocabulary) {
    this.vocabulary = vocabulary;
    this.names = new Map(Object.entries(vocabulary.names));
    const choose = (/** @type {string} */ name) =>
      `(?:${vocabulary.words[name].map(escapePattern).join("|")})`;
    const between = vocabulary.per.map(([word, apart]) => (apart ? `\\s+${word}\\s+` : word));
    /** @type {[RegExp, string][]} */
    this.rewritings = [
      [new RegExp(`\\s*${choose("squared")}`, "g"), "^2"],
      [new RegExp(between.join("|"), "g"), "/"],
      [new RegExp(`${choose("square")}\\s*(\\p{L}+)`, "gu"), "$1^2"],
    ];
    this.cycles = new RegExp(`^(?:([kM])?Hz|${choose("cycles")})$`, "iu");
  }

  /**
   * What a number typed with the unit `typed` is to be multiplied by to be one in `unit`.
   * @param {string} typed
   * @param {string} unit
   * @returns {number}
   */
  convert(typed, unit) {
    let written = dropBrackets(typed);
    const pure = unit === "" || unit === "1";
    if (written === "" || written === unit || (pure && written === "1")) return 1;
    const wanted = pure ? makePureUnit() : this.read(unit);
    if (wanted && countsTurns(wanted)) written = this.addTurns(written);
    else this.refuseTurns(written, unit, wanted);
    const found = this.read(written);
    if (!found || !wanted) {
      const parts = { typed: quote(typed.trim()), unit: quote(unit) };
      throw new Unreadable(pure ? "no-unit-wanted" : "unknown-unit", parts);
    }
    const leftOut = found.angle === 0 && wanted.angle === 1 && wanted.time < 0 && wanted.pi === 0;
    const same = found.length === wanted.length && found.time === wanted.time;
    if (!same || !(found.angle === wanted.angle || leftOut)) {
      const kinds = { found: nameKind(found), wanted: nameKind(wanted) };
      const parts = { typed: quote(written), unit: quote(unit), ...kinds };
      throw new WrongUnit(pure ? "not-pure" : "other-kind", parts);
    }
    return (found.factor / wanted.factor) * Math.PI ** (found.pi - wanted.pi);
  }

  /** @param {string} written @returns {string} a count per time with what is counted: turns */
  addTurns(written) {
    if (this.isPerMinute(written)) return "r/min";
    const found = this.cycles.exec(written);
    return found && !found[1] ? "r/s" : written;
  }

  /** @param {string} written */
  isPerMinute(written) {
    const powers = this.readPowers(this.foldUnit(written));
    const left = [...(powers ?? [])].filter(([, power]) => power !== 0);
    return left.length === 1 && powers?.get("min") === -1;
  }

  /** @param {string} written @param {string} unit @param {WrittenUnit | null} wanted */
  refuseTurns(written, unit, wanted) {
    const typed = quote(written);
    if (this.cycles.test(written)) {
      const parts = { typed, unit: quote(unit), wanted: wanted ? nameKind(wanted) : "" };
      const pure = unit === "" || unit === "1";
      if (!wanted) throw new WrongUnit("turns-for-unit", parts);
      throw new WrongUnit(pure ? "turns-for-number" : "turns-for-kind", parts);
    }
    if (wanted?.angle && this.isPerMinute(written)) throw new Unreadable("per-minute", { typed });
  }

  /** @param {string} text @returns {WrittenUnit | null} null where it is not written as a unit */
  read(text) {
    const powers = this.readPowers(this.foldUnit(text));
    const perTime = powers?.get("min") === -1 || powers?.get("s") === -1;
    if (!powers || (powers.has("r") && !perTime)) return null;
    for (const [name, meaning] of Object.entries(this.vocabulary.short)) {
      const power = powers.get(name);
      if (power === undefined) continue;
      powers.delete(name);
      for (const [part, exponent] of this.readPowers(meaning) ?? []) {
        addPower(powers, part, power * exponent);
      }
    }
    return this.findWorth(powers);
  }

  /** @param {string} text */
  foldUnit(text) {
    let plain = fold(fold(text.replace(/[º˚]/g, "°")).normalize("NFKC")).trim();
    for (const [pattern, sign] of this.rewritings) plain = plain.replace(pattern, sign);
    return plain.replace(RUN_TOGETHER, "$1 s");
  }

  /** @param {string} text @returns {Powers | null} a slash inverts one factor or bracket */
  readPowers(text) {
    /** @type {Powers} */
    const powers = new Map();
    let place = matchAt(SHARE, text, 0)?.[0].length ?? 0;
    let first = true;
    while (place < text.length || first) {
      const link = place || text[0] === "/" ? matchAt(LINK, text, place) : null;
      const start = place + (link ? link[0].length : 0);
      const found = text[start] === "(" ? this.readBracket(text, start) : this.readFactor(text, start);
      if (!found) return null;
      for (const [name, power] of found.powers) {
        addPower(powers, name, link?.[1] === "/" ? -power : power);
      }
      place = found.end;
      first = false;
    }
    return powers;
  }

  /** @param {string} text @param {number} place @returns {{powers: Powers, end: number} | null} */
  readFactor(text, place) {
    const found = matchAt(FACTOR, text, place);
    const name = found && (this.names.get(found[1]) ?? this.names.get(found[1].toLowerCase()));
    const power = Number(found?.slice(2).find((digits) => digits) ?? "1");
    if (!found || !name || !power) return null;
    return { powers: new Map([[name, power]]), end: place + found[0].length };
  }

  /** @param {string} text @param {number} place @returns {{powers: Powers, end: number} | null} */
  readBracket(text, place) {
    const end = text.indexOf(")", place);
    const inside = text.slice(place + 1, end);
    const powers = end > 0 && !inside.includes("(") ? this.readPowers(inside) : null;
    return powers && { powers, end: end + 1 };
  }

  /** @param {Powers} powers @returns {WrittenUnit} */
  findWorth(powers) {
    /** @type {Record<string, number>} */
    const exponents = { length: 0, time: 0, angle: 0, number: 0 };
    let factor = 1;
    let pi = 0;
    for (const [name, power] of powers) {
      const [size, turns, dimension] = this.vocabulary.units[name];
      factor *= size ** power;
      pi += turns * power;
      exponents[dimension] += power;
    }
    const { length, time, angle } = exponents;
    return { factor, pi, length, time, angle };
  }
}

/** @param {WrittenUnit} unit whether it is a number of turns in a second or a minute */
function countsTurns({ factor, pi, length, time, angle }) {
  const rate = pi === 1 && length === 0 && time === -1 && angle === 1;
  return rate && [1, 60].some((seconds) => Math.abs(factor * seconds - 2) < 1e-12);
}

/** @returns {WrittenUnit} */
function makePureUnit() {
  return { factor: 1, pi: 0, length: 0, time: 0, angle: 0 };
}

/** @param {Powers} powers @param {string} name @param {number} power */
function addPower(powers, name, power) {
  powers.set(name, (powers.get(name) ?? 0) + power);
}

/** @param {WrittenUnit} unit @returns {Said | string} what it measures */
function nameKind({ length, time, angle }) {
  const key = KINDS[[length, time, angle].join()];
  return key ? { key } : `m^${length} s^${time} rad^${angle}`;
}

/** @param {string} typed */
function dropBrackets(typed) {
  const written = typed.trim().replace(TIMES, "");
  const around = written.slice(0, 1) + written.slice(-1);
  return ["()", "[]", "（）", "【】", "{}"].includes(around) ? written.slice(1, -1).trim() : written;
}
