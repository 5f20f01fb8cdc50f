"""Devices that cannot be had: exit code, one line that says what to do, and no force. One table.

    bad_devices.py THIGMA STANDINS
"""
import contextlib
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile

from device_rig import AXES, DRIVERS, StandIn

program, standins = sys.argv[1:3]
BY_NAME = {driver["name"]: driver for driver in DRIVERS}
USAGE, UNAVAILABLE = 2, 3


def check(uri, library=None, more=None):
    environment = {**os.environ, **(more or {})}
    if library:
        environment["LD_LIBRARY_PATH"] = str(library)
    done = subprocess.run([program, "devices", "check", uri, "--duration", "0.1", "--quiet"], capture_output=True, text=True, env=environment)
    return done.returncode, done.stderr


def expect(what, found, code, words):
    exit_code, said = found
    lines = [line for line in said.splitlines() if line]
    assert len(lines) == 1, (what, said)
    print(f"{what:34} exit {exit_code}  {lines[0].removeprefix('thigma: ')[:170]}", flush=True)
    assert exit_code == code, (what, exit_code, said)
    for word in words:
        assert word in said, (what, word, said)


def with_stand_in(folder, name, keys, uri, what, words):
    """A stand-in with these keys from its start; nothing but zero may have come to it."""
    with StandIn(program, standins, {**BY_NAME[name], "keys": keys}, folder) as standin:
        environment = {}
        if "library" in standin.driver:
            environment[f"STANDIN_{standin.driver['library'].upper()}_BOARD"] = str(standin.board)
        library = f"{standins}/{standin.driver['library']}" if "library" in standin.driver else None
        expect(what, check(uri or standin.uri, library, environment), UNAVAILABLE, words)
        assert standin.get("force_max") == 0.0, what
        assert all(standin.get(f"last_f{axis}") == 0.0 for axis in AXES), what


@contextlib.contextmanager
def talker(data):
    """A service that says this to whoever connects, and nothing more."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        child = os.fork()
        if child == 0:
            while True:
                peer, _ = server.accept()
                if data is not None:
                    peer.sendall(data)
                    peer.close()
        try:
            yield server.getsockname()[1]
        finally:
            os.kill(child, 9)
            os.waitpid(child, 0)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    print(f"{'what':34} {'':6}  what is said")
    expect("a scheme that nobody has", check("dhf:0"), UNAVAILABLE, ["no device 'dhf:', nearest is 'dhd:'"])
    expect("no scheme", check("touch"), USAGE, ["has no scheme"])
    for driver, library in (("dhd:0", "libdrd"), ("openhaptics:", "libHD")):
        expect(f"{library}: for another processor", check(driver, f"{standins}/wrong_arch"), UNAVAILABLE, ["cannot be used", "x86-64"])
        expect(f"{library}: no library", check(driver, f"{standins}/garbage"), UNAVAILABLE, ["cannot be used", "x86-64"])
        expect(f"{library}: not there", check(driver), UNAVAILABLE, ["there is no", "Install"])
    expect("libdrd: lacks a symbol", check("dhd:0", f"{standins}/drd_missing"), UNAVAILABLE, ["lacks the symbol", "current version"])
    expect("libHD: lacks a symbol", check("openhaptics:", f"{standins}/hd_missing"), UNAVAILABLE, ["lacks the symbol", "current version"])
    if os.getuid() != 0:  # who is root may read everything
        hidden = folder / "libHD.so"
        hidden.write_bytes(pathlib.Path(f"{standins}/hd/libHD.so").read_bytes())
        hidden.chmod(0)
        expect("libHD: permission denied", check("openhaptics:", folder), UNAVAILABLE, ["permission denied", "chmod a+r"])
    with_stand_in(folder, "dhd", {"count": 0}, None, "dhd: nothing plugged in", ["no device is plugged in", "Plug it in"])
    with_stand_in(folder, "dhd", {"fail_open": 20}, None, "dhd: does not open", ["does not open", "udev"])
    with_stand_in(folder, "dhd", {"initialized": 0}, None, "dhd: no reference", ["devices calibrate dhd:"])
    with_stand_in(folder, "openhaptics", {"count": 0}, None, "openhaptics: nothing plugged in", ["no device answers", "Plug it in"])
    with_stand_in(folder, "openhaptics", {"calibration": 0x5002}, None, "openhaptics: not calibrated", ["inkwell", "devices calibrate"])
    with_stand_in(folder, "haply", {"count": 0}, None, "haply: nothing plugged in", ["has no device", "Plug it in"])
    with_stand_in(folder, "haply", {"calibrated": 0}, None, "haply: not calibrated", ["inkwell"])
    with_stand_in(folder, "haply", {"garbage": 1}, None, "haply: broken JSON", ["Inverse Service"])
    with_stand_in(folder, "haply", {"garbage": 2}, None, "haply: no frame", ["Inverse Service"])
    with_stand_in(folder, "haply", {"half": 1}, None, "haply: half a frame", ["haply:"])
    with_stand_in(folder, "vrpn", {"garbage": 1}, None, "vrpn: garbage", ["vrpn:"])
    with_stand_in(folder, "vrpn", {"half": 2}, None, "vrpn: half a message", ["stops in its first words"])
    with_stand_in(folder, "vrpn", {"wrong_cookie": 1}, None, "vrpn: another version", ["version 07"])
    for data, kind in ((b"HTTP/1.0 200 OK\r\n\r\nhello", "a web page"), (bytes(range(256)), "bytes"),
                       (b"HTTP/1.1 101", "half an answer"), (b"", "closes at once")):
        with talker(data) as port:
            expect(f"haply: {kind} there", check(f"haply:?port={port}"), UNAVAILABLE, [f"{port}"])
            expect(f"vrpn: {kind} there", check(f"vrpn:Haptic0@localhost:{port}"), UNAVAILABLE, ["vrpn_server"])
    expect("haply: nobody listens", check("haply:?port=1"), UNAVAILABLE, ["Start the Haply Hub"])
    expect("vrpn: nobody listens", check("vrpn:Haptic0@localhost:1"), UNAVAILABLE, ["Start vrpn_server"])
    expect("spacenav: no daemon", check(f"spacenav:{folder}/none.sock"), UNAVAILABLE, ["apt-get install spacenavd"])
    plain = folder / "no.sock"
    plain.write_text("")
    expect("spacenav: a file that is no socket", check(f"spacenav:{plain}"), UNAVAILABLE, ["spacenav"])
    expect("gamepad: a file that is none", check("gamepad:/dev/null"), UNAVAILABLE, ["is no gamepad"])
    expect("gamepad: not plugged in", check("gamepad:99"), UNAVAILABLE, ["Plug it in"])

said = subprocess.run([program, "devices", "--json"], capture_output=True, text=True, check=True).stdout
listed = [json.loads(line) for line in said.splitlines()]
left = {one["device"]: one["if_killed"] for one in listed if "if_killed" in one}
for driver in DRIVERS:  # each with force says what is left of it where nothing of the program is
    assert left[f"{driver['name']}:"], driver["name"]
assert "no time-out is documented" in left["openhaptics:"]
assert left["spacenav:"] is None and left["hand:"] is None
