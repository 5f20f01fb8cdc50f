"""The documentation: its site is made without a warning, its code runs or says why it does not."""

import os
import pathlib
import re
import shlex
import subprocess
import sys

import pytest

import thigma

root = pathlib.Path(__file__).resolve().parents[2]


def blocks_of(path):
    """Texts between fences."""
    return [
        "\n".join(line for line in match.group(1).split("\n"))
        for match in re.finditer(r"^ *```\w*\n(.*?)\n^ *```$", path.read_text("utf-8"), re.S | re.M)
    ]


def listed():
    rows = []
    for line in (root / "python/tests/code_blocks.txt").read_text("utf-8").splitlines():
        if line and not line.startswith("#"):
            rows.append([part.strip() for part in line.split("|", 2)])
    return rows


def test_every_page_has_its_place():
    order = (root / "mkdocs.yml").read_text("utf-8")
    for path in (root / "docs").glob("*.md"):
        assert re.search(rf": {path.name}$", order, re.M), path.name


def pages():
    paths = [root / "README.md", *sorted((root / "docs").glob("*.md"))]
    return {path.relative_to(root).as_posix(): blocks_of(path) for path in paths}


def test_every_block_is_listed():
    found = [(page, block) for page, blocks in pages().items() for block in blocks]
    rows = listed()
    assert len(found) == len(rows), "one line of code_blocks.txt a block"
    for (page, block), (named, how, first) in zip(found, rows):
        assert page == named and block.strip().startswith(first), (page, block[:60], first)
        kind = how.split(" ")[0].rstrip(":")
        assert kind in ("run", "fails", "slow", "output", "python", "file", "as", "not"), how
        if kind == "as":
            assert (root / how[3:]).exists(), how


RUN = sorted({page for page, how, _ in listed() if how in ("run", "slow", "python")})


@pytest.mark.parametrize("page", RUN)
def test_code_of_a_page(page, program, tmp_path, monkeypatch):
    """As somebody would who reads it, in a folder with meshes of these names."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "thigma").symlink_to(os.environ["THIGMA_PROGRAM"])
    (tmp_path / "scenes").symlink_to(root / "scenes")
    for name in ("upper.obj", "lower.obj", "fine.ply"):
        ball = thigma.Mesh.from_file("procedural:ball?triangles=720", scale=1000.0)
        ball.save(tmp_path / name)
    monkeypatch.chdir(tmp_path)
    environment = {**os.environ, "PATH": f"{tmp_path}/bin:{os.environ['PATH']}"}
    said, module, ran = "", {}, 0
    rows = [row for row in listed() if row[0] == page]
    for block, (_, how, _first) in zip(pages()[page], rows):
        if how in ("run", "fails") or (how == "slow" and os.environ.get("THIGMA_FULL")):
            # On a terminal, as the pages show it.
            typed = ["script", "-qec", shlex.join(["bash", "-e", "-c", block]), "/dev/null"]
            done = subprocess.run(
                typed, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=environment, timeout=600
            )
            said = done.stdout + done.stderr
            ran += 1
            assert (done.returncode == 0) == (how != "fails"), (block, said)
        elif how == "output":
            for line in block.split("\n"):
                assert line.rstrip() in said, (line, said)
        elif how == "python":
            exec(compile(block, f"{page}", "exec"), module)  # noqa: S102
            ran += 1
        elif how.startswith("file "):
            (tmp_path / how[5:]).write_text(block + "\n")
    if not ran:
        pytest.skip(f"{page}: its commands are slow; with scripts/test --full")


def test_the_site_is_made_without_a_warning():
    pytest.importorskip("mkdocs")
    pytest.importorskip("mkdocstrings")
    done = subprocess.run(
        [sys.executable, "tools/make_site.py", "build/site_pages"], cwd=root, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet"],
        cwd=root, capture_output=True, text=True, env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert "WARNING" not in done.stderr, done.stderr
    site = root / "build" / "site"
    python = (site / "reference" / "python" / "index.html").read_text("utf-8")
    for name in set(thigma.__all__) - {"__version__"}:
        assert f'id="thigma.{name}"' in python, name
    assert "thigma_session_step" in (site / "reference" / "c" / "index.html").read_text("utf-8")
    for page in ("hello", "notebooks/gains", "gallery", "architecture"):
        assert (site / page / "index.html").is_file()
