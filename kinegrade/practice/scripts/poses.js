// @ts-check
// The baked positions of a mechanism, and those between them.

/**
 * @typedef {object} Motion
 * @property {boolean} closed
 * @property {number} width
 * @property {number} height
 * @property {number} low
 * @property {number} high
 * @property {string} moved
 * @property {number} speed
 * @property {number} acceleration
 * @property {number[]} radii
 * @property {string[]} coordinates
 * @property {[least: number, greatest: number, steps: string][]} curves
 */

const ORDER = 4; // of the differences by which positions are written
const FINE = 400; // steps of a millimetre
const MOVED_STEPS = 200000; // of the whole way of the input
const CURVE_STEPS = 1000;

/** @param {string} text @returns {number[]} the values behind their differences of the last order */
function sumUp(text) {
  const numbers = text.split(" ").map(Number);
  const order = Math.min(ORDER, numbers.length - 1);
  let values = numbers.slice(order);
  for (const first of numbers.slice(0, order).reverse()) {
    let sum = first;
    values = [first, ...values.map((rise) => (sum += rise))];
  }
  return values;
}

/** Positions by how many of them have been passed, a number that need not be whole. */
class Poses {
  /** @param {Motion} motion */
  constructor(motion) {
    this.motion = motion;
    this.rows = motion.coordinates.map((text) => sumUp(text).map((value) => value / FINE));
    this.moved = sumUp(motion.moved).map((value) => value / MOVED_STEPS);
    this.count = this.moved.length;
  }

  /** @returns {number} the last place */
  get last() {
    return this.motion.closed ? this.count : this.count - 1;
  }

  /** @returns {number} the place of the instant: where the input has not moved */
  get instant() {
    const { low, high } = this.motion;
    const share = -low / (high - low);
    const after = this.moved.findIndex((each) => each >= share - 1e-9);
    if (after <= 0) return 0;
    const [before, next] = [this.moved[after - 1], this.moved[after]];
    return after - 1 + (share - before) / (next - before);
  }

  /** @param {number} place @returns {number} how far the input has moved since the instant */
  inputAt(place) {
    const { low, high } = this.motion;
    return low + (high - low) * interpolate(this.moved, place, (whole) => this.entry(this.moved, whole, 1));
  }

  /** @param {number} place @returns {[number, number][]} where the points are, in mm */
  at(place) {
    const found = this.rows.map((row) => interpolate(row, place, (whole) => this.entry(row, whole, 0)));
    return pair(found);
  }

  /**
   * A row's value at a whole place, also beyond its ends.
   * @param {number[]} row
   * @param {number} whole
   * @param {number} turns whether it grows from turn to turn
   * @returns {number}
   */
  entry(row, whole, turns) {
    if (row.length === 1) return row[0];
    if (this.motion.closed) {
      const wrapped = ((whole % this.count) + this.count) % this.count;
      const gained = turns ? ((whole - wrapped) / this.count) * this.count * (row[1] - row[0]) : 0;
      return row[wrapped] + gained;
    }
    if (whole < 0) return 3 * row[0] - 3 * row[1] + row[2];
    if (whole >= this.count) {
      const [third, second, first] = row.slice(-3);
      return 3 * first - 3 * second + third;
    }
    return row[whole];
  }

  /**
   * Velocities and accelerations of the points in mm, the given ones of the input being at work.
   * @param {number} place
   * @returns {{velocities: [number, number][], accelerations: [number, number][]}}
   */
  rates(place) {
    const { closed, speed, acceleration } = this.motion;
    const inside = closed ? place : Math.min(Math.max(place, 2), this.last - 2);
    const places = AROUND.map((shift) => inside + shift);
    const [slope, bend] = differentiate(places.map((each) => this.inputAt(each)));
    const spots = places.map((each) => this.at(each).flat());
    const found = spots[0].map((_, row) => {
      const [first, second] = differentiate(spots.map((spot) => spot[row]));
      const rise = first / slope;
      const bent = (second - rise * bend) / slope ** 2;
      return { velocity: rise * speed, acceleration: bent * speed ** 2 + rise * acceleration };
    });
    return {
      velocities: pair(found.map((each) => each.velocity)),
      accelerations: pair(found.map((each) => each.acceleration)),
    };
  }
}

const AROUND = [-2, -1, 0, 1, 2];

/** @param {number[]} values at five neighbouring places @returns {[number, number]} two derivatives */
function differentiate([a, b, c, d, e]) {
  return [(a - 8 * b + 8 * d - e) / 12, (-a + 16 * b - 30 * c + 16 * d - e) / 12];
}

/** @param {number[]} numbers @returns {[number, number][]} */
function pair(numbers) {
  /** @type {[number, number][]} */
  const pairs = [];
  for (let row = 0; row < numbers.length; row += 2) pairs.push([numbers[row], numbers[row + 1]]);
  return pairs;
}

/**
 * The value at a place between whole ones, by the cubic through the four nearest.
 * @param {number[]} row
 * @param {number} place
 * @param {(whole: number) => number} entry
 * @returns {number}
 */
function interpolate(row, place, entry) {
  if (row.length === 1) return row[0];
  const whole = Math.floor(place);
  const t = place - whole;
  const [a, b, c, d] = [whole - 1, whole, whole + 1, whole + 2].map(entry);
  const first = (-t * (t - 1) * (t - 2)) / 6;
  const second = ((t + 1) * (t - 1) * (t - 2)) / 2;
  const third = (-(t + 1) * t * (t - 2)) / 2;
  const fourth = ((t + 1) * t * (t - 1)) / 6;
  return a * first + b * second + c * third + d * fourth;
}
