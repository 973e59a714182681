// SPDX-License-Identifier: GPL-3.0-or-later
// A headless Chromium that opens files, by the pipe of its debugging protocol: no package of node is needed.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

export class Browser {
  /// Where nobody looks, pictures have a quarter of the pixels in each direction. `software`: the page is not put together by
  /// the graphics processor, which is software here. So a browser does by itself on a machine without a graphics card: half
  /// the processors' time.
  static async start(program, { width = 1100, height = 900, unseen = false, software = unseen } = {}) {
    const browser = new Browser();
    browser.folder = mkdtempSync(join(tmpdir(), "torsor-browser-"));
    browser.process = spawn(program, [
      "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
      // A page of which nobody sees a window would wait behind all other work of the machine.
      "--enable-unsafe-swiftshader", "--disable-renderer-backgrounding", "--disable-backgrounding-occluded-windows", "--disable-background-networking", "--disable-component-update", "--no-first-run",
      `--window-size=${width},${height}`, `--user-data-dir=${browser.folder}`, "--remote-debugging-pipe",
      ...(software ? ["--disable-gpu-compositing"] : []), "about:blank",
    ], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    browser.waiting = new Map();
    browser.number = 0;
    browser.seen = [];
    let text = "";
    browser.process.stdio[4].setEncoding("utf8");
    browser.process.stdio[4].on("data", (data) => {
      text += data;
      for (let end = text.indexOf("\0"); end >= 0; end = text.indexOf("\0")) {
        browser.receive(JSON.parse(text.slice(0, end)));
        text = text.slice(end + 1);
      }
    });
    const { targetInfos } = await browser.send("Target.getTargets");
    const page = targetInfos.find((each) => each.type === "page");
    browser.session = (await browser.send("Target.attachToTarget", { targetId: page.targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await browser.send(`${domain}.enable`);
    if (unseen) await browser.send("Page.addScriptToEvaluateOnNewDocument", { source: 'Object.defineProperty(window, "devicePixelRatio", { value: 0.25 })' });
    return browser;
  }

  receive(message) {
    if (message.id === undefined) {
      this.seen.push(message);
      return;
    }
    const { done, fail } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) fail(new Error(message.error.message));
    else done(message.result);
  }

  /// To the page once there is one; to the browser itself with an empty `sessionId`.
  send(method, params = {}, sessionId = this.session) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, ...(sessionId ? { sessionId } : {}) }) + "\0");
    return new Promise((done, fail) => this.waiting.set(id, { done, fail }));
  }

  async open(file) {
    this.seen = [];
    await this.send("Page.navigate", { url: `file://${resolve(file)}` });
    for (let tries = 0; tries < 2400; ++tries) {
      if (this.seen.some((each) => each.method === "Page.loadEventFired")) return;
      await new Promise((done) => setTimeout(done, 50));
    }
    throw new Error(`${file} did not load within 120 s`);
  }

  /// Waits until a report has integrated its motion, but not for longer: whether it has, or has none.
  async moved(seconds = 600) {
    return this.evaluate(`new Promise((done) => {
      setTimeout(done, ${1000 * seconds}, false);
      const until = Number(document.getElementById("until")?.value ?? 0), motion = () => window.torsorReport?.current;
      const wait = () => (!motion() || motion().time >= until - 1e-9 || motion().status !== "ok" ? done(true) : setTimeout(wait, 50));
      wait();
    })`);
  }

  /// The value of an expression in the page; a promise is waited for.
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /// What the console was told as a warning or an error, and what went wrong without being caught.
  complaints() {
    return this.seen.flatMap(({ method, params }) => {
      if (method === "Runtime.exceptionThrown") return [params.exceptionDetails.exception?.description ?? params.exceptionDetails.text];
      if (method === "Log.entryAdded" && ["warning", "error"].includes(params.entry.level)) return [params.entry.text];
      if (method === "Runtime.consoleAPICalled" && ["warning", "error", "assert"].includes(params.type)) return [params.args.map((each) => each.value).join(" ")];
      return [];
    }).filter((text) => !/GPU stall|Automatic fallback to software WebGL/.test(text));  // of software rendering
  }

  /// Addresses that were asked for, beside the file itself and what it carries.
  requests() {
    return this.seen.filter((each) => each.method === "Network.requestWillBeSent").map((each) => each.params.request.url)
      .filter((url) => !url.startsWith("data:")).slice(1);
  }

  async screenshot(file, whole = false) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: whole });
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  async close() {
    const ended = new Promise((done) => this.process.on("exit", done));
    await this.send("Browser.close").catch(() => {});
    await ended;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 10 });
  }
}
