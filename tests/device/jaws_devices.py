"""The jaws in a hand of every driver with force, against its stand-in: one table.

    jaws_devices.py THIGMA STANDINS SCENE [SECONDS [DRIVER ...]]

SECONDS a driver, 4 or with THIGMA_FULL 60. Times are printed, never judged: a session may be late beside other programs, so its
limits of time are those of `PATIENT`; the empty loop of the same minute stands beside it.
"""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

from device_rig import AXES, DRIVERS, PATIENT, StandIn, distance, patient_scene

program, standins, scene = sys.argv[1:4]
seconds = float(sys.argv[4]) if len(sys.argv) > 4 else 60.0 if os.environ.get("THIGMA_FULL") else 4.0

TOLERANCE = 1e-6  # of force asked against force received [N]; a VRPN field is of 32-bit numbers: 2e-7 at 3 N


def asked_forces(recording, folder):
    table = folder / "session.csv"
    subprocess.run([program, "export", recording, "-o", str(table), "--quiet"], check=True, capture_output=True)
    with open(table) as lines:
        return [[float(row[f"command f{axis} [N]"]) for axis in AXES] for row in csv.DictReader(lines)]


def compare(asked, received, share):
    """How far the forces that came are off those that were asked for, in their order: a service is told the
    newest one, some twice and some never. Zero may come between at any time.

    share    of a force, to which numbers are rounded on the way
    returns  the largest distance [N], and how many that are not zero came
    """
    worst, count, place = 0.0, 0, 0
    for force in received:
        if max(map(abs, force)) == 0.0:
            continue
        count += 1
        near = range(place, min(place + 1000, len(asked)))
        rounding = share * max(map(abs, force))
        best = next((k for k in near if distance(asked[k], force) <= rounding), None)
        if best is None:
            best = min(near, key=lambda k: distance(asked[k], force), default=None)
        if best is None:
            return float("inf"), count
        worst, place = max(worst, distance(asked[best], force)), best
    return worst, count


def six_poses(driver, folder):
    """Moves the handle by 10 mm to and fro along each of the vendor's axes; the columns of ours from theirs."""
    columns = []
    for axis in range(3):
        ways = []
        for sign in (1.0, -1.0):
            with StandIn(program, standins, driver, folder) as standin:
                standin.set("hold", 1)
                for other in AXES:
                    standin.set(f"target_{other}", 0)
                standin.set(f"target_{AXES[axis]}", sign * 0.01)
                standin.set("buttons", 5)
                code, found, said = standin.run("devices", "check", standin.uri, "--duration", "0.3", "--quiet")
                assert code == 0, said
                assert found["buttons"] == 5, (driver["name"], found["buttons"])
                ways.append([sign * 100.0 * 0.5 * (low + high) for low, high in zip(found["least"], found["greatest"])])
        column = [0.5 * (a + b) for a, b in zip(*ways)]
        unit = [0.0, 0.0, 0.0]
        unit[axis] = 1.0
        wanted = driver["ours"](unit)
        assert all(distance(way, wanted) < 1e-2 for way in ways), (driver["name"], axis, ways)
        columns.append(column)
    a, b, c = columns
    volume = sum(a[i] * (b[j] * c[k] - b[k] * c[j]) for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))
    assert abs(volume - 1.0) < 1e-2, (driver["name"], columns)  # right-handed
    return columns


def session(driver, folder, file, seconds, hertz, amplitude):
    with StandIn(program, standins, driver, folder) as standin:
        standin.set("buttons", 1)
        for key, value in {"sweep_amplitude": amplitude, "sweep_hz": hertz, "sweep_axis": driver["up"]}.items():
            standin.set(key, value)
        recording = str(folder / f"{driver['name']}.mcap")
        code, found, said = standin.run("run", file, "--headless", "--device", standin.uri, "--duration", str(seconds),
                                        "--record", recording)
        assert code == 0, f"{driver['name']}: exit {code}\n{said}"
        at_end = [standin.get(f"last_f{axis}") for axis in AXES]
        assert max(map(abs, at_end)) == 0.0, at_end
        code, replayed, said = standin.run("replay", recording)
        assert code == 0 and replayed["identical"], (driver["name"], replayed, found["dropped_samples"], said)
        asked, received = asked_forces(recording, folder), standin.forces()
        worst, count = compare(asked, received, driver.get("share", 1e-11))
        assert worst <= TOLERANCE, (driver["name"], worst)
        assert count > 0.2 * sum(max(map(abs, force)) > 0.0 for force in asked), (driver["name"], count)
        return found, worst, count


def milliseconds(quantiles):
    return " ".join(f"{1e-3 * (quantiles or {}).get(name, 0.0):7.2f}" for name in ("p50", "p99", "max"))


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    file = patient_scene(scene, folder, {**PATIENT, "silent_device": 1.0})
    head = (f"{'driver':12} {'s':>5} {'Hz':>6} {'late ms p50, p99, max':>23} {'missed':>7} | {'empty: late ms p50, p99, max':>28} {'missed':>7} "
            f"| {'most N':>6} {'came':>6} {'off N':>8} {'least J':>9} | poses buttons replay")
    print(head)
    for driver in DRIVERS:
        if len(sys.argv) > 5 and driver["name"] not in sys.argv[5:]:
            continue
        six_poses(driver, folder)
        # Where a service's handle is in its sweep when it is taken hold of decides how far down the object gets: at the
        # bottom not at all.
        for longer, hertz, amplitude in ((1, 0.5, 0.006), (1, 0.37, 0.009), (2, 0.71, 0.009), (2, 0.23, 0.012)):
            found, worst, count = session(driver, folder, file, longer * seconds, hertz, amplitude)
            if found["force"]["max"] > 0.05:
                break
        haptic, floor = found["haptic"], found["haptic"]["floor"]
        assert found["force"]["max"] > 0.05, found["force"]
        share = 100.0 * haptic["missed"] / max(1, haptic["missed"] + haptic["frames"])
        rate = haptic["frames"] / found["seconds"]
        print(f"{driver['name']:12} {found['seconds']:5.1f} {rate:6.0f} {milliseconds(haptic['wake_late_us'])} {share:6.1f}% | "
              f"     {milliseconds(floor['wake_late_us'])} {100.0 * floor['missed'] / max(1, floor['ticks']):6.1f}% | {found['force']['max']:6.2f} {count:6d} "
              f"{worst:8.1e} {found['energy_min']:9.1e} | 6 of 6 0,2    same", flush=True)
