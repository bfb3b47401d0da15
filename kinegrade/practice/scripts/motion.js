// @ts-check
// The moving mechanism of a question: it is played, or its input is moved by hand.

/** Shows the motions of a question's draws; `box` is the part of the page for them. */
class MotionView {
  /** @param {Element} box @param {Question} question @param {Words} words */
  constructor(box, question, words) {
    this.box = box;
    this.question = question;
    this.words = words;
    /** @type {Poses | null} */
    this.poses = null;
    this.stage = /** @type {SVGElement} */ (find(box, ".stage svg"));
    const said = { play: words.say("play"), stop: words.say("stop") };
    this.player = new Player(box, said, (place) => this.show(place));
    this.player.slider.setAttribute("aria-label", question.skeleton?.input ?? "");
    for (const each of box.querySelectorAll("input[type=checkbox]")) {
      each.addEventListener("change", () => this.show(this.player.place));
    }
    this.stage.addEventListener("pointerdown", (event) => this.grab(event));
    box.addEventListener("toggle", () => this.open());
  }

  /** @param {Draw} draw the draw that is shown from now on */
  take(draw) {
    this.player.stop();
    this.draw = draw;
    this.poses = null;
    this.box.toggleAttribute("hidden", !draw.motion);
    this.open();
  }

  /** Draws what was not drawn as long as this part of the page was closed. */
  open() {
    const { draw, question } = this;
    if (!this.box.hasAttribute("open")) this.player.stop();
    const motion = draw?.motion;
    if (!this.box.hasAttribute("open") || this.poses || !motion || !question.skeleton) return;
    const poses = new Poses(motion);
    this.poses = poses;
    this.drawing = new Drawing(this.stage, question.skeleton, poses);
    const graphs = find(this.box, ".graphs");
    graphs.replaceChildren();
    for (const each of this.box.querySelectorAll(".of-poles")) {
      each.toggleAttribute("hidden", !(motion.poles && question.skeleton.poles.length));
    }
    this.graphs = question.followed.map(
      (row, number) => new Graph(graphs, question.asks[row], motion.curves[number], poses, this.words),
    );
    this.player.load({
      last: poses.last,
      closed: motion.closed,
      first: poses.instant,
      sense: Math.sign(motion.speed) || 1,
    });
  }

  /** @param {number} place */
  show(place) {
    if (!this.poses || !this.drawing) return;
    const wants = (/** @type {string} */ name) =>
      /** @type {HTMLInputElement} */ (find(this.box, `.${name}`)).checked;
    this.drawing.show(place, {
      velocities: wants("velocities"),
      accelerations: wants("accelerations"),
      paths: wants("paths"),
      poles: wants("poles"),
      centrodes: wants("centrodes"),
    });
    for (const graph of this.graphs ?? []) graph.show(place);
    const { unit } = /** @type {Skeleton} */ (this.question.skeleton);
    const moved = this.poses.inputAt(place);
    const said = unit === "m" ? `${this.words.writeNumber(Number(moved.toFixed(4)), 3)} m` : `${this.words.writeNumber(Math.round(moved))}°`;
    find(this.box, "output").textContent = said;
    this.player.slider.setAttribute("aria-valuetext", said);
  }

  /** @param {PointerEvent} event takes the nearest moving point along until it is let go */
  grab(event) {
    if (!this.poses || !this.drawing) return;
    this.player.stop();
    const here = this.locate(event);
    const points = this.poses.at(this.player.place);
    const distance = (/** @type {number} */ row) =>
      Math.hypot(points[row][0] - here[0], points[row][1] - here[1]);
    const [held] = this.drawing.listMoving().sort((one, other) => distance(one) - distance(other));
    if (held === undefined) return;
    const pull = (/** @type {PointerEvent} */ moved) => this.pull(held, this.locate(moved));
    this.stage.setPointerCapture(event.pointerId);
    this.stage.addEventListener("pointermove", pull);
    const release = () => this.stage.removeEventListener("pointermove", pull);
    this.stage.addEventListener("pointerup", release, { once: true });
    this.stage.addEventListener("pointercancel", release, { once: true });
  }

  /** @param {number} row @param {[number, number]} to shows the nearest place not far from here */
  pull(row, [x, y]) {
    const poses = /** @type {Poses} */ (this.poses);
    const { last } = poses;
    let [best, least] = [this.player.place, Infinity];
    for (let shift = -last / 5; shift <= last / 5; shift += last / 400) {
      const place = bound(this.player.place + shift, { last, closed: poses.motion.closed });
      const [left, top] = poses.at(place)[row];
      const distance = Math.hypot(left - x, top - y) + (1e-3 * Math.abs(shift)) / last;
      if (distance < least) [best, least] = [place, distance];
    }
    this.player.show(best);
  }

  /** @param {PointerEvent} event @returns {[number, number]} where it is in the drawing, in mm */
  locate(event) {
    const box = this.stage.getBoundingClientRect();
    const { x, y, width } = /** @type {SVGSVGElement} */ (this.stage).viewBox.baseVal;
    const scale = width / box.width;
    return [x + (event.clientX - box.left) * scale, y + (event.clientY - box.top) * scale];
  }
}
