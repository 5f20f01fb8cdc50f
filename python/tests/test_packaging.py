"""Recipes and workflow: what of them can be checked without running them."""

import ast
import json
import pathlib
import re

import pytest

root = pathlib.Path(__file__).resolve().parents[2]


def version():
    text = (root / "CMakeLists.txt").read_text()
    return re.search(r"project\(thigma VERSION ([0-9.]+)", text).group(1)


def test_one_version():
    import thigma

    assert thigma.__version__ == version()
    assert json.loads((root / "packaging/vcpkg/thigma/vcpkg.json").read_text())["version-semver"] == version()


def test_the_conan_recipe_copies_what_a_build_needs():
    tree = ast.parse((root / "packaging/conan/conanfile.py").read_text())
    values = {
        node.targets[0].id: ast.literal_eval(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign)
    }
    for name in values["FOLDERS"] + values["FILES"]:
        assert (root / name).exists(), name
    used = set(re.findall(r"add_subdirectory\((\w+)", (root / "CMakeLists.txt").read_text()))
    optional = {"python", "reference", "benchmarks", "experiments", "viewer", "apps", "tests"}
    assert used - optional <= set(values["FOLDERS"])


def test_the_workflow_runs_what_there_is():
    yaml = pytest.importorskip("yaml")
    text = (root / ".github/workflows/packages.yml").read_text()
    jobs = yaml.safe_load(text)["jobs"]
    assert set(jobs) == {"test", "deb", "wheel", "container", "vcpkg", "conan"}
    for path in re.findall(r"(?:\./scripts|packaging)/[\w/]+", text):
        assert (root / path).exists(), path
    for uses in re.findall(r"uses: \S+", text):
        assert re.search(r"@v[\d.]+$", uses), "a version"


def test_the_container_file_copies_from_here():
    text = (root / "packaging/Containerfile").read_text()
    assert text.count("FROM ") == 2 and "USER thigma" in text
    assert "build" in (root / ".dockerignore").read_text().split()
