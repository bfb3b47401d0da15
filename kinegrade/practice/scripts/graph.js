// @ts-check
// Small graphs of what is asked, over the cycle, with the place that is shown.

const GRAPH_WIDTH = 300;
const GRAPH_HEIGHT = 84;
const BESIDE = 4; // positions that shape a curve between them: more would swing where it is cut off
const AT_GAP = 0.001; // positions from a gap, to the ends of the curve beside it

/** Draws the curve of an ask. */
class Graph {
  /**
   * @param {Element} place
   * @param {Ask} ask
   * @param {[number, number, string, number[]]} curve
   * @param {Poses} poses
   * @param {Words} words
   */
  constructor(place, ask, [least, greatest, steps, gaps], poses, words) {
    const box = document.createElement("figure");
    const values = sumUp(steps).map((value) => value / CURVE_STEPS);
    this.values = values.length === 1 ? [0.5] : values;
    this.poses = poses;
    this.gaps = poses.repeat(gaps);
    this.whole = poses.shareAt(poses.last);
    const [low, high] = [least, greatest].map((value) => words.writeNumber(value, 3));
    const range = low === high ? low : `${low} … ${high}`;
    box.innerHTML = `<figcaption>${ask.label}: ${range} ${ask.shown}</figcaption>`;
    const graph = makeShape("svg", { viewBox: `0 0 ${GRAPH_WIDTH} ${GRAPH_HEIGHT}`, class: "graph", "aria-hidden": "true" });
    for (const part of this.parts(gaps)) {
      const corners = part.map((place) => this.corner(place));
      graph.append(makeShape("polyline", { class: "curve", points: writeCorners(corners) }));
    }
    this.mark = makeShape("circle", { class: "mark", r: 4 });
    graph.append(this.mark);
    box.append(graph);
    place.append(box);
  }

  /** @param {number[]} gaps @returns {number[][]} the places of each part of the curve */
  parts(gaps) {
    const bounds = [-Infinity, ...gaps, Infinity];
    return bounds.slice(1).map((next, number) => {
      const [start, end] = [bounds[number] + AT_GAP, next - AT_GAP];
      const inside = this.poses.fine.filter((place) => start < place && place < end);
      return [start, ...inside, end].filter(Number.isFinite);
    });
  }

  /** @param {number} place @returns {number} the value, beside a gap from positions on its side */
  valueAt(place) {
    const { poses, values, gaps } = this;
    const gap = gaps.find((each) => Math.abs(each - place) < BESIDE);
    if (gap === undefined || values.length === 1) return poses.combine(values, poses.near(place, BESIDE), 0);
    const whole = Math.floor(place);
    const isBroken = whole <= gap && gap <= whole + 1;
    const first = isBroken ? (place < gap ? Math.ceil(gap) - 2 : Math.floor(gap) + 1) : whole;
    const [low, high] = [first, first + 1].map((each) => poses.entry(values, each, false));
    return low + (high - low) * (place - first);
  }

  /** @param {number} place @returns {[number, number]} the corner of the curve there */
  corner(place) {
    const { poses } = this;
    const value = clamp(this.valueAt(place), 0, 1);
    const across = 4 + ((GRAPH_WIDTH - 8) * poses.shareAt(place)) / this.whole;
    return [across, GRAPH_HEIGHT - 8 - (GRAPH_HEIGHT - 16) * value];
  }

  /** @param {number} place */
  show(place) {
    moveCircle(this.mark, this.corner(place));
  }
}
