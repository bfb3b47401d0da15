// @ts-check
// Values typed as small formulas: √3/2, 2 sqrt(3)/3, 5π/3, 2½. Read by a grammar, worked out only
// when the whole answer has been read. See typed/value.py.

const MOST_ROOTS = 8;
const MOST_BRACKETS = 8;
const MOST_ATOMS = 24;
const MOST_POWER = 16;
const VULGAR = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞";
const MIXED = new RegExp(`\\s?[${VULGAR}]`, "y");
const PI = /[πΠ𝜋]|pi(?![a-z])/iuy;
const RAISED_TO = /\s*(?:\^|\*\*)\s*(?:\(\s*([+-]?[0-9]{1,3})\s*\)|([+-]?[0-9]{1,3})(?![0-9.,/]))/y;
const HALF =
  /\s*(?:\^|\*\*)\s*(?:\(\s*1\/2\s*\)|\(\s*0?[.,]5\s*\)|0?[.,]5(?![0-9.,]))/y;
const OPERATOR = /\s*([-+*/])(?!\*)/y;
const DOT_BEFORE_TEN = /^\s*([0-9]+)[.,]10(\s*(?:\^|\*\*).*)/;
const IN_BRACKETS = /\(\s*[0-9]+\s*\)/y;
const BRACKET_OR_PI = /^\s*(?:[πΠ𝜋]|\(\s*[0-9√])/u;

/**
 * What a formula is worth; it throws Unreadable where it has no value. A single number, in brackets
 * or not, is its `literal`.
 * @typedef {(() => number) & {literal?: number}} Work
 */

/**
 * @typedef {object} Formula
 * @property {Work} work
 * @property {number} end
 * @property {boolean} pi whether pi occurs
 */

/**
 * @typedef {object} Beginnings patterns of what begins a value, a factor without a sign, a root
 * @property {RegExp} value
 * @property {RegExp} factor
 * @property {RegExp} root
 */

/** @param {string[]} words for a root @returns {Beginnings} */
function compileBeginnings(words) {
  const root = `√|sqrt|${words.map(escapePattern).join("|")}`;
  const factor = `[(πΠ𝜋]|${root}|pi(?![a-z])`;
  const value = `[0-9${VULGAR}]|[.,][0-9]|${factor}`;
  const compile = (/** @type {string} */ pattern) => new RegExp(pattern, "iuy");
  return {
    value: compile(`\\s*(?:${value})`),
    factor: compile(`\\s*(?:${factor})`),
    root: compile(`(?:${root})\\s*`),
  };
}

/**
 * The number or formula at a place of a folded text, null where neither begins there.
 * @param {string} text
 * @param {number} place
 * @param {Beginnings} beginnings
 * @param {string} typed the whole answer, as faults quote it
 * @param {boolean} minus before that place: the sign of a formula's first product, not of the whole
 * @returns {(TypedNumber & {work?: undefined, pi?: undefined}) | Formula | null}
 */
function scanValue(text, place, beginnings, typed, minus) {
  const plain = scanNumber(text, place);
  if (plain && !isContinued(text, plain.end, beginnings)) return plain;
  if (!plain && !matchAt(beginnings.value, text, place)) return null;
  const reader = new FormulaReader(text, place, beginnings, typed);
  const work = reader.sum(0, minus);
  return { work, end: reader.place, pi: reader.pi };
}

/** @param {string} text @param {number} place @param {Beginnings} beginnings */
function isContinued(text, place, beginnings) {
  const operator = matchAt(OPERATOR, text, place);
  if (operator && matchAt(beginnings.value, text, place + operator[0].length)) return true;
  return [RAISED_TO, HALF, MIXED, beginnings.factor].some((sign) => matchAt(sign, text, place));
}

/** Recursive descent over one folded text; `place` is where the next token begins. */
class FormulaReader {
  /**
   * @param {string} text
   * @param {number} place
   * @param {Beginnings} beginnings
   * @param {string} typed
   */
  constructor(text, place, beginnings, typed) {
    this.text = text;
    this.typed = typed;
    this.place = place;
    this.beginnings = beginnings;
    this.roots = 0;
    this.surds = false;
    this.pi = false;
    this.atoms = 0;
  }

  /**
   * The sum that begins here, of which a minus before it negates the first product.
   * @param {number} depth
   * @param {boolean} minus
   * @returns {Work}
   */
  sum(depth, minus) {
    const before = this.surds;
    this.surds = false;
    const first = this.product(depth);
    let work = minus ? () => -first() : first;
    let terms = 1;
    for (let mark = this.operator("+-"); mark; mark = this.operator("+-")) {
      work = combine(mark, work, this.product(depth));
      terms += 1;
    }
    if (terms > 1 && !this.surds) throw this.fault("range");
    this.surds = this.surds || before;
    return work;
  }

  /** @param {number} depth @returns {Work} */
  product(depth) {
    let work = this.power(depth);
    let divided = false;
    for (;;) {
      const mark = this.operator("*/");
      if (!mark) {
        const factor = this.beside(depth);
        if (!factor) return work;
        if (divided) throw this.fault("two-ways");
        work = combine("*", work, factor);
        continue;
      }
      if (divided && mark === "/") throw this.fault("two-ways");
      divided = divided || mark === "/";
      work = combine(mark, work, this.power(depth, mark === "/" ? WITH_LETTER : RUN));
    }
  }

  /**
   * A factor written without a sign; a bracket that holds a unit is not one.
   * @param {number} depth
   * @returns {Work | null}
   */
  beside(depth) {
    if (!matchAt(this.beginnings.factor, this.text, this.place)) return null;
    const { place, roots, surds } = this;
    try {
      return this.power(depth);
    } catch (fault) {
      if (!(fault instanceof Unreadable) || !this.text.slice(place, place + 2).includes("(")) {
        throw fault;
      }
      Object.assign(this, { place, roots, surds });
      return null;
    }
  }

  /** @param {string} marks @returns {string | null} */
  operator(marks) {
    const found = matchAt(OPERATOR, this.text, this.place);
    if (!found || !marks.includes(found[1])) return null;
    const end = this.place + found[0].length;
    if (!matchAt(this.beginnings.value, this.text, end)) return null;
    this.place = end;
    return found[1];
  }

  /**
   * A power; √3/2·10^3 is a thousand times √3/2.
   * @param {number} depth
   * @param {RegExp} [run] of a number
   * @returns {Work}
   */
  power(depth, run = RUN) {
    const start = this.place;
    const base = this.atom(depth, run);
    const most = base.literal === 10 ? LARGEST_EXPONENT : MOST_POWER;
    if (this.take(HALF)) return this.rootOf(base);
    const found = this.take(RAISED_TO);
    if (!found) return base;
    this.requireNoDotForTimes(this.text.slice(start, this.place));
    const exponent = Number(found[1] ?? found[2]);
    if (Math.abs(exponent) > most) throw new Unreadable("large-whole-power", { most });
    return base.literal === 10
      ? makeLiteral(raise(10, exponent))
      : () => raise(base(), exponent);
  }

  /** @param {string} power 8.10^-3 is 8·10^-3 to who writes the dot for times */
  requireNoDotForTimes(power) {
    const found = DOT_BEFORE_TEN.exec(power);
    if (!found) return;
    const [all, whole, raised] = found;
    const times = `${whole}*10${raised}`;
    const parts = { typed: quote(all.trim()), point: `(${whole}.10)${raised}`, times };
    throw new Unreadable("raised-dot", parts);
  }

  /** @param {number} depth @param {RegExp} run of a number @returns {Work} */
  atom(depth, run) {
    this.atoms += 1;
    if (this.atoms > MOST_ATOMS) throw new Unreadable("many-parts", { most: MOST_ATOMS });
    this.skip();
    if (this.take(this.beginnings.root)) return this.radical(depth);
    if (this.take(PI)) {
      this.surds = true;
      this.pi = true;
      return () => Math.PI;
    }
    return this.text.startsWith("(", this.place) ? this.bracket(depth) : this.number(run);
  }

  /**
   * The root of a bracket or of a single number; what follows that number is not in the root.
   * @param {number} depth
   * @returns {Work}
   */
  radical(depth) {
    const bracket = this.text.startsWith("(", this.place);
    const work = this.rootOf(bracket ? this.bracket(depth) : this.number(DIGITS));
    const after = bracket ? null : matchAt(this.beginnings.factor, this.text, this.place);
    const doubtful = after && "(πΠ𝜋".includes(after[0].trim());
    if (doubtful && BRACKET_OR_PI.test(this.text.slice(this.place))) throw this.fault("two-ways");
    return work;
  }

  /** @param {Work} work @returns {Work} */
  rootOf(work) {
    this.roots += 1;
    this.surds = true;
    if (this.roots > MOST_ROOTS) throw new Unreadable("many-roots", { most: MOST_ROOTS });
    return () => takeRoot(work());
  }

  /** @param {number} depth @returns {Work} */
  bracket(depth) {
    if (depth >= MOST_BRACKETS) throw new Unreadable("deep-brackets", { most: MOST_BRACKETS });
    this.place += 1;
    this.skip();
    const sign = this.text[this.place];
    if (sign === "+" || sign === "-") this.place += 1;
    const work = this.sum(depth + 1, sign === "-");
    this.skip();
    if (!this.text.startsWith(")", this.place)) throw this.fault("open-bracket");
    this.place += 1;
    return work;
  }

  /**
   * A decimal number, a fraction such as ½, or a whole number with a fraction.
   * @param {RegExp} run
   * @returns {Work}
   */
  number(run) {
    const found = scanNumber(this.text, this.place, run);
    if (found) this.place = found.end;
    // 1.234(5): the uncertainty of the last digit, or a second try
    if (found?.digits.includes(".") && matchAt(IN_BRACKETS, this.text, this.place)) {
      throw this.fault("range");
    }
    const vulgar = !found || /^[0-9]+$/.test(found.digits) ? this.take(MIXED) : null;
    if (!found && !vulgar) {
      const rest = quote(this.text.slice(this.place));
      throw new Unreadable("no-number", { typed: quote(this.typed), rest });
    }
    const value = (found?.value ?? 0) + (vulgar ? readVulgar(vulgar[0]) : 0);
    return found && vulgar ? () => value : makeLiteral(value);
  }

  /** @param {RegExp} pattern @returns {RegExpExecArray | null} what it finds here, taken */
  take(pattern) {
    const found = matchAt(pattern, this.text, this.place);
    if (found) this.place += found[0].length;
    return found;
  }

  skip() {
    while (/\s/.test(this.text[this.place] ?? "")) this.place += 1;
  }

  /** @param {string} key */
  fault(key) {
    return new Unreadable(key, { typed: quote(this.typed) });
  }
}

/** @param {number} value @returns {Work} */
function makeLiteral(value) {
  return Object.assign(() => value, { literal: value });
}

/** @param {string} mark @param {Work} first @param {Work} second @returns {Work} */
function combine(mark, first, second) {
  switch (mark) {
    case "+":
      return () => first() + second();
    case "-":
      return () => first() - second();
    case "*":
      return () => first() * second();
    default:
      return () => divide(first(), second());
  }
}

/** @param {number} dividend @param {number} divisor */
function divide(dividend, divisor) {
  if (divisor === 0) throw new Unreadable("division-by-zero");
  return dividend / divisor;
}

/** @param {number} base @param {number} exponent */
function raise(base, exponent) {
  return exponent < 0 ? divide(1, base ** -exponent) : base ** exponent;
}

/** @param {number} radicand */
function takeRoot(radicand) {
  if (radicand < 0) throw new Unreadable("root-of-negative");
  return Math.sqrt(radicand);
}

/** @param {string} sign one such as ½ */
function readVulgar(sign) {
  const [above, below] = sign.trim().normalize("NFKC").split("⁄").map(Number);
  return above / below;
}
