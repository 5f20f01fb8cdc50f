// A made-up session for the page's tests: two blocks with matching bumps, one in the hand. No dynamics: the object is where
// the hand would have it, lifted until it barely touches, and the spring between the two is the force.

const N = 48, SIZE = 0.06, THICK = 0.012, BUMP = 0.0022, WAVES = 5;
const SPRING = 500, CONTACT = 5000; // [N/m]
const REACH = 0.0004;               // contacts begin at this distance [m]

const height = (x, y) => BUMP * Math.cos((2 * Math.PI * WAVES * x) / SIZE) * Math.cos((2 * Math.PI * WAVES * y) / SIZE);

/// A block with bumps on one side and a hierarchy: patches of 2 x 2 cells, each level merging 2 x 2 below.
/// level   0, or up to SIMPLIFIED: a coarser surface, without a tree, its patches named by the nodes of the tree
export function makeBlock(upper, level = 0) {
  const M = N >> level, positions = [], triangles = [], patchOfTriangle = [];
  const at = (i, j, side) => side * (M + 1) * (M + 1) + j * (M + 1) + i;
  for (const flat of [false, true]) {
    for (let j = 0; j <= M; j++) for (let i = 0; i <= M; i++) {
      const x = SIZE * (i / M - 0.5), y = SIZE * (j / M - 0.5);
      positions.push(x, y, flat ? (upper ? THICK : -THICK) : height(x, y));
    }
  }
  const half = M / 2;
  const add = (a, b, c, turned, patch) => { triangles.push(...(turned ? [a, c, b] : [a, b, c])); patchOfTriangle.push(patch); };
  for (let j = 0; j < M; j++) for (let i = 0; i < M; i++) {
    const patch = (j >> 1) * half + (i >> 1);
    for (const side of [0, 1]) {
      const [a, b, c, d] = [at(i, j, side), at(i + 1, j, side), at(i + 1, j + 1, side), at(i, j + 1, side)];
      const turned = (side === 0) === upper;
      add(a, b, c, turned, side === 0 ? patch : 0xffffffff);
      add(a, c, d, turned, side === 0 ? patch : 0xffffffff);
    }
  }
  for (let k = 0; k < M; k++) for (const [i, j, di, dj] of [[k, 0, 1, 0], [k + 1, M, -1, 0], [M, k, 0, 1], [0, k + 1, 0, -1]]) {
    const [a, b] = [at(i, j, 0), at(i + di, j + dj, 0)], [c, d] = [at(i, j, 1), at(i + di, j + dj, 1)];
    add(a, d, b, upper, 0xffffffff);
    add(a, c, d, upper, 0xffffffff);
  }
  if (level === 0) return { positions, triangles, patchOfTriangle, ...makeTree(half) };
  let begin = 0;
  for (let k = 0, n = N / 2; k < level; k++, n = Math.ceil(n / 2)) begin += n * n;
  return { positions, triangles, patchOfTriangle, nodeOfPatch: Array.from({ length: half * half }, (_, patch) => begin + patch) };
}

const SIMPLIFIED = 3; // levels 1 to 3 have surfaces of their own, 4 and 5 are free

/// As in `scene`.
export function levelList() {
  return Array.from({ length: 6 }, (_, level) => {
    const free = level > SIMPLIFIED, n = Math.ceil(N / 2 / 2 ** level);
    return { free, triangles: free ? 0 : makeBlock(true, level).triangles.length / 3, patches: n * n, deviation: free ? null : 2e-5 * 4 ** level };
  });
}

function makeTree(side) {
  const parents = [], levels = [];
  let begin = 0;
  for (let level = 0, n = side; ; level++, n = Math.ceil(n / 2)) {
    for (let k = 0; k < n * n; k++) levels.push(level);
    const above = begin + n * n, wide = Math.ceil(n / 2);
    for (let k = 0; k < n * n; k++) parents.push(n === 1 ? -1 : above + ((Math.floor(k / n) >> 1) * wide + ((k % n) >> 1)));
    begin = above;
    if (n === 1) break;
  }
  return { nodeOfPatch: Array.from({ length: side * side }, (_, k) => k), parents, levels };
}

export const START = { position: [0, 0, 0.012], quat_xyzw: [0, 0, 0, 1] };
const GRASP = [0, 0, THICK]; // of the mesh frame

export function makeWorld() {
  return { time: 0, frame: 0, hand: null, grasped: false, armed: false, fault: 0, energy: 0, anchor: null, object: [...START.position],
    turn: [...START.quat_xyzw], ghost: [...START.position], ghostTurn: [...START.quat_xyzw], lift: 0, spring: SPRING,
    constrained: false, bits: 0 };
}

function rotate([x, y, z, w], [a, b, c]) {
  const t = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * t[0] + y * t[2] - z * t[1], b + w * t[1] + z * t[0] - x * t[2], c + w * t[2] + x * t[1] - y * t[0]];
}
function times(a, b) {
  return [a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]];
}

/// The simulated hand: down, a slide, a twist, up again.
export function scriptedHand(time) {
  const phase = (time % 8) / 8;
  const ramp = (a, b) => Math.max(0, Math.min(1, (phase - a) / (b - a)));
  const smooth = (u) => u * u * (3 - 2 * u);
  const down = smooth(ramp(0.02, 0.2)) - smooth(ramp(0.85, 0.97));
  const slide = Math.sin(2 * Math.PI * ramp(0.25, 0.75));
  return { position: [0.006 * slide, 0.003 * slide * slide, -0.0135 * down - 0.0006 * down * Math.sin(40 * time)],
    quaternion: [0, 0.03 * slide * down, 0, Math.sqrt(1 - (0.03 * slide * down) ** 2)], clutch: true };
}

/// One haptic frame of a millisecond.
export function stepWorld(world) {
  world.time += 0.001;
  world.frame += 1;
  const hand = world.hand;
  const pressed = Boolean(hand?.clutch) && world.fault === 0;
  if (pressed && !world.grasped) world.anchor = { hand: [...hand.position], turn: [...hand.quaternion], at: [...world.object], own: [...world.turn] };
  world.grasped = pressed;
  world.armed = pressed;
  if (pressed) {
    world.ghost = world.anchor.at.map((value, k) => value + hand.position[k] - world.anchor.hand[k]);
    const [x, y, z, w] = world.anchor.turn;
    world.ghostTurn = times(times(hand.quaternion, [-x, -y, -z, w]), world.anchor.own);
    const before = world.lift;
    const deepest = findContacts(world, world.ghost, world.ghostTurn).reduce((most, c) => Math.max(most, c.depth), -1);
    world.lift = Math.max(0, world.constrained ? deepest : (deepest * CONTACT) / (CONTACT + world.spring));
    world.energy += world.spring * world.lift * (world.lift - before);
    world.object = [world.ghost[0], world.ghost[1], world.ghost[2] + world.lift];
    world.turn = world.ghostTurn;
  } else {
    world.ghost = [...world.object];
    world.ghostTurn = [...world.turn];
    world.lift = 0;
  }
}

/// Bumps of the object near the lower block, coarse ones when it moves fast.
export function findContacts(world, position, turn) {
  const contacts = [];
  const half = N / 2;
  for (let j = 1; j < half - 1; j += 2) for (let i = 1; i < half - 1; i += 2) {
    const x = SIZE * ((2 * i + 1) / N - 0.5), y = SIZE * ((2 * j + 1) / N - 0.5);
    const point = rotate(turn, [x, y, height(x, y)]).map((value, k) => value + position[k]);
    if (Math.abs(point[0]) > SIZE / 2 || Math.abs(point[1]) > SIZE / 2) continue;
    const depth = height(point[0], point[1]) - point[2];
    if (depth < -REACH) continue;
    contacts.push({ point, normal: [0, 0, -1], depth, bound: 0, body: 0, patch: j * half + i, status: depth > 0 ? 1 : 0 });
  }
  return contacts.sort((a, b) => b.depth - a.depth).slice(0, 128);
}

const levelOf = (contact) => (contact.point[0] > 0.012 ? 2 : contact.point[0] > -0.008 ? 1 : 0);

function ancestor(patch, level) {
  let node = patch, n = N / 2, begin = 0;
  for (let k = 0; k < level; k++) {
    const wide = Math.ceil(n / 2), local = node - begin;
    begin += n * n;
    node = begin + (Math.floor(local / n) >> 1) * wide + ((local % n) >> 1);
    n = wide;
  }
  return node;
}

/// What `encodeSnapshot` takes.
export function snapshotOf(world, paused) {
  const contacts = findContacts(world, world.object, world.turn).map((c) => ({ ...c, objectLevel: levelOf(c), sceneLevel: levelOf(c),
    objectNode: ancestor(c.patch, levelOf(c)), sceneNode: ancestor(c.patch, levelOf(c)) }));
  const force = world.spring * world.lift;
  const clusters = contacts.slice(0, 4).map((c, id) => ({ ...c, force: [0, 0, force / Math.min(4, contacts.length)], id }));
  const grasp = rotate(world.turn, GRASP).map((value, k) => value + world.object[k]);
  const handle = rotate(world.ghostTurn, GRASP).map((value, k) => value + world.ghost[k]);
  const torque = torqueOf(world, contacts, force);
  const bits = (world.grasped ? 1 : 0) | (world.armed ? 2 : 0) | (world.fault ? 4 : 0) | (paused ? 8 : 0) | (world.constrained ? 256 : 0) | world.bits;
  const penetration = contacts.length > 0 ? contacts[0].depth : NaN;
  const fields = [...world.object, ...world.turn, ...world.ghost, ...world.ghostTurn, ...handle, ...world.ghostTurn, ...grasp,
    0, 0, force, ...torque, 0, 0, force, ...torque, ...world.object, penetration, world.lift, world.energy, 0.0021, 1, 1000,
    420 + 30 * Math.sin(world.time), 0.00118, 0.03];
  return { time: world.time, bits, frame: world.frame, fields, found: contacts.length, dropped: 0, front: 900 + contacts.length,
    fault: world.fault, contacts, clusters: world.constrained ? [] : clusters, rows: world.constrained ? rowsOf(contacts, force) : [] };
}

/// The nearest contacts as rows, of every kind, the first three pressing within their cones, the first at its edge.
function rowsOf(contacts, force) {
  const pressing = force > 0 ? Math.min(3, contacts.length) : 0;
  return contacts.slice(0, 12).map((c, k) => {
    const share = force / Math.max(1, pressing), across = k === 0 ? 0.3 * share : 0.1 * share;
    return { point: c.point, normal: c.normal, gap: Math.max(0, -c.depth), force: k < pressing ? [across, 0, share] : [0, 0, 0], friction: 0.3,
      kind: k % 3, presses: k < pressing };
  });
}

/// Of `state`, over the last second.
export const constraintOf = (world) => (world.constrained ? { rows: 12, in_model: 12, halvings: 0, left_out: 0, travel: 0.0003, look_ahead: 0.00032,
  held_back: world.bits & 64 ? 0.2 : 0, squeezed: world.bits & 128 ? 0.5 : 0 } : null);

function torqueOf(world, contacts, force) {
  if (contacts.length === 0) return [0, 0, 0];
  const mean = [0, 1].map((k) => contacts.reduce((sum, c) => sum + c.point[k], 0) / contacts.length - world.object[k]);
  return [mean[1] * force, -mean[0] * force, 0];
}

export function rowOf(world, start) {
  const force = world.spring * world.lift;
  return [world.time - start, 0, 0.04 * force * Math.sin(60 * world.time), force * (1 + 0.01 * Math.sin(300 * world.time)),
    0.002 * force, -0.0012 * force, 0, world.lift > 0 ? force / CONTACT : NaN, world.lift, world.energy,
    0.002 + 0.0008 * Math.sin(20 * world.time), 2e-6, 6e-5, 0, world.lift > 0 ? 4 : 0,
    (world.grasped ? 1 : 0) + (world.armed ? 2 : 0) + (world.fault ? 4 : 0)];
}
