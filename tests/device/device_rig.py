"""Drivers with force and their stand-ins, for tables of the whole program."""
import csv
import json
import os
import pathlib
import re
import subprocess
import time

AXES = "xyz"


def cyclic(v):  # x right, y up, z to the person
    return [v[2], v[0], v[1]]


# ours: our axes from the vendor's; up: which of the vendor's axes is; sent: how the record calls a force.
DRIVERS = [
    {"name": "dhd", "uri": "dhd:0", "library": "drd", "keys": {"velocity_threshold": 0, "watchdog": 0}, "ours": list, "up": 2,
     "sent": "dhdSetForceAndTorqueAndGripperForce"},
    {"name": "openhaptics", "uri": "openhaptics:", "library": "hd", "keys": {"velocity_check": 0}, "ours": cyclic, "up": 1,
     "sent": "hdEndFrame"},
    {"name": "haply", "uri": "haply:?port={port}", "service": "haply", "words": ["--events-port", "0"], "keys": {},
     "ours": lambda v: [-v[1], v[0], v[2]], "up": 2, "sent": "set_cursor_force"},
    {"name": "vrpn", "uri": "vrpn:Haptic0@localhost:{port}", "service": "vrpn", "words": [], "keys": {}, "ours": cyclic, "up": 1,
     "sent": "Force_Field", "share": 1e-7},
]


class StandIn:
    """A board, and the process where the stand-in is one."""

    def __init__(self, program, standins, driver, folder):
        self.program, self.standins = program, standins
        self.driver, self.board = driver, folder / f"{driver['name']}_{time.monotonic_ns()}.board"
        self.process = None
        self.control("new")
        for key, value in driver["keys"].items():
            self.set(key, value)
        uri = driver["uri"]
        if "service" in driver:
            command = [f"{self.standins}/standin_{driver['service']}", str(self.board), *driver["words"]]
            self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
            assert self.process.stdout.readline().startswith("listening"), command
            uri = uri.format(port=int(self.get("port")))
        self.uri = uri

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process:
            self.process.kill()
            self.process.wait()

    def control(self, *words):
        command = [f"{self.standins}/standin_control", str(self.board), *map(str, words)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    def set(self, key, value):
        self.control("set", key, value)

    def get(self, key):
        return float(self.control("get", key))

    def environment(self):
        environment = dict(os.environ)
        if "library" in self.driver:
            environment["LD_LIBRARY_PATH"] = f"{self.standins}/{self.driver['library']}"
            environment[f"STANDIN_{self.driver['library'].upper()}_BOARD"] = str(self.board)
        return environment

    def run(self, *words):
        done = subprocess.run([self.program, *words, "--json"], capture_output=True, text=True, env=self.environment())
        return done.returncode, (json.loads(done.stdout.splitlines()[-1]) if done.stdout else {}), done.stderr

    def norm(self, what):
        return sum(self.get(f"{what}_f{axis}") ** 2 for axis in AXES) ** 0.5

    def events(self):
        """The record: (time [s; CLOCK_MONOTONIC], call, code, values)."""
        log = self.board.with_suffix(".csv")
        self.control("log", log)
        with open(log) as lines:
            rows = csv.reader(line for line in lines if not line.startswith("#"))
            # A call may have a comma in its text; a code and seven numbers stand behind it.
            return [(float(row[1]), ",".join(row[3:-8]), int(row[-8]), [float(value) for value in row[-7:]])
                    for row in rows if row[0].isdigit()]

    def forces(self):
        """Every force that was sent, in order [N; our axes]."""
        return [self.driver["ours"](values[:3]) for _, call, _, values in self.events() if call == self.driver["sent"]]


# Numbers of `[safety]` that a loaded machine keeps: a session may be late beside other programs.
PATIENT = {"watchdog": 2.0, "model_full_age": 2.0, "model_stale_age": 4.0, "rows_full_age": 2.0,
           "rows_stale_age": 4.0, "max_speed": 5.0, "pose_jump": 0.03, "max_turn_speed": 100.0,
           "orientation_jump": 1.0}


def distance(a, b):
    return max(abs(p - q) for p, q in zip(a, b))


def patient_scene(scene, folder, limits):
    """The scene with other numbers of `[safety]`."""
    text = pathlib.Path(scene).read_text()
    for key, value in limits.items():
        text, count = re.subn(rf"(?m)^{key} = [0-9.]+", f"{key} = {value}", text)
        assert count == 1, key
    file = folder / "scene.toml"
    file.write_text(text)
    return str(file)
