"""Types: mypy in strict mode, and stubs that say what the module has."""

import pathlib
import subprocess
import sys

import pytest

root = pathlib.Path(__file__).resolve().parents[2]


def run(*arguments):
    done = subprocess.run(
        [sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=root
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_mypy_is_strict_about_package_and_examples():
    pytest.importorskip("mypy")
    examples = [str(path) for path in sorted((root / "examples").glob("*.py"))]
    run("mypy", "--strict", str(root / "python" / "thigma"), *examples)


def test_stubs_name_what_there_is():
    pytest.importorskip("mypy")
    # pybind11's own metaclass, and constructors of what only functions make
    allowed = root / "python" / "tests" / "stubtest_allowed.txt"
    run("mypy.stubtest", "thigma._core", "--allowlist", str(allowed), "--ignore-unused-allowlist")


def test_everything_public_says_what_it_is():
    import thigma

    for name in thigma.__all__:
        value = getattr(thigma, name)
        if callable(value) and name not in ("Array",):
            assert value.__doc__, name
