// @ts-check
// A sense in words or as an arrow, and what it means for the sign of an answer. See typed/sense.py.

/** @type {Record<string, string>} */
const OPPOSITE = {
  ccw: "cw",
  cw: "ccw",
  right: "left",
  left: "right",
  up: "down",
  down: "up",
};
/** @type {Record<string, string>} */
const ARROWS = { ccw: "↺⟲", cw: "↻⟳", right: "→", left: "←", up: "↑", down: "↓" };
/** @type {Record<string, string>} the sense that counts as positive by the convention of an ask */
const POSITIVE = {
  ccw: "ccw",
  cw: "cw",
  "+x": "right",
  "-x": "left",
  "+y": "up",
  "-y": "down",
};
const UNSIGNED = ["magnitude", "unsigned"];

/** Takes words for senses off answers. */
class SenseReader {
  /** @param {Record<string, string[]>} senses their spellings */
  constructor(senses) {
    const named = Object.entries(senses).map(
      ([sense, words]) => `(?<${sense}>${words.map(matchWord).join("|")}|[${ARROWS[sense]}])`,
    );
    const words = named.join("|");
    const compile = (/** @type {string} */ pattern) => new RegExp(pattern, "iu");
    this.anywhere = compile(words);
    this.alone = compile(`(?<![A-Za-z_])(?:${words})(?![A-Za-z])`);
    this.sides = [
      compile(`(?<![\\s,;(\\[])[\\s,;(\\[]*(?<![A-Za-z])(?:${words})\\.?[\\s)\\]]*$`),
      compile(`^[\\s(\\[]*(?:${words})(?![A-Za-z])[\\s)\\],:.=]*`),
    ];
  }

  /** @param {string} label a text before an equals sign or a colon */
  isNamed(label) {
    return this.alone.test(label);
  }

  /** @param {string} text @returns {[string, string]} the answer without its sense, and that sense */
  split(text) {
    for (const side of this.anywhere.test(text) ? this.sides : []) {
      const found = side.exec(text);
      if (!found?.groups) continue;
      const { groups } = found;
      const sense = Object.keys(groups).find((name) => groups[name] !== undefined) ?? "";
      return [text.slice(0, found.index) + text.slice(found.index + found[0].length), sense];
    }
    return [text, ""];
  }
}

/** @param {string} word a hyphen may be a blank or left out, and so may the points of c.c.w */
function matchWord(word) {
  return escapePattern(word).replaceAll("-", "[\\- ]?").replaceAll("\\.", "\\.?");
}

/**
 * The factor that words give to a number typed with `sign`.
 * @param {string} sense
 * @param {string} sign
 * @param {AskedFor} ask
 * @returns {1 | -1}
 */
function findDirection(sense, sign, ask) {
  const positive = POSITIVE[ask.convention ?? ""];
  const said = { key: `direction-${sense}` };
  if (sign === "-" || (sign === "+" && sense !== positive)) {
    throw new Unreadable("sign-and-sense", { sign: quote(sign), sense: said });
  }
  if (UNSIGNED.includes(ask.convention ?? "")) return 1;
  if (!positive || (sense !== positive && sense !== OPPOSITE[positive])) {
    const key = ask.sign ? "senses-of-other-sign" : "senses-of-no-sign";
    throw new Unreadable(key, { sense: said, convention: ask.sign });
  }
  return sense === positive ? 1 : -1;
}
