// Chromium, headless, with WebGL in software; or the reason why there is none.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";

const FOUND = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const GL = process.env.THIGMA_GL === "llvmpipe" ? ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
  : ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]; // needs nothing but Chromium
// As on a computer without graphics hardware, only WebGL is made by a software driver. Without this Chromium takes the driver
// for hardware and makes everything by it, text and plots too, at up to a second a frame.
const PAGE = ["--disable-gpu-compositing"];

/// returns   {browser} or {reason}
export async function startBrowser() {
  const executablePath = FOUND.find((path) => path && existsSync(path));
  if (!executablePath) return { reason: "no Chromium here (apt-get install chromium, or set CHROMIUM)" };
  let playwright = null;
  try {
    playwright = await import("playwright-core");
  } catch {
    return { reason: "playwright-core is not installed (npm ci in viewer/web)" };
  }
  const args = ["--disable-dev-shm-usage", "--disable-gpu-watchdog", ...PAGE, ...GL]; // busy is not hung
  if (process.getuid?.() === 0) args.push("--no-sandbox"); // Chromium's sandbox refuses root
  return { browser: await playwright.chromium.launch({ executablePath, args, headless: true, timeout: 120000 }) };
}

/// A page with its console watched; errors collects what should not be there.
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: "light", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120000);
  const wait = page.waitForFunction.bind(page); // asks by the clock: a busy machine makes few frames to ask at
  page.waitForFunction = (holds, arg, more = {}) => wait(holds, arg, { polling: 50, ...more });
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error.stack ?? error)));
  page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
  await page.goto(url);
  return { page, errors, context };
}

/// Waits until a statement about this process holds.
export async function until(holds, what) {
  for (const end = Date.now() + 150000; Date.now() < end;) {
    if (holds()) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`never: ${what}`);
}
