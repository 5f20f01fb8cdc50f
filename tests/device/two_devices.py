"""Two people in one world, with the stand-ins of their devices: they press to 2 N each, then one has a fault. Both end at zero force.

    two_devices.py THIGMA STANDINS

Without THIGMA_FULL one fault a pair. Each pair also lets go in order, and what was recorded replays bit for bit without a device.
"""
import contextlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from device_rig import AXES, DRIVERS, PATIENT, StandIn

program, standins = sys.argv[1:3]
is_whole = bool(os.environ.get("THIGMA_FULL"))
BY_NAME = {driver["name"]: driver for driver in DRIVERS}
PAIRS = [("haply", "vrpn"), ("dhd", "openhaptics")]
# Of the first or the second of a pair: name, whose, keys, a word of the message.
FAULTS = {
    ("haply", "vrpn"): [("unplugged", 0, {"unplug": 1}, "unplugged"), ("server killed", 1, {"die": 1}, "gone"),
                        ("NaN", 0, {"nan_pose": 1}, "nonsense"), ("jump", 1, {"jump_x": 0.03}, "jumped")],
    ("dhd", "openhaptics"): [("read hangs", 0, {"hang": 1, "watchdog": 255}, "without a haptic step"),
                             ("unplugged", 1, {"unplug": 1}, "error"), ("error returned", 0, {"fail_read": 2}, "reading failed"),
                             ("NaN", 1, {"nan_pose": 1}, "not_finite"), ("no callbacks", 1, {"silent": 1}, "without a haptic step")],
}
SCENE = """
gravity = [0.0, 0.0, 0.0]
[safety]
{safety}
[[static]]
name = "table"
mesh = "procedural:box?triangles=12"
unit_scale = 10.0
position = [0.0, 0.0, -0.2]
"""
HAND = """
[[body]]
kind = "held"
name = "{name}"
mesh = "procedural:box?triangles=12"
position = [{x}, 0.0, 0.03]
density = 500.0
[[device]]
holds = "{name}"
uri = "{uri}"
"""


class Session:
    def __init__(self, pair, folder, watchdog, words=()):
        self.stack = contextlib.ExitStack()
        self.standins = [self.stack.enter_context(StandIn(program, standins, BY_NAME[name], folder)) for name in pair]
        safety = {**PATIENT, "watchdog": watchdog}
        text = SCENE.format(safety="\n".join(f"{key} = {value}" for key, value in safety.items()))
        environment, paths = dict(os.environ), []
        for i, standin in enumerate(self.standins):
            standin.set("buttons", 1)
            text += HAND.format(name=f"block {i + 1}", x=0.1 * i, uri=standin.uri)
            own = standin.environment()
            if "library" in standin.driver:
                paths.append(own["LD_LIBRARY_PATH"])
            environment.update({key: value for key, value in own.items() if key.startswith("STANDIN_")})
        environment["LD_LIBRARY_PATH"] = ":".join(paths)
        file = folder / "two.toml"
        file.write_text(text)
        self.said, self.told = open(folder / "said.txt", "w+"), open(folder / "told.txt", "w+")
        command = [program, "run", str(file), "--headless", "--quiet", "--json", *words]
        self.process = subprocess.Popen(command, stdout=self.told, stderr=self.said, env=environment)

    def forces(self):
        return [standin.norm("applied") for standin in self.standins]

    def press(self):
        """Both handles go down until each is pushed back by about 2 N; whether they are."""
        up = [f"target_{AXES[standin.driver['up']]}" for standin in self.standins]
        height = [standin.get(key) for standin, key in zip(self.standins, up)]
        begin = time.monotonic()
        while self.process.poll() is None and time.monotonic() < begin + 60 and any(s.get("sets") < 800 for s in self.standins):
            time.sleep(0.05)  # armed, ramped up
        depth = [0.0, 0.0]
        while self.process.poll() is None and max(depth) < 0.06:
            forces = self.forces()
            if min(forces) >= 1.5:
                return True
            for i, standin in enumerate(self.standins):
                if forces[i] < 2.0:
                    depth[i] += 2e-4
                    standin.set(up[i], height[i] - depth[i])
            time.sleep(0.01)
        return False

    def end(self):
        code = self.process.wait(timeout=60)
        for file in (self.said, self.told):
            file.seek(0)
        told = self.told.read()
        return code, self.said.read(), json.loads(told.splitlines()[-1]) if told else {}

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for standin in self.standins:
            standin.set("linger_s", 0)
        self.stack.close()
        self.said.close()
        self.told.close()


def pressed(pair, folder, watchdog, words=()):
    """On a loaded machine a stale force may push a handle farther than a jump: again then."""
    for _ in range(10):
        session = Session(pair, folder, watchdog, words)
        if session.press():
            return session
        session.process.terminate()
        said = session.end()[1]
        session.close()
    raise AssertionError(f"{pair}: not pressed to 2 N: {said}")


def row(pair, name, before, after, code, said):
    forces = " ".join(f"{before[i]:5.2f} -> {after[i]:.2f} N" for i in range(2))
    print(f"{'+'.join(pair):18} {name:16} {forces:36} exit {code}  {said.strip()[:140]}", flush=True)


def try_fault(pair, folder, fault):
    name, whose, keys, word = fault
    session = pressed(pair, folder, 1.0 if word == "without a haptic step" else PATIENT["watchdog"])
    try:
        before = session.forces()
        for key, value in keys.items():
            session.standins[whose].set(key, value)
        if "hang" in keys:
            # The other is let go while the call hangs, which cannot be ended from outside.
            end = time.monotonic() + 10
            while session.forces()[1 - whose] > 0.0 and time.monotonic() < end:
                time.sleep(0.005)
            assert session.forces()[1 - whose] == 0.0, session.forces()
            session.standins[whose].set("hang", 0)
        code, said, _ = session.end()
        after = session.forces()
        row(pair, name, before, after, code, said)
        assert code == 6, (code, said)
        assert f"hand {whose + 1} (" in said and word in said, said
        assert after[1 - whose] == 0.0, after
        is_deaf = "unplug" in keys or "die" in keys  # it has no power
        assert is_deaf or after[whose] == 0.0, after
    finally:
        session.close()


def try_recording(pair, folder):
    recording = folder / "two.mcap"
    recording.unlink(missing_ok=True)
    session = pressed(pair, folder, PATIENT["watchdog"], ("--record", str(recording)))
    try:
        before = session.forces()
        session.process.terminate()
        code, said, summary = session.end()
        row(pair, "told to stop", before, session.forces(), code, said)
        assert code == 130, (code, said)
        assert session.forces() == [0.0, 0.0], session.forces()
        assert all(hand["haptic"]["force_max"] > 1.0 for hand in summary["hands"]), summary["hands"]
    finally:
        session.close()
    again = subprocess.run([program, "replay", str(recording), "--json"], capture_output=True, text=True)
    found = json.loads(again.stdout)
    assert found["identical"] and found["haptic"]["frames"] > 1000, (found, again.stderr)


def try_lockstep(folder):
    """No watchdog there: one line, and nothing is opened."""
    file = folder / "two.toml"
    file.write_text(SCENE.format(safety="") + HAND.format(name="block", x=0.0, uri="hand:"))
    for uri in ("dhd:0", "haply:?port=1", "hand:?camera=spacenav:"):
        done = subprocess.run([program, "run", str(file), "--lockstep", "--headless", "--duration", "0.1", "--device", uri],
                              capture_output=True, text=True)
        lines = done.stderr.strip().splitlines()
        assert done.returncode == 3 and "not in lockstep" in lines[-1] and uri.split(":")[0] + ": " in lines[-1], (uri, done)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    try_lockstep(folder)
    for pair in PAIRS:
        for fault in FAULTS[pair] if is_whole else FAULTS[pair][:1]:
            try_fault(pair, folder, fault)
        try_recording(pair, folder)
