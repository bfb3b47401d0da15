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

// Of what mistakes lead to, as marks have it: bounds are about the rounded value
const KEPT_DIGITS = 9;

// Those of the digits that are not letters; see packing.py
const SIGNS = "!#$%&()*+-;,=>?@^_`{|}~";

/** @param {string} packed @returns {Promise<Baked>} */
async function unpack(packed) {
  const unpacked = new Blob([readBytes(packed)]).stream().pipeThrough(new DecompressionStream("deflate"));
  const baked = JSON.parse(await new Response(unpacked).text());
  for (const question of baked.sheet.questions) question.draws = listDraws(question);
  return baked;
}

/** @param {string} packed five digits for each four bytes @returns {Uint8Array<ArrayBuffer>} */
function readBytes(packed) {
  const digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz" + SIGNS;
  const values = new Map([...digits].map((digit, value) => [digit, value]));
  const missing = (5 - (packed.length % 5)) % 5;
  const whole = packed + "~".repeat(missing);
  const bytes = new DataView(new ArrayBuffer((whole.length / 5) * 4));
  for (let place = 0; place < whole.length; place += 5) {
    const five = [...whole.slice(place, place + 5)];
    bytes.setUint32((place / 5) * 4, five.reduce((sum, digit) => 85 * sum + (values.get(digit) ?? 0), 0));
  }
  return new Uint8Array(bytes.buffer, 0, bytes.byteLength - missing);
}

/**
 * The draws of a question, of which each field stands together.
 * @param {{draws: Columns, motions: Columns, numbers: Record<string, string[]>}} packed
 * @returns {Draw[]}
 */
function listDraws({ draws, motions, numbers }) {
  const left = Object.fromEntries(Object.entries(numbers).map(([pattern, all]) => [pattern, all.values()]));
  const count = draws.texts.length;
  const moving = takeRows(motions, count).map((motion) => (motion.coordinates ? motion : null));
  return takeRows({ ...draws, motion: moving }, count).map((draw) => ({
    ...draw,
    texts: draw.texts.map((/** @type {number[]} */ text) =>
      text.map((pattern) => [pattern, left[pattern].next().value]),
    ),
  }));
}

/** @typedef {Record<string, any[]>} Columns */

/** @param {Columns} columns @param {number} count @returns {any[]} */
function takeRows(columns, count) {
  return Array.from({ length: count }, (_, row) =>
    Object.fromEntries(Object.entries(columns).map(([name, values]) => [name, values[row]])),
  );
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
      const leadsTo = Number((Number(ratio) * (value || 1)).toPrecision(KEPT_DIGITS));
      return [{ name: mistakes[index], value: leadsTo, credit: credits[index] }];
    });
    return { value, rule: question.rules[rule], period, mistakes: known };
  });
}
