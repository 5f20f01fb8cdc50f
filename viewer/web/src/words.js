// What the program reports, in sentences for people.

export const FAULT_WORDS = {
  device_lost: "the hand was lost", watchdog: "the haptic loop stood still", not_finite: "a number was not finite",
  too_fast: "the hand moved too fast", pose_jump: "the hand jumped",
  turned_too_fast: "the hand turned too fast", orientation_jump: "the hand's direction jumped", contact_stale: "the contact model was too old",
};
const EVENT_WORDS = {
  grasped: "The hand took hold of the object", released: "The hand let the object go", armed: "Forces are on",
  disarmed: "Forces are off", late: "Late", recording_ended: "The recording has ended", not_armed: "Forces stay off", resumed: "Goes on", parameter: "Parameter changed", fault: "Fault",
  held_back: "Held back", squeezed: "Squeezed",
};
export const END_WORDS = { fault: "ended by a fault", duration: "reached its duration", device_finished: "the hand has finished",
  stopped: "was stopped" };

const DEVICE_WORDS = { hand: "simulated hand", web: "mouse or touch", script: "scripted hand", replay: "recorded hand", null: "no hand", "": "a recording" };
export function deviceWords(uri) {
  return DEVICE_WORDS[String(uri).split(":")[0]] ?? uri;
}

export function faultWords(name) {
  return FAULT_WORDS[name] ?? String(name).replaceAll("_", " ");
}

/// How a session ended, with the cause where it was a fault: `state` tells it to pages that come later as well.
export function endWords({ reason, fault }) {
  const words = END_WORDS[reason];
  if (!words || reason !== "fault" || !fault) return words;
  return `${words}: ${faultWords(fault.name)}${fault.text ? ` (${fault.text})` : ""}`;
}

/// What was late and ridden out, while it is worth a line; null otherwise.
/// late   of `state`; time [s] of the session
export function lateWords(late, time) {
  const shown = 6; // [s]
  if (!late || !(time - late.time < shown)) return null;
  const times = late.count === 1 ? "once" : `${late.count} times so far`;
  return `The computer was late (${times}): ${late.text ?? faultWords(late.name)}.`;
}

export function eventWords({ kind, detail, text }) {
  const head = EVENT_WORDS[kind] ?? String(kind).replaceAll("_", " ");
  const cause = kind === "fault" || kind === "late" ? faultWords(detail) : kind === "held_back" ? "" : detail; // its text says it whole
  const tail = [cause, text].filter(Boolean).join("; ");
  return tail ? `${head}: ${tail}` : head;
}

/// What the object does, in one sentence with its number of contacts.
/// facts   {object, statics: [name], grasped, armed, contacts, clusters, touching, force [text], depth [text]}
export function situation(facts) {
  const { object, statics, grasped, contacts, clusters } = facts;
  const subject = `The ${object}`;
  if (contacts === 0) return `${subject} ${grasped ? "is in the hand and" : "rests and"} touches nothing.`;
  const where = statics.length === 1 ? `the ${statics[0]}` : "the scene";
  const count = contacts === 1 ? "1 contact" : `${contacts} contacts`;
  const groups = clusters === 0 ? "" : clusters === 1 ? " in 1 cluster" : ` in ${clusters} clusters`; // relief has none
  if (facts.touching && facts.armed === false) return `${subject} touches ${where} at ${count}${groups}; forces are off.`;
  if (facts.touching) return `${subject} presses on ${where} at ${count}${groups}.`;
  return `${subject} is close to ${where}: ${count}${groups}.`;
}

/// The same where contacts are constraints: how many rows press, and what the hand does.
/// facts   as above, with rows, pressing [numbers], newtons [text], stiffness [text, or null: not known]
export function rowSituation(facts) {
  const { object, statics, rows, pressing } = facts;
  const where = statics.length === 1 ? `the ${statics[0]}` : "the scene";
  if (rows === 0) return `The ${object} ${facts.grasped ? "is in the hand and" : "rests and"} touches nothing.`;
  if (pressing === 0) return `The ${object} is close to ${where}: ${rows === 1 ? "1 row" : `${rows} rows`} near, none presses.`;
  const rests = `The ${object} rests on ${pressing === 1 ? "1 row" : `${pressing} rows`} of ${where}`;
  if (facts.armed === false) return `${rests}; forces are off.`;
  return `${rests}; the hand pulls ${facts.newtons}${facts.stiffness ? `; coupling ${facts.stiffness}` : ""}.`;
}

/// What goes on in a world of several bodies, in a sentence or two.
/// bodies   the newest `bodies` message, or null
export function worldSituation(scene, bodies) {
  if (!bodies) return "Nothing is known of the bodies yet.";
  const all = [scene.object, ...scene.statics], named = (number) => all.find(({ body }) => body === number)?.name;
  const moving = all.filter(({ moves }) => moves), awake = moving.filter(({ body }) => bodies.bodies[body] && !bodies.bodies[body].asleep).length;
  const held = bodies.hands.filter(({ body }) => body >= 0).map(({ body, page }) => `${page ? "the mouse" : "a hand"} holds ${named(body)}`);
  const many = moving.length === 1 ? "1 body moves freely" : `${moving.length} bodies move freely`;
  const rest = awake === 0 ? "all of them rest" : awake === moving.length ? "all are awake" : `${moving.length - awake} of them ${moving.length - awake === 1 ? "rests" : "rest"}`;
  const said = `${many}; ${rest}.`;
  return held.length > 0 ? `${held.join(", ").replace(/^./, (c) => c.toUpperCase())}. ${said}` : said;
}

/// What limits what is felt under constraints, in a sentence.
/// facts   {pressing, stiffness [N/m, or null], stretch [m], force: felt [N; virtual size], heldBack, squeezed: shares of the last second,
///         say: of a number with its unit}
export function limitWords({ pressing, stiffness, stretch, force, heldBack, squeezed, say }) {
  if (squeezed > 0.1) return "Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";
  if (heldBack > 0.01) {
    return `Held back in ${Math.round(100 * heldBack)} % of the last second: the object waits where its contact model ends; move it more slowly.`;
  }
  if (!(pressing > 0) || !(stiffness > 0)) return "Nothing limits the object but the coupling.";
  const spring = stiffness * stretch;
  const product = `${say(stiffness, "N/m")} × ${say(stretch, "m")}`;
  if (force < 0.9 * spring) return `The coupling alone limits the force: ${product} would be ${say(spring, "N")}; it has levelled off, or the device is at its limit.`;
  return `The coupling alone limits the force: ${product}. The surfaces do not give.`;
}

/// Rows that press at the edge of their friction cone: they slide, or are about to.
export function atConeEdge(rows) {
  return rows.filter(({ presses, friction, force, normal }) => {
    const along = force.reduce((sum, value, k) => sum + value * normal[k], 0);
    const across = Math.hypot(...force.map((value, k) => value - along * normal[k]));
    return presses && friction > 0 && across > 0.98 * friction * Math.abs(along);
  }).length;
}

const DECIDERS = ["what a hand feels", "speed", "what the eye sees", "the cap on deviation", "the budget"];

/// What decided how fine contacts are, the most frequent first: "...% by what a hand feels, ...". "" where nothing did but that there is
/// nothing finer, as in exact contacts.
export function deciderWords(contacts) {
  const counts = DECIDERS.map((by, k) => [by, contacts.filter((one) => one.decidedBy === k).length]);
  const told = counts.filter(([, n]) => n > 0).sort(([, a], [, b]) => b - a);
  return told.map(([by, n]) => `${Math.round((100 * n) / contacts.length)} % by ${by}`).join(", ");
}

/// Number of contacts by level of the object, finest first: [[level, n], ...].
export function levelCounts(contacts) {
  const counts = new Map();
  for (const { objectLevel } of contacts) counts.set(objectLevel, (counts.get(objectLevel) ?? 0) + 1);
  return [...counts].sort(([a], [b]) => a - b);
}

/// What a person may choose from a folder: the kinds of mesh files that the program reads, and recordings.
/// kinds   [{ name: "OBJ", ending: ".obj" }, ...]; empty from a program that does not tell: any file
export function acceptedFiles(kinds) {
  return kinds.length > 0 ? [...kinds.map(({ ending }) => ending), ".tex", ".mcap"].join(",") : "";
}

export function filesToDrop(kinds) {
  const names = kinds.length > 0 ? ` (${kinds.map(({ name }) => name).join(", ")})` : "";
  return `Drop meshes${names}, a texture (.tex), or a recording or a scene in one file (.mcap) anywhere on the page, or click to choose.`;
}
