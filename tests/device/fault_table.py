"""What is left of a force of 2 N in contact when something goes wrong, with every driver and its stand-in: one table of the whole program.

    fault_table.py THIGMA STANDINS SCENE [DRIVER ...]

Without THIGMA_FULL one fault a driver and our own death; the others are also tests of the drivers. Times are printed beside what docs/devices.md
states, never judged; that the last force is zero is, and exit code 6, and the reason in the message.
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from device_rig import AXES, DRIVERS, PATIENT, StandIn, patient_scene

program, standins, scene = sys.argv[1:4]
is_whole = bool(os.environ.get("THIGMA_FULL"))

AT_ONCE, SILENT = "10 ms", "60 ms"
NO_CALLS = "silent: no callbacks"  # ends by the watchdog, here of 0.2 s instead of 20 ms
# What happens: name, keys, when zero is stated to be there, a word of the message. Deaf: nothing comes to it any more, its motors have no power.
DEAF = "with it"
FAULTS = {
    "dhd": [("unplugged", {"unplug": 1}, DEAF, "device"), ("error returned", {"fail_read": 2}, AT_ONCE, "reading failed"),
            ("error of a force", {"fail_set": 2}, DEAF, "sending a force failed"),
            ("silent: a call hangs", {"hang": 1, "watchdog": 255}, "32 ms", "watchdog"),
            ("NaN of a pose", {"nan_pose": 1}, AT_ONCE, "not_finite"),
            ("NaN of a velocity", {"nan_velocity": 1}, AT_ONCE, "not_finite"),
            ("jump", {"jump_x": 0.06}, AT_ONCE, "jump"), ("dead man's switch", {"cut": 6}, "the device itself", "dead man")],
    "openhaptics": [("unplugged", {"unplug": 1}, DEAF, "error"), ("error returned", {"fail_read": 0x0302}, AT_ONCE, "error"),
                    (NO_CALLS, {"silent": 1}, "200 ms", "zero force since"), ("NaN", {"nan_pose": 1}, AT_ONCE, "not_finite"),
                    ("jump", {"jump_x": 0.06}, AT_ONCE, "jump")],
    "haply": [("unplugged", {"unplug": 1}, AT_ONCE, "unplugged"), ("no calibration", {"calibrated": 0}, SILENT, "calibration"),
              ("silent", {"silent": 1}, SILENT, "device_lost"), ("NaN", {"nan_pose": 1}, AT_ONCE, "nonsense"),
              ("jump", {"jump_x": 0.03}, AT_ONCE, "jumped"),
              ("garbage", {"garbage": 2}, AT_ONCE, "nonsense"), ("half a frame", {"half": 1}, SILENT, "device_lost"),
              ("connection closed", {"drop": 1}, AT_ONCE, "gone"), ("service killed", {"die": 1}, DEAF, "gone")],
    "vrpn": [("unplugged", {"unplug": 1}, SILENT, "device_lost"), ("silent", {"silent": 1}, SILENT, "device_lost"),
             ("NaN", {"nan_pose": 1}, AT_ONCE, "none"), ("jump", {"jump_x": 0.03}, AT_ONCE, "jumped"),
             ("garbage", {"garbage": 1}, AT_ONCE, "nonsense"),
             ("half a message", {"half": 1}, SILENT, "device_lost"), ("connection closed", {"drop": 1}, AT_ONCE, "gone"),
             ("server killed", {"die": 1}, DEAF, "gone")],
}
# Our process is killed: what the vendor's documents say is left.
KILLED = {"dhd": ("its watchdog: 32 ms at most", {"process": 1}, {"watchdog": 255}),
          "openhaptics": ("none documented: may stay", {"process": 1}, {}),
          "haply": ("its session ends", {"comm_timeout_ms": 0}, {}), "vrpn": ("Phantom's server: zero; others: may stay", {}, {})}


class Session:
    """The program with its handle pressed down until it is pushed back by 2 N."""

    def __init__(self, driver, folder, file, keys):
        self.standin = StandIn(program, standins, driver, folder)
        for key, value in {"buttons": 1, **keys}.items():
            self.standin.set(key, value)
        command = [program, "run", file, "--headless", "--quiet", "--device", self.standin.uri]
        self.said = open(folder / "said.txt", "w+")
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=self.said, env=self.standin.environment())
        self.force = self.press(driver)

    def press(self, driver):
        key = f"target_{AXES[driver['up']]}"
        height, depth, begin = self.standin.get(key), 0.0, time.monotonic()
        while self.process.poll() is None and self.standin.get("sets") < 800 and time.monotonic() < begin + 60:
            time.sleep(0.05)  # armed, ramped up
        while self.process.poll() is None and depth < 0.03:
            depth += 2e-4
            self.standin.set(key, height - depth)
            if self.standin.norm("applied") >= 2.0:
                break
        time.sleep(0.1)
        return self.standin.norm("applied") if self.process.poll() is None else 0.0

    def message(self):
        self.said.seek(0)
        return " ".join(line.split("thigma: ", 1)[-1].strip() for line in self.said if "safety fault" in line)

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.standin.set("linger_s", 0)
        self.standin.__exit__()
        self.said.close()


def pressed(driver, folder, file, keys):
    """On a loaded machine a stale force may push the handle farther than a jump: again then."""
    for _ in range(10):
        session = Session(driver, folder, file, keys)
        if session.force >= 1.5:
            return session
        said = session.message()
        session.close()
    raise AssertionError(f"{driver['name']}: not pressed to 2 N: {said}")


def first_zero(standin, key):
    """How long after that key was set zero was there: sent, or because the device cut it itself [s]; None: never."""
    events = standin.events()
    since = max(at for at, call, _, _ in events if call == f"control: {key}")
    def is_zero(call, values):
        by_itself = call.startswith("device: ") and call != "device: control_mode force"
        return by_itself or (call == standin.driver["sent"] and not any(values[:3]))
    times = [at for at, call, _, values in events if at >= since and is_zero(call, values)]
    return min(times) - since if times else None


def row(driver, name, force, zero, stated, end, said):
    print(f"{driver:12} {name:22} {force:6.2f} N {zero:>12}  {stated:40} {end:8} {said[:110]}", flush=True)


def try_fault(driver, folder, files, fault):
    name, keys, stated, word = fault
    file = files[name == NO_CALLS]
    session = pressed(driver, folder, file, {})
    try:
        for key, value in keys.items():
            session.standin.set(key, value)
        if "hang" in keys:
            time.sleep(0.5)  # a call that never returns cannot be ended from outside
            assert session.standin.norm("applied") == 0.0
            session.standin.set("hang", 0)
        code = session.process.wait(timeout=60)
        said, left = session.message(), session.standin.norm("applied")
        zero = first_zero(session.standin, list(keys)[0])
        is_deaf = stated == DEAF
        text = DEAF if is_deaf else "never" if zero is None else f"{1e3 * zero:.1f} ms"
        row(driver["name"], name, session.force, text, stated, f"exit {code}", said)
        assert code == 6, (name, code, said)
        assert word in said, (name, word, said)
        assert is_deaf or (zero is not None and left == 0.0), (name, zero, left)
    finally:
        session.close()


def try_kill(driver, folder, file):
    stated, before, at_kill = KILLED[driver["name"]]
    session = pressed(driver, folder, file, before)
    try:
        for key, value in at_kill.items():
            session.standin.set(key, value)
        force = session.force
        session.process.send_signal(signal.SIGKILL)
        session.process.wait()
        since = time.monotonic()
        end = since + (1.0 if driver["name"] == "openhaptics" else 10.0)
        while session.standin.norm("applied") > 0.0 and time.monotonic() < end:
            time.sleep(0.001)
        left = session.standin.norm("applied")
        cut = session.standin.get("force_off_time") - (session.standin.get("last_set_time") if driver["name"] == "dhd" else since)
        zero = f"{1e3 * max(0.0, cut):.1f} ms" if left == 0.0 else f"{left:.2f} N stay"
        row(driver["name"], "our process killed", force, zero, stated, "-", "")
        assert (left == 0.0) == (driver["name"] != "openhaptics"), (driver["name"], left)  # what the stand-in takes for the worst
    finally:
        session.close()


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    files = []
    for watchdog in (PATIENT["watchdog"], 0.2):
        place = folder / f"watchdog_{watchdog}"
        place.mkdir()
        files.append(patient_scene(scene, place, {**PATIENT, "watchdog": watchdog}))
    print(f"{'driver':12} {'in contact':22} {'before':>8} {'zero after':>12}  {'stated':40} {'end':8} message")
    for driver in DRIVERS:
        if len(sys.argv) > 4 and driver["name"] not in sys.argv[4:]:
            continue
        for fault in FAULTS[driver["name"]] if is_whole else FAULTS[driver["name"]][1:2]:
            try_fault(driver, folder, files, fault)
        try_kill(driver, folder, files[0])
