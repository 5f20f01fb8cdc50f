// What to say over the picture at this moment: the guided start, and whatever keeps the hand from feeling.
import { endWords, faultWords, lateWords } from "./words.js";

export function makeGuide() {
  return { step: 0, turned: false, unarmedSince: null, touchedAt: null };
}

/// session   as in main; facts {mayMove, holding, clutch, now [s], newtons, turned, touch: the hand is a finger}
/// returns   {text, button, act, mood} or null
export function guideLine(guide, session, facts, act) {
  const { state, scene, snapshot } = session;
  if (!session.connected || !state || !scene || !snapshot) return null;
  const object = scene.object.name;
  const fading = (snapshot.bits & 32) !== 0, grasped = (snapshot.bits & 1) !== 0, armed = (snapshot.bits & 2) !== 0, fault = (snapshot.bits & 4) !== 0;
  if (session.progress) return null;
  const watches = session.hello?.may_control === false;
  if (state.run === "ended") {
    return { text: `The session ${endWords(state) ?? "has ended"}.`, button: watches ? undefined : "Begin again", act: act.reset, mood: "stop" };
  }
  if (session.refusal && facts.now < session.refusal.until) return { text: session.refusal.text, mood: "stop" };
  if (watches) return { text: "This page watches. To do more, open the address with its token, as the program has printed it." };
  if (state.replay) {
    return { text: `A recording: ${state.replay.file.split("/").pop()}`, button: state.devices.includes("web:") ? "Take it yourself" : undefined,
      act: () => act.device("web:") };
  }
  if (fault) {
    const web = state.device.startsWith("web:");
    return { text: `Forces are off: ${faultWords(session.faultName())}.${web ? ` Take hold of the ${object} again to go on.` : ""}`,
      button: web ? undefined : "Begin again", act: act.reset, mood: "stop" };
  }
  const late = lateWords(state.late, snapshot.time);
  if (late) return { text: late, mood: "stop" };
  if (!state.device.startsWith("web:")) {
    if (!state.devices.includes("web:")) return null;
    return { text: `A ${state.simulated === false ? "device" : "simulated hand"} moves the ${object}.`, button: "Take it yourself",
      act: () => act.device("web:"), icon: "hand" };
  }
  if (state.holder === "other") return { text: "Another page holds the hand; this one watches." };
  if (scene.world) return worldHand(facts);
  return ownHand(guide, { object, grasped, armed, fading, snapshot, scene, ...facts });
}

/// In a world the hand takes whatever it presses on; what it lets go of falls or flies.
function worldHand({ holding, touch }) {
  if (!holding) return { text: touch ? "Touch a body and drag it; let go to drop or throw it." : "Press on a body and drag it; let go to drop or throw it.", icon: "hand" };
  return { text: touch ? "Two fingers turn it; spread them to move it away." : "Shift-drag or the wheel moves it away, Ctrl-drag turns it." };
}

function ownHand(guide, facts) {
  const { object, grasped, armed, now, newtons } = facts;
  if (!grasped || !facts.holding) {
    guide.unarmedSince = null;
    return { text: `Drag the blue ${object}.`, icon: "hand" };
  }
  if (armed) guide.unarmedSince = null;
  else guide.unarmedSince ??= now;
  if (!armed && now - guide.unarmedSince > 0.6) {
    return { text: `Taken hold of inside a contact: lift the ${object} off once, then forces come on.` };
  }
  if (facts.fading) return { text: "This page is slow: the force fades until it keeps up, and comes back by itself." };
  if (newtons > 0) guide.touchedAt ??= now;
  if (guide.touchedAt === null) {
    const target = facts.scene.statics[0]?.name ?? "scene";
    const deeper = facts.touch ? "spread two fingers to move it away" : "Shift-drag or the wheel moves it deeper";
    return { text: `Press it against the ${target}: ${deeper}. The arrow will be the force in your hand.` };
  }
  if (!guide.turned && facts.turned) guide.turned = true;
  if (!guide.turned && now - guide.touchedAt < 12) {
    return { text: facts.touch ? "Two fingers turn it. A finger beside it turns the view." : "Ctrl-drag turns it. Space lets go. Right-drag turns the view." };
  }
  return null;
}
