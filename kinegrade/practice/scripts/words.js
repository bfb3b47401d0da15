// @ts-check
// Says messages in the language of the page, as catalogues do.

/** @typedef {{key: string, parts?: Record<string, unknown>}} Said */

/**
 * @typedef {object} Wording
 * @property {Record<string, string>} texts
 * @property {string[]} nouns the keys of texts that have forms
 * @property {string[]} forms their names
 * @property {string} mark before decimals
 */

const PLACE = /<([A-Za-z-]+)(?::([a-z-]+))?>/g;

/** Writes messages. */
class Words {
  /** @param {Wording} wording */
  constructor(wording) {
    this.wording = wording;
  }

  /** @param {string} key @param {Record<string, unknown>} [parts] @param {string} [form] */
  say(key, parts = {}, form = "") {
    const { texts, nouns, forms } = this.wording;
    const text = nouns.includes(key)
      ? texts[key].split("|")[form ? forms.indexOf(form) : 0]
      : texts[key];
    return text.replace(PLACE, (_, name, wanted) => {
      const written = this.write(parts[name.toLowerCase()], wanted ?? "");
      return name === name.toLowerCase() ? written : written[0].toUpperCase() + written.slice(1);
    });
  }

  /** @param {unknown} part @param {string} form @returns {string} */
  write(part, form) {
    if (typeof part === "number") return this.writeNumber(part);
    if (typeof part === "object" && part !== null) {
      const said = /** @type {Said} */ (part);
      return this.say(said.key, said.parts, form);
    }
    return String(part);
  }

  /** @param {number} value @param {number} [digits] @returns {string} with the language's mark */
  writeNumber(value, digits = 6) {
    const [mantissa, power] = value.toPrecision(digits).split("e");
    const plain = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    const signed = plain.replace("-", "−").replace(".", this.wording.mark);
    return power ? `${signed}·10^${Number(power)}` : signed;
  }
}
