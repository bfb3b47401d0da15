// @ts-check
// Plays what has places from 0 to a last one, or lets the slider and its arrow keys choose one.

const CYCLE_SECONDS = 6;
const STILLS = 12; // of a cycle, one each second, for those who want less motion

/**
 * @typedef {object} Reel
 * @property {number} last the last place; of a closed one the first again
 * @property {boolean} closed
 * @property {number} first the place that is shown first
 * @property {number} sense 1, or -1 where it is played back first
 */

/** Shows places by `show`, one after the other while it plays. */
class Player {
  /**
   * @param {Element} box with a button, a slider
   * @param {{play: string, stop: string}} words
   * @param {(place: number) => void} show
   */
  constructor(box, words, show) {
    this.button = /** @type {HTMLButtonElement} */ (box.querySelector("button"));
    this.slider = /** @type {HTMLInputElement} */ (box.querySelector("input[type=range]"));
    this.words = words;
    this.draw = show;
    this.place = 0;
    this.playing = 0;
    /** @type {Reel | null} */
    this.reel = null;
    this.button.addEventListener("click", () => (this.playing ? this.stop() : this.play()));
    this.slider.addEventListener("input", () => {
      this.stop();
      this.show(Number(this.slider.value));
    });
    this.stop();
  }

  /** @param {Reel} reel what is shown from now on */
  load(reel) {
    this.reel = { ...reel };
    this.slider.max = String(reel.last);
    this.show(reel.first);
  }

  /** @param {number} place */
  show(place) {
    this.place = place;
    this.slider.value = String(place);
    this.draw(place);
  }

  play() {
    this.button.textContent = this.words.stop;
    const pause = matchMedia("(prefers-reduced-motion: reduce)").matches ? 1 : 0;
    let before = 0;
    const advance = (/** @type {number} */ time) => {
      const gone = (time - before) / 1000;
      if (before && gone >= pause) this.advance(pause ? CYCLE_SECONDS / STILLS : gone);
      if (!before || gone >= pause) before = time;
      this.playing = requestAnimationFrame(advance);
    };
    this.playing = requestAnimationFrame(advance);
  }

  stop() {
    cancelAnimationFrame(this.playing);
    this.playing = 0;
    this.button.textContent = this.words.play;
  }

  /** @param {number} seconds forward, and back where it cannot go on */
  advance(seconds) {
    if (!this.reel) return;
    const { last, closed, sense } = this.reel;
    const next = this.place + (sense * last * seconds) / CYCLE_SECONDS;
    if (!closed && (next < 0 || next > last)) this.reel.sense = -sense;
    this.show(bound(next, this.reel));
  }
}

/** @param {number} place @param {{last: number, closed: boolean}} reel @returns {number} within it */
function bound(place, { last, closed }) {
  return closed ? modulo(place, last) : clamp(place, 0, last);
}

/** @param {number} value @param {number} least @param {number} most @returns {number} */
function clamp(value, least, most) {
  return Math.min(Math.max(value, least), most);
}

/** @param {number} value @param {number} period @returns {number} the rest, never below zero */
function modulo(value, period) {
  return ((value % period) + period) % period;
}
