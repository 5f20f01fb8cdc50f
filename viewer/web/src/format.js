// Numbers for people: three digits, a unit with the right prefix, and nothing made up for what is unknown.

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"]];

/// 0.00132, "N" -> {number: "1.32", unit: "mN"}; what is not finite -> {number: "–", unit}.
/// least   smallest prefix worth showing: below half a hundredth of it the number is "0"
export function split(value, unit, least = 1e-6) {
  if (value === null || value === undefined || !Number.isFinite(value)) return { number: "–", unit };
  const size = Math.abs(value);
  if (size < 0.005 * least) return { number: "0", unit };
  let [scale, prefix] = PREFIXES[PREFIXES.length - 1];
  for (const [at, name] of PREFIXES) {
    if (size >= 0.9995 * at || at <= least) { [scale, prefix] = [at, name]; break; }
  }
  return { number: digits(value / scale), unit: prefix + unit };
}

/// Three digits that count: 1.23, 12.3, 123, 1230.
export function digits(value) {
  const size = Math.abs(value);
  return value.toFixed(size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

export function say(value, unit, least) {
  const { number, unit: named } = split(value, unit, least);
  return number === "–" ? number : `${number} ${named}`;
}

/// 0.71 s; 12.4 s; 3:05 min.
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")} min`;
}

/// "1 contact", "2 contacts".
export function count(n, one, many = `${one}s`) {
  return `${n} ${n === 1 ? one : many}`;
}
