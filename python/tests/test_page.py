"""The page of the program, started from Python."""

import os
import pathlib
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


def test_what_cannot_be_shown(tmp_path):
    with pytest.raises(thigma.InputError, match="no program"):
        thigma.Page("ellipsoid", program=tmp_path / "none")
    if pathlib.Path(os.environ.get("THIGMA_PROGRAM", "")).is_file():
        with pytest.raises(thigma.Error, match="nothing.toml"):
            thigma.Page(tmp_path / "nothing.toml")
