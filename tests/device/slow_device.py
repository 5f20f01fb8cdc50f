"""A device that is slower than the haptic rate is said so, and `tune` counts with what was measured of it.

    slow_device.py THIGMA STANDINS SCENE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from device_rig import DRIVERS, PATIENT, StandIn, patient_scene

program, standins, scene = sys.argv[1:4]
VRPN = next(driver for driver in DRIVERS if driver["name"] == "vrpn")

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    file = patient_scene(scene, folder, {**PATIENT, "silent_device": 1.0})
    print("poses a second    delay      stiffness by the device   the best coupling")
    found = {}
    for rate in (1000, 100):
        with StandIn(program, standins, {**VRPN, "keys": {"rate": rate}}, folder) as standin:
            code, tuned, said = standin.run("tune", "--device", standin.uri, "--mass", "0.01", "--inertia", "4e-6", "--quiet")
            assert code == 0, said
            looked = [program, "devices", "check", standin.uri, "--duration", "0.2", "--quiet", "--text"]
            text = subprocess.run(looked, capture_output=True, text=True).stdout
            _, _, told = standin.run("run", file, "--headless", "--device", standin.uri, "--duration", "0.2")
        found[rate] = (tuned, text, told)
        print(f"{rate:14d}  {1e3 * tuned['delay']:6.1f} ms  {tuned['linear']['limits']['device']:8.1f} N/m              "
              f"{tuned['linear']['stiffness']:8.1f} N/m")
    fast, slow = found[1000], found[100]
    assert slow[0]["delay"] > 0.015 and slow[0]["delay"] > 1.5 * fast[0]["delay"], (slow[0]["delay"], fast[0]["delay"])
    assert slow[0]["linear"]["limits"]["device"] < fast[0]["linear"]["limits"]["device"]
    assert re.search(r"its samples are [0-9.]+ ms old", slow[1]) and "slower than 1000 frames" in slow[1], slow[1]
    assert "slower than the haptic rate" in slow[2] and "thigma tune" in slow[2], slow[2]
