// @ts-check
// Drives a browser for tests: reads a command a line from the standard input, each a name and what
// it takes, and writes an answer a line. Begun with the name of the browser and its program.

const { createInterface } = require("node:readline");
const { readFileSync } = require("node:fs");
const puppeteer = require("puppeteer-core");

const FLAGS = { chrome: ["--no-sandbox", "--disable-gpu"], firefox: [] };
const AXE = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

/** A browser with one page at a time. */
class Driver {
  constructor(browser) {
    this.browser = browser;
    this.context = null;
    this.told = [];
  }

  /** A page that nobody has seen: what is kept by others is not there. */
  async fresh() {
    await this.context?.close();
    this.context = await this.browser.createBrowserContext();
    this.page = await this.context.newPage();
    this.told = [];
    this.page.on("console", (said) => this.told.push(`${said.type()}: ${said.text()}`));
    this.page.on("pageerror", (error) => this.told.push(`error: ${error}`));
    this.page.on("request", (request) => {
      if (!request.url().startsWith("data:")) this.told.push(`request: ${request.url()}`);
    });
  }

  /** The sources run before the scripts of the page. */
  async open({ address, before }) {
    for (const source of before) await this.page.evaluateOnNewDocument(source);
    await this.page.goto(address, { waitUntil: "load" });
  }

  run({ script }) {
    return this.page.evaluate(script);
  }

  press({ key }) {
    return this.page.keyboard.press(key);
  }

  type({ text }) {
    return this.page.keyboard.type(text);
  }

  async drag({ from, to }) {
    const { mouse } = this.page;
    await mouse.move(...from);
    await mouse.down();
    await mouse.move(...to);
    await mouse.up();
  }

  size({ width, height }) {
    return this.page.setViewport({ width, height });
  }

  /**
   * Shows the page as people have it who want dark colours, less motion, or paper. Chromium takes
   * both at once; one after the other, the second takes the first back.
   */
  async prefer({ medium, features }) {
    const session = await this.page.createCDPSession();
    await session.send("Emulation.setEmulatedMedia", { media: medium, features });
  }

  picture({ file }) {
    return this.page.screenshot({ path: file, fullPage: true });
  }

  /** What axe-core finds, a line each. */
  async faults() {
    await this.page.evaluate(AXE);
    const { violations } = await this.page.evaluate("axe.run({ resultTypes: ['violations'] })");
    const describe = ({ id, nodes }) =>
      nodes.map((node) => `${id}: ${node.html} - ${node.failureSummary}`);
    return violations.flatMap(describe);
  }

  /** The page as screen readers have it. */
  tree() {
    return this.page.accessibility.snapshot();
  }

  /** Messages and requests since the page was made. */
  messages() {
    return this.told;
  }
}

async function answer(driver, command, given) {
  try {
    return { found: (await driver[command](given)) ?? null };
  } catch (error) {
    return { error: String(error.stack ?? error) };
  }
}

async function main(name, program) {
  const browser = await puppeteer.launch({
    browser: name,
    executablePath: program,
    headless: true,
    args: FLAGS[name],
  });
  const driver = new Driver(browser);
  for await (const line of createInterface({ input: process.stdin })) {
    const [command, given] = JSON.parse(line);
    process.stdout.write(`${JSON.stringify(await answer(driver, command, given))}\n`);
  }
  await browser.close();
}

main(process.argv[2], process.argv[3]);
