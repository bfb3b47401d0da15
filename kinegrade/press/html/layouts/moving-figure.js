// Shows one drawing after the other; the slider and its arrow keys choose one by hand.
(() => {
  const box = document.getElementById(ID);
  const stage = box.querySelector("g.moving");
  const slider = box.querySelector("input");
  const button = box.querySelector("button");
  const shown = box.querySelector("output");
  const count = DATA.drawings.length;
  let sense = 1;
  let last = null;
  let timer = null;
  const show = (number) => {
    stage.innerHTML = DATA.drawings[number];
    shown.textContent = DATA.moved[number];
    slider.value = number;
  };
  const advance = (time) => {
    if (last === null || time - last > DATA.pause) {
      last = time;
      let next = Number(slider.value) + sense;
      if (DATA.closed) next = (next + count) % count;
      else if (next < 0 || next >= count) {
        sense = -sense;
        next = Number(slider.value) + sense;
      }
      show(Math.max(0, Math.min(count - 1, next)));
    }
    timer = requestAnimationFrame(advance);
  };
  const stop = () => {
    cancelAnimationFrame(timer);
    timer = null;
    button.textContent = DATA.play;
  };
  const play = () => {
    timer = requestAnimationFrame(advance);
    button.textContent = DATA.stop;
  };
  button.addEventListener("click", () => (timer === null ? play() : stop()));
  slider.addEventListener("input", () => {
    stop();
    show(Number(slider.value));
  });
  show(DATA.first);
  stop();
})();
