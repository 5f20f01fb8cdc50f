// Chromium, headless, with WebGL in software; or the reason why there is none.
import { existsSync } from "node:fs";

const FOUND = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const GL = process.env.THIGMA_GL === "llvmpipe" ? ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
  : ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]; // needs nothing but Chromium

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
  const args = ["--disable-dev-shm-usage", "--disable-gpu-watchdog", ...GL]; // busy is not hung
  if (process.getuid?.() === 0) args.push("--no-sandbox"); // Chromium's sandbox refuses root
  return { browser: await playwright.chromium.launch({ executablePath, args, headless: true, timeout: 120000 }) };
}

const WANTED = process.env.THIGMA_BROWSER || process.env.THIGMA_FULL || process.env.THIGMA_SHOTS;

/// Why the cases in a browser are left out, or null. Their renderer works in software: eight minutes of two cores, of the half
/// hour that the whole test has.
export function leftOut() {
  return WANTED ? null : "takes eight minutes of two cores at present: THIGMA_BROWSER=1 or scripts/test --full runs it";
}

/// A page with its console watched; errors collects what should not be there.
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: "light", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120000);
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error.stack ?? error)));
  page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
  await page.goto(url);
  return { page, errors, context };
}
