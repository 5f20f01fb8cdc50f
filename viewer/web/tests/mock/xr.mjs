// A headset with two controllers for tests, after the WebXR Device API: `navigator.xr`, sessions, frames, poses, events.
// installXr runs in the page before its scripts, so it refers to nothing outside itself. `window.headset` is its remote:
//   modes            what isSessionSupported says
//   pose(hand, {position, quaternion} or null: not tracked, {emulated})   of the grip; "left" or "right"
//   press(hand, "select" or "squeeze", isDown), show(state): visibilityState, stall(bool): no frames, unplug(hand), session
//   pulses           [strength] the motors were told; look(): promise of {left, right}: middle of what is not background, 0 to 1 across
export function installXr() {
  const IPD = 0.064, NEAR = 0.05, FAR = 100;
  const matrixOf = ({ position: [x, y, z], quaternion: [a, b, c, w] }) => new Float32Array([
    1 - 2 * (b * b + c * c), 2 * (a * b + c * w), 2 * (a * c - b * w), 0, 2 * (a * b - c * w), 1 - 2 * (a * a + c * c), 2 * (b * c + a * w), 0,
    2 * (a * c + b * w), 2 * (b * c - a * w), 1 - 2 * (a * a + b * b), 0, x, y, z, 1]);
  const transformOf = (pose) => ({ matrix: matrixOf(pose), position: { x: pose.position[0], y: pose.position[1], z: pose.position[2], w: 1 },
    orientation: { x: pose.quaternion[0], y: pose.quaternion[1], z: pose.quaternion[2], w: pose.quaternion[3] } });
  const lens = (aspect) => { const f = 1 / Math.tan(0.5 * 1.6); return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0,
    0, 0, -(FAR + NEAR) / (FAR - NEAR), -1, 0, 0, (-2 * FAR * NEAR) / (FAR - NEAR), 0]); };

  class Layer {
    constructor(session, gl) {
      Object.assign(this, { gl, framebuffer: null, framebufferWidth: gl.drawingBufferWidth, framebufferHeight: gl.drawingBufferHeight, ignoreDepthValues: false });
    }
    getViewport({ eye }) {
      const half = Math.floor(this.framebufferWidth / 2);
      return { x: eye === "left" ? 0 : half, y: 0, width: half, height: this.framebufferHeight };
    }
  }
  const makeSource = (handedness, pulses) => ({ handedness, targetRayMode: "tracked-pointer", profiles: ["generic-trigger-squeeze-thumbstick"],
    targetRaySpace: {}, gripSpace: {}, gamepad: { mapping: "xr-standard", axes: [0, 0, 0, 0], buttons: [],
      hapticActuators: [{ pulse: async (strength) => { pulses.push(strength); return true; } }] } });

  class Session extends EventTarget {
    constructor(mode) {
      super();
      Object.assign(this, { mode, renderState: {}, visibilityState: "visible", environmentBlendMode: mode === "immersive-ar" ? "alpha-blend" : "opaque",
        enabledFeatures: ["local"], inputSources: [], callbacks: new Map(), nextId: 1, isEnded: false, isStalled: false });
      this.timer = setInterval(() => this.frame(), 20);
    }
    updateRenderState(state) { Object.assign(this.renderState, state); }
    async requestReferenceSpace(type) {
      if (type !== "local" && type !== "viewer") throw new DOMException("no such space", "NotSupportedError");
      return Object.assign(new EventTarget(), { type });
    }
    requestAnimationFrame(callback) {
      this.callbacks.set(this.nextId, callback);
      return this.nextId++;
    }
    cancelAnimationFrame(id) { this.callbacks.delete(id); }
    frame() {
      if (this.isStalled || this.isEnded || !this.renderState.baseLayer) return;
      const { gl } = this.renderState.baseLayer, callbacks = [...this.callbacks.values()];
      this.callbacks.clear();
      for (const callback of callbacks) callback(performance.now(), makeFrame(this));
      const waiting = remote.looking.splice(0);
      if (waiting.length > 0) { const seen = middles(gl); for (const resolve of waiting) resolve(seen); }
    }
    async end() {
      if (this.isEnded) throw new DOMException("ended", "InvalidStateError");
      this.isEnded = true;
      clearInterval(this.timer);
      remote.session = null;
      this.dispatchEvent(new Event("end"));
    }
  }
  function makeFrame(session) {
    const layer = session.renderState.baseLayer, aspect = layer.framebufferWidth / 2 / layer.framebufferHeight;
    return { session,
      getViewerPose: () => ({ transform: transformOf({ position: [0, 0, 0], quaternion: [0, 0, 0, 1] }), emulatedPosition: false,
        views: ["left", "right"].map((eye, k) => ({ eye, projectionMatrix: lens(aspect),
          transform: transformOf({ position: [(k - 0.5) * IPD, 0, 0], quaternion: [0, 0, 0, 1] }) })) }),
      getPose: (space) => {
        const hand = Object.keys(remote.sources).find((name) => remote.sources[name].gripSpace === space);
        const pose = remote.poses[hand];
        return pose ? { transform: transformOf(pose), emulatedPosition: Boolean(pose.emulated) } : null;
      } };
  }
  /// Where in each half what is not the colour of a corner lies on average.
  function middles(gl) {
    const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, half = Math.floor(w / 2), data = new Uint8Array(4 * w * h);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
    const eye = (begin) => {
      let n = 0, x = 0, y = 0;
      for (let row = 0; row < h; row += 2) for (let column = 0; column < half; column++) {
        const at = 4 * (row * w + begin + column);
        if ([0, 1, 2, 3].every((k) => Math.abs(data[at + k] - data[k]) < 12)) continue;
        n += 1; x += column; y += row;
      }
      return { n, x: x / n / half, y: y / n / h };
    };
    return { left: eye(0), right: eye(half), back: [...data.subarray(0, 4)] };
  }
  const remote = window.headset = { modes: ["immersive-vr"], session: null, refuses: false, sources: {}, poses: {}, pulses: [], looking: [],
    pose: (hand, pose, more = {}) => { remote.poses[hand] = pose && { quaternion: [0, 0, 0, 1], ...pose, ...more }; },
    press: (hand, what, isDown) => {
      const event = Object.assign(new Event(`${what}${isDown ? "start" : "end"}`), { inputSource: remote.sources[hand] });
      remote.session.dispatchEvent(event);
    },
    show: (state) => { remote.session.visibilityState = state; remote.session.dispatchEvent(new Event("visibilitychange")); },
    stall: (is) => { remote.session.isStalled = is; },
    unplug: (hand) => {
      const removed = [remote.sources[hand]];
      remote.session.inputSources = remote.session.inputSources.filter((one) => one !== removed[0]);
      remote.session.dispatchEvent(Object.assign(new Event("inputsourceschange"), { added: [], removed }));
    },
    look: () => new Promise((resolve) => remote.looking.push(resolve)) };
  Object.defineProperty(navigator, "xr", { configurable: true, value: {
    isSessionSupported: async (mode) => remote.modes.includes(mode),
    requestSession: async (mode) => {
      if (remote.refuses) throw new DOMException("the headset is in use", "InvalidStateError");
      remote.session = new Session(mode);
      remote.sources = { left: makeSource("left", remote.pulses), right: makeSource("right", remote.pulses) };
      remote.session.inputSources = Object.values(remote.sources);
      return remote.session;
    } } });
  Object.assign(window, { XRWebGLLayer: Layer, XRWebGLBinding: undefined });
  WebGL2RenderingContext.prototype.makeXRCompatible = async () => {};
}
