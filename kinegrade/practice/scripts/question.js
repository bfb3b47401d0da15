// @ts-check
// One question on the page: its numbers, its boxes and verdicts, its hints.

/**
 * @typedef {object} Setting what all questions share
 * @property {Words} words
 * @property {Record<string, string>} mistakes
 * @property {AnswerReader} reader
 * @property {Score} score
 */

const PIXELS = 5; // for a millimetre on paper: letters are then as large as those around them

/** Shows a question; `box` is a copy of the page's template for it. */
class QuestionView {
  /** @param {Question} question @param {number} place @param {Element} box @param {Setting} setting */
  constructor(question, place, box, setting) {
    this.question = question;
    this.place = place;
    this.box = box;
    this.setting = setting;
    this.number = 0;
    this.told = 0;
    this.spoilt = false;
    /** @type {string[]} */
    this.sections = [];
    /** @type {Key[]} */
    this.keys = [];
    find(box, "h2").innerHTML = `${place + 1}. ${question.title}`;
    this.motion = new MotionView(find(box, ".motion"), question, setting.words);
    this.rows = question.asks.map((ask, row) => this.addRow(ask, row));
    this.listen(".another", "click", () => this.show((this.number + 1) % question.draws.length));
    this.listen(".hint", "click", () => this.tellNext());
    this.listen(".solution", "click", () => this.tellAll());
    this.listen("form", "submit", (event) => {
      event.preventDefault();
      this.check();
    });
    this.show(0);
  }

  /** @returns {Draw} */
  get draw() {
    return this.question.draws[this.number];
  }

  /** @param {string} selector @param {string} happening @param {(event: Event) => void} act */
  listen(selector, happening, act) {
    find(this.box, selector).addEventListener(happening, act);
  }

  /** @param {Ask} ask @param {number} row @returns {Element} the row of an ask */
  addRow(ask, row) {
    const added = copyTemplate("row");
    const name = `q${this.place + 1}-${row + 1}`;
    const label = find(added, "label");
    label.innerHTML = ask.label;
    label.setAttribute("for", name);
    find(added, "input").id = name;
    // Browsers leave formulas out of the name that they take from a label
    find(added, "input").setAttribute("aria-label", readAloud(label));
    find(added, "input").setAttribute("aria-describedby", `${name}-unit ${name}-said`);
    find(added, ".unit").id = `${name}-unit`;
    find(added, ".unit").innerHTML = ask.shown;
    find(added, ".verdict").id = `${name}-said`;
    find(this.box, ".rows").append(added);
    return added;
  }

  /** @param {number} number of the draw to show */
  show(number) {
    const { words } = this.setting;
    this.number = number;
    this.told = 0;
    this.spoilt = false;
    const [statement, figure, ...rest] = this.draw.texts.map((lines) => fillLines(this.question, lines));
    this.sections = rest.slice(this.rows.length);
    find(this.box, ".statement").innerHTML = statement;
    showFigure(find(this.box, ".figure"), figure);
    this.motion.take(this.draw);
    this.keys = readKeys(this.question, this.draw);
    this.rows.forEach((row, place) => {
      /** @type {HTMLInputElement} */ (find(row, "input")).value = "";
      find(row, ".tolerance").innerHTML = rest[place];
      this.say(row, "", "");
    });
    const count = this.question.draws.length;
    find(this.box, ".numbers").textContent = words.say("numbers", { number: number + 1, count });
    find(this.box, ".earned").textContent = "";
    find(this.box, ".steps").replaceChildren();
    this.updateButtons();
  }

  /** Judges what was typed into all boxes. */
  check() {
    const { question, keys, setting } = this;
    const verdicts = this.rows.map((row, place) => {
      const { value } = /** @type {HTMLInputElement} */ (find(row, "input"));
      return judge(setting.reader.read(value, question.asks[place]), keys[place]);
    });
    const judged = followThrough(question, this.draw, keys, verdicts);
    let earned = 0;
    judged.forEach((verdict, place) => {
      const ask = question.asks[place];
      this.say(this.rows[place], verdict.kind, explainVerdict(verdict, keys[place], ask, setting));
      earned += findShare(verdict, keys[place]) * ask.points;
    });
    this.tellEarned(earned, judged);
  }

  /** @param {number} earned @param {Verdict[]} judged */
  tellEarned(earned, judged) {
    const { words, score } = this.setting;
    const points = { earned, points: countPoints(this.question.asks) };
    const said = [words.say(this.spoilt ? "earned-spoilt" : "earned", points)];
    if (isCutOff(this.question, this.draw, this.keys, judged)) said.push(words.say("no-following"));
    find(this.box, ".earned").textContent = said.join(" ");
    if (!this.spoilt) score.note(this.place, earned);
  }

  /** Shows the next part of the worked solution. */
  tellNext() {
    const part = document.createElement("div");
    part.innerHTML = this.sections[this.told];
    find(this.box, ".steps").append(part);
    this.told += 1;
    this.spoilt = this.told === this.sections.length;
    this.updateButtons();
  }

  /** Shows all of the worked solution. */
  tellAll() {
    while (this.told < this.sections.length) this.tellNext();
  }

  updateButtons() {
    const done = this.told === this.sections.length;
    for (const name of [".hint", ".solution"]) {
      /** @type {HTMLButtonElement} */ (find(this.box, name)).disabled = done;
    }
    const next = this.told + 1;
    const parts = { number: Math.min(next, this.sections.length), count: this.sections.length };
    find(this.box, ".hint").textContent = this.setting.words.say("hint", parts);
  }

  /** @param {Element} row @param {string} kind @param {string} said */
  say(row, kind, said) {
    const verdict = find(row, ".verdict");
    verdict.textContent = said;
    verdict.setAttribute("data-kind", kind);
    const isWrong = kind !== "" && kind !== "right" && kind !== "follow-through";
    find(row, "input").setAttribute("aria-invalid", String(isWrong));
  }
}

/** @param {Element} place @param {string} figure an SVG document, "" where there is none */
function showFigure(place, figure) {
  place.innerHTML = figure;
  const drawn = place.querySelector("svg");
  if (drawn) drawn.style.width = `${drawn.viewBox.baseVal.width * PIXELS}px`;
  place.toggleAttribute("hidden", !figure);
}

/** @param {ParentNode} within @param {string} selector @returns {Element} */
function find(within, selector) {
  const found = within.querySelector(selector);
  if (!found) throw new Error(`no ${selector}`);
  return found;
}

/** @param {Element} element @returns {string} its text with formulas in plain letters */
function readAloud(element) {
  return (element.textContent ?? "").normalize("NFKC").replace(/\s+/g, " ").trim();
}

/** @param {string} name of a template of the page @returns {Element} a copy of what is in it */
function copyTemplate(name) {
  const template = /** @type {HTMLTemplateElement} */ (find(document, `template#${name}`));
  return /** @type {Element} */ (find(template.content, "*").cloneNode(true));
}
