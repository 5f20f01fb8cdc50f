// The page as the one who holds the device: when it may, how it begins and ends, and what of the hand goes to the program.
import { claims } from "./gizmo.js";
import { noteSample, poseOf, takeSamples } from "./hand.js";
import { ask, letGo, sendHand } from "./link.js";
import { pickBody } from "./world.js";
import { holdsXr } from "./xr.js";

/// page   {session, hand, request(message) -> promise of the `ack`; stage, link, xr, gizmo: null until they are there}
/// returns   {page, player: what mouse, fingers, keys, gamepad and headset act on}
export function makeHolding(page) {
  const { session, hand } = page, holding = { page, player: null, wanted: false, next: null, last: null };
  holding.player = {
    get stage() { return page.stage; },
    hand,
    workspace: () => session.scene.workspace,
    grasp: () => session.snapshot?.grasp ?? [0, 0, 0],
    claims: (event) => page.gizmo !== null && claims(page.gizmo, event),
    mayMove: () => session.connected && !page.stage?.editing && session.hello?.may_control !== false && Boolean(session.state?.device.startsWith("web:")) &&
      session.state.holder !== "other" && session.state.run !== "ended" && !session.state.replay && Boolean(session.snapshot),
    press: (pick = null) => press(holding, pick),
    moved: (turned) => { session.turned ||= turned; },
    give: () => giveHand(holding),
    letGo: () => {
      holding.wanted = false;
      holding.next = null;
      hand.clutch = false;
      confirmHand(holding);
    },
  };
  return holding;
}

/// from   where the hand was then: what is dragged before the answer comes counts as well
async function press(holding, pick, from = poseOf(holding.page.hand)) {
  const { session, hand, request, stage } = holding.page;
  if (hand.clutch && session.holding) return;
  if (session.asking) { // a new press after one that was let go waits for that one's answer; a key that repeats is the same press
    if (!holding.wanted) holding.next = { pick, from };
    holding.wanted = true;
    return;
  }
  session.asking = holding.wanted = true;
  if (!session.holding) setHold(holding, (await request({ type: "hold", value: true })).ok);
  const isReady = session.holding && (!session.scene.world || await grab(holding, pick ?? pickBody(stage, null) ?? holding.last));
  session.asking = false;
  const { next } = holding;
  holding.next = null;
  if (next) {
    await press(holding, next.pick, next.from);
    return;
  }
  if (!session.holding || !isReady || !holding.wanted) return; // let go before the answer came
  noteSample(hand, performance.now() / 1000, from); // open first, so that the clutch is seen to close
  hand.clutch = true;
  confirmHand(holding);
}

/// In a world the hand says what it takes; without a pointer that is what lies in the middle, or what it held last.
async function grab(holding, pick) {
  if (!pick) return false;
  holding.last = pick;
  return (await holding.page.request({ type: "grab", value: pick.name, point: pick.point })).ok;
}

/// The body that comes once more or goes: the one held last. Of the others one may come, and none goes unasked.
/// type   "add" or "remove"
/// returns   its name; null: there is none
export function bodyToChange(type, { object, statics }, last) {
  const all = [object, ...statics].filter(({ moves }) => moves);
  const like = all.find(({ name }) => name === last?.name) ?? (type === "add" ? all[0] : null);
  return like?.name ?? null;
}

export function setHold({ page: { session, link } }, isOurs) {
  if (session.holding && !isOurs) letGo(link);
  session.holding = isOurs;
}

/// What has been noted goes to the worker, which sends it whatever this page is busy with.
function giveHand({ page: { session, hand, link } }) {
  if (!session.holding || !session.connected) return;
  const samples = takeSamples(hand);
  sendHand(link, samples);
  session.sent += samples.length;
}

/// The hand is where it was, now; that of a headset only its frames can tell.
export function confirmHand(holding) {
  const { session, hand, xr } = holding.page;
  if (!session.holding || holdsXr(xr)) return;
  noteSample(hand, performance.now() / 1000);
  giveHand(holding);
}

/// A page that nobody sees must not hold anything: its timers slow down, and nobody would know what fades and comes back.
export function leaveHold(holding) {
  const { session, link } = holding.page;
  if (!session.holding) return;
  holding.player.letGo();
  setHold(holding, false);
  ask(link, { type: "hold", value: false });
}
