// @ts-check
// Shows the parts of the problem, and shows them anew whenever the file is saved.
(() => {
  const REST = ["check", "draws", "solution"];
  /** @param {string} id */
  const find = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
  const place = /** @type {HTMLSelectElement} */ (find("place"));
  const language = /** @type {HTMLSelectElement} */ (find("language"));
  const motion = /** @type {HTMLIFrameElement} */ (find("motion"));
  const state = find("state");
  let asking = new AbortController();

  /** @param {string} name */
  const address = (name) => `/${name}/${place.value || 0}/${language.value}`;

  /** @param {string} url */
  const read = async (url) => (await fetch(url, { signal: asking.signal })).text();

  /** Puts a part of the page in its place; until then the former one is seen, but paler.
   * @param {string} name */
  const show = async (name) => {
    const box = find(name);
    box.classList.add("stale");
    box.innerHTML = await read(address(name));
    box.classList.remove("stale");
  };

  /** Shows the problem, or over the former one what is wrong with the file; says which it is. */
  const showProblem = async () => {
    const box = find("problem");
    const written = await read(address("problem"));
    const sound = !written.includes('<ul class="faults"');
    box.classList.toggle("stale", !sound);
    box.querySelector(".faults")?.remove();
    if (sound) {
      const typed = readTyped();
      box.innerHTML = written;
      restore(typed);
    } else {
      box.insertAdjacentHTML("afterbegin", written);
    }
    return sound;
  };

  const boxes = () => find("problem").querySelectorAll("input");

  /** The answers that stand in the boxes, by ask. @returns {Record<string, string>} */
  const readTyped = () =>
    Object.fromEntries([...boxes()].map((box) => [box.dataset.ask ?? "", box.value]));

  /** Puts answers back and judges them by the new key. @param {Record<string, string>} typed */
  const restore = (typed) => {
    for (const box of boxes()) {
      const value = typed[box.dataset.ask ?? ""];
      if (value) {
        box.value = value;
        judge(box);
      }
    }
  };

  /** Shows what the problems of the file are called; says whether it can be read. */
  const showLabels = async () => {
    /** @type {string[]} */
    const labels = JSON.parse(await read("/labels"));
    if (labels.length) {
      const chosen = Math.min(Number(place.value || 0), labels.length - 1);
      place.replaceChildren(...labels.map((label, number) => new Option(label, String(number))));
      place.value = String(chosen);
      find("problems").hidden = labels.length < 2;
    }
    return labels.length > 0;
  };

  const showAll = async () => {
    asking.abort();
    asking = new AbortController();
    state.textContent = state.dataset.working ?? "";
    try {
      const sound = await showProblem();
      const readable = await showLabels();
      for (const name of REST) find(name).classList.toggle("stale", !sound);
      if (sound) motion.src = address("motion");
      await Promise.all((sound ? REST : readable ? ["check"] : []).map(show));
      state.textContent = (sound ? state.dataset.current : state.dataset.faulty) ?? "";
    } catch (fault) {
      if (/** @type {Error} */ (fault).name !== "AbortError") {
        state.textContent = state.dataset.lost ?? "";
      }
    }
  };

  /** @param {HTMLInputElement} box */
  const judge = async (box) => {
    const { ask } = box.dataset;
    if (ask === undefined) return;
    const asked = new URLSearchParams({ ask, typed: box.value });
    const said = box.value.trim() ? await read(`${address("verdict")}?${asked}`) : "";
    const verdict = box.parentElement?.querySelector(".verdict");
    if (verdict) verdict.innerHTML = said;
  };

  find("problem").addEventListener("change", (event) => {
    if (event.target instanceof HTMLInputElement) judge(event.target);
  });
  place.addEventListener("change", showAll);
  language.addEventListener("change", showAll);
  const news = new EventSource("/news");
  news.addEventListener("message", showAll);
  news.addEventListener("error", () => {
    state.textContent = state.dataset.lost ?? "";
  });
  news.addEventListener("open", showAll);
})();
