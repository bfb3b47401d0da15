// @ts-check
// From what is baked into the page to the texts and keys of a draw.

/**
 * @typedef {object} Ask
 * @property {string} name
 * @property {string} label HTML
 * @property {string} unit
 * @property {string} shown the unit as HTML
 * @property {string | null} convention
 * @property {string} sign
 * @property {number} points
 * @property {number} period
 * @property {number} stage the asks of earlier stages do not depend on it
 * @property {string[]} mistakes
 * @property {number[]} credits
 */

/** @typedef {[pattern: number, numbers: string]} Line */

/**
 * @typedef {object} Draw
 * @property {Line[][]} texts
 * @property {[value: string, rule: number, ratios: string][]} keys
 * @property {string[]} follows
 * @property {Motion | null} motion
 */

/**
 * @typedef {object} Question
 * @property {string} title HTML
 * @property {Ask[]} asks
 * @property {Rule[]} rules
 * @property {(string | number)[][]} patterns
 * @property {Draw[]} draws
 * @property {Skeleton | null} skeleton
 * @property {number[]} followed the asks that have curves
 */

/**
 * @typedef {object} Baked
 * @property {{title: string, mistakes: Record<string, string>, questions: Question[]}} sheet
 * @property {Vocabulary} vocabulary
 * @property {Wording} wording
 */

/** @param {string} packed @returns {Promise<Baked>} */
async function unpack(packed) {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(unpacked).text());
}

/** @param {Question} question @param {Line[]} lines @returns {string} the text of a draw */
function fillLines(question, lines) {
  return lines.map(([pattern, numbers]) => fillPattern(question.patterns[pattern], numbers)).join("");
}

/** @param {(string | number)[]} pattern @param {string} numbers @returns {string} */
function fillPattern(pattern, numbers) {
  const filling = numbers.split(" ");
  return pattern.map((piece) => (typeof piece === "number" ? filling[piece] : piece)).join("");
}

/** @param {Question} question @param {Draw} draw @returns {Key[]} the keys of its asks */
function readKeys(question, draw) {
  return draw.keys.map(([shown, rule, ratios], place) => {
    const { mistakes, credits, period } = question.asks[place];
    const value = Number(shown);
    const known = ratios.split(" ").flatMap((ratio, index) => {
      if (ratio === "") return [];
      const leadsTo = Number(ratio) * (value || 1);
      return [{ name: mistakes[index], value: leadsTo, credit: credits[index] }];
    });
    return { value, rule: question.rules[rule], period, mistakes: known };
  });
}
