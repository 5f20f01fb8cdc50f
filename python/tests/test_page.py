"""The page of the program, started from Python."""

import os
import pathlib
import signal
import subprocess
import sys
import time
import urllib.request

import pytest

import thigma


@pytest.fixture
def page():
    if not pathlib.Path(os.environ.get("THIGMA_PROGRAM", "")).is_file():
        pytest.skip("THIGMA_PROGRAM names no program")
    with thigma.Page("ellipsoid", device="hand:", height=300) as page:
        yield page


def test_a_cell_shows_the_page(page):
    """As a notebook would: a frame of this machine may show it, with its own sources alone."""
    assert page.is_open and page.address.startswith("http://127.0.0.1:")
    assert f'src="{page.address}"' in page._repr_html_() and 'height="300"' in page._repr_html_()
    with urllib.request.urlopen(page.address, timeout=10) as answer:
        policy = answer.headers["Content-Security-Policy"]
        assert b"<html" in answer.read().lower()
    assert policy.endswith("frame-ancestors http://127.0.0.1:* http://localhost:*")
    process = page._process
    page.close()
    assert not page.is_open and process.returncode is not None
    assert repr(page) == "<thigma.Page closed>"
    page.close()


def has_ended(process):
    try:
        stat = pathlib.Path(f"/proc/{process}/stat").read_text()
    except OSError:
        return True
    return stat.rpartition(")")[2].split()[0] == "Z"  # nobody has asked for its exit code


@pytest.mark.parametrize("end", ["pass", "del page", "raise SystemExit(3)"])
def test_it_ends_with_python(end):
    """Without a close: the name goes, or Python does."""
    if not pathlib.Path(os.environ.get("THIGMA_PROGRAM", "")).is_file():
        pytest.skip("THIGMA_PROGRAM names no program")
    code = f"import sys, thigma\npage = thigma.Page('ellipsoid', device='hand:')\nprint(page._process.pid)\n{end}\n"
    if end == "del page":
        code += "sys.stdout.flush()\nimport time\ntime.sleep(0.5)\nimport os\nos._exit(0)\n"
    done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, timeout=120)
    process = int(done.stdout)
    for _ in range(300):
        if has_ended(process):
            return
        time.sleep(0.1)
    os.kill(process, signal.SIGTERM)
    pytest.fail("the program goes on")


def test_what_cannot_be_shown(tmp_path):
    with pytest.raises(thigma.InputError, match="no program"):
        thigma.Page("ellipsoid", program=tmp_path / "none")
    if pathlib.Path(os.environ.get("THIGMA_PROGRAM", "")).is_file():
        with pytest.raises(thigma.Error, match="nothing.toml"):
            thigma.Page(tmp_path / "nothing.toml")
