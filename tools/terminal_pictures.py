#!/usr/bin/env python3
"""Pictures of the terminal for docs/devices.md: `thigma doctor` and `thigma devices` on a machine without a device, and with each stand-in of
tests/standins in the place of what a vendor installs.

    tools/terminal_pictures.py build/release            writes docs/images/terminal-*.svg
    tools/terminal_pictures.py build/release --check    whether they are what the program says; of doctor, whose numbers are the machine's, its checks
"""
import contextlib
import html
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1]).resolve()
images = root / "docs/images"
standins = build / "standins"
WIDTH, HEIGHT, MARGIN, COLUMNS = 7.25, 18, 14, 112  # of a character, a line, around [px]; of the terminal
NO_BREAK = "\u00a0"  # of spaces one would be left
FORCE = ("openhaptics:", "dhd:", "haply:", "vrpn:", "spacenav:", "gamepad:")


def bare(folder):
    return {"PATH": os.environ["PATH"], "HOME": str(folder), "LANG": "C.UTF-8", "SPNAV_SOCKET": ""}


def said(words, environment):
    done = subprocess.run([build / "thigma", *words, "--text"], capture_output=True, text=True, env=environment,
                          cwd=environment["HOME"], check=True)
    return done.stdout.splitlines()


def blocks(lines):
    """Of `devices`: the lines of each scheme without its parameters, and of each vendor's library."""
    found, at = {}, None
    for line in lines:
        scheme = re.match(r"([a-z]+:) ", line)
        library = re.match(r"  [a-z]+ +(lib[A-Za-z]+)\.so", line)
        if scheme or library:
            at = scheme[1] if scheme else library[1]
            found[at] = [line]
        elif at and re.match(r"  (plugged in|none|if this|            )", line) and not re.match(r"  [a-z_]+ {2,}", line):
            found[at].append(line)
        else:
            at = None
    return found


def wrapped(lines):
    out = []
    for line in lines:
        indent = " " * (len(line) - len(line.lstrip()) + 4)
        while len(line) > COLUMNS:
            cut = line.rfind(" ", len(indent) + 1, COLUMNS)
            out.append(line[:cut])
            line = indent + line[cut + 1:]
        out.append(line)
    return out


def svg(title, lines):
    lines = wrapped(lines)
    width, height = round(2 * MARGIN + WIDTH * COLUMNS), round(2 * MARGIN + HEIGHT * len(lines))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img">',
           f"<title>{html.escape(title)}</title>", '<rect width="100%" height="100%" rx="8" fill="#1b1f24"/>',
           '<g font-family="ui-monospace, DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="12" fill="#d7dce2">']
    for k, line in enumerate(lines):
        fill = ' fill="#7fd1a0"' if line.startswith("$ ") or "plugged in: " in line or "loadable" in line else ""
        text = html.escape(line.replace(" ", NO_BREAK))
        out.append(f'<text x="{MARGIN}" y="{MARGIN + HEIGHT * k + 13}"{fill}>{text}</text>')
    return "\n".join([*out, "</g>", "</svg>", ""])


def lines_of(file):
    return [html.unescape(text).replace(NO_BREAK, " ") for text in re.findall(r"<text [^>]*>(.*?)</text>", file.read_text())]


@contextlib.contextmanager
def process(words, environment):
    """A stand-in that is a process, from when it listens."""
    running = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment)
    try:
        assert running.stdout.readline().startswith("listening"), words
        yield
    finally:
        running.kill()
        running.wait()


def is_free(port):
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        return probe.connect_ex(("127.0.0.1", port)) != 0


def pictures(folder):
    """(name, title, lines, what of them the machine decides)"""
    usual = bare(folder)
    yield "doctor", "thigma doctor", ["$ thigma doctor", *said(["doctor"], usual)], "numbers"
    found = blocks(said(["devices"], usual))
    lines = ["$ thigma devices", *(line for scheme in (*FORCE, "libHD", "libdrd") for line in found[scheme])]
    yield "devices-bare", "thigma devices, where nothing is installed", lines, "gamepad"
    for scheme, library, kind in (("dhd:", "libdrd", "drd"), ("openhaptics:", "libHD", "hd")):
        found = blocks(said(["devices"], {**usual, "LD_LIBRARY_PATH": f"{standins}/{kind}"}))
        yield f"devices-{scheme[:-1]}", f"thigma devices, with {library}", ["$ thigma devices", *found[scheme], *found[library]], None
    board, pads, mouse = folder / "board", folder / "pads", folder / "spnav.sock"
    services = {"haply:": (["standin_haply", f"{board}1", "--port", "10001", "--events-port", "0"], {}),
                "spacenav:": (["standin_spacenav", f"{board}2", "--socket", str(mouse)], {"SPNAV_SOCKET": str(mouse)}),
                "gamepad:": (["standin_gamepad", f"{board}3", "--socket", str(pads)],
                             {"LD_PRELOAD": f"{standins}/libstandin_evdev.so", "STANDIN_EVDEV_FOLDER": str(pads), "STANDIN_GAMEPAD_BOARD": f"{board}3"})}
    for scheme, (words, more) in services.items():
        if scheme == "haply:" and not is_free(10001):
            print("haply: left out, its port is taken")
            continue
        with process([standins / words[0], *words[1:]], usual):
            found = blocks(said(["devices"], {**usual, **more}))
        yield f"devices-{scheme[:-1]}", f"thigma devices, with what {scheme} speaks with", ["$ thigma devices", *found[scheme]], None


def is_same(lines, kept, machine):
    if machine == "numbers":
        names = [[line.split()[1] for line in some if re.match(r"(ok|warn|missing) ", line)] for some in (lines, kept)]
        return names[0] == names[1]
    lines = wrapped(lines)
    if machine == "gamepad":
        at = [next(k for k, line in enumerate(some) if line.startswith("gamepad:")) for some in (lines, kept)]
        to = [next(k for k, line in enumerate(some) if " libHD.so" in line) for some in (lines, kept)]
        return lines[:at[0]] == kept[:at[1]] and lines[to[0]:] == kept[to[1]:]
    return lines == kept


stale = 0
with tempfile.TemporaryDirectory() as name:
    for picture, title, lines, machine in pictures(pathlib.Path(name)):
        lines = [line.replace(name, "/home/you") for line in lines]
        file = images / f"terminal-{picture}.svg"
        if "--check" not in sys.argv:
            file.write_text(svg(title, lines))
            print(file.relative_to(root), len(lines), "lines")
        elif not file.exists() or not is_same(lines, lines_of(file), machine):
            stale += 1
            print(f"{file.relative_to(root)}: is not what the program says; run tools/terminal_pictures.py {build}")
sys.exit(1 if stale else 0)
