#!/usr/bin/env python3
"""Stages the pages of the documentation site: tools/make_site.py FOLDER.

docs/, the pages of the root and of experiments, the notebooks and the C header become pages of
FOLDER; a link to a file that is no page becomes its name. mkdocs.yml has the order of the pages.
"""
import json
import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = {"README.md": "index.md", "CHANGELOG.md": "changelog.md", "CONTRIBUTING.md": "contributing.md", "STYLE.md": "style.md"}


def pages():
    """Path in the repository to path in the site."""
    found = {ROOT / name: pathlib.Path(staged) for name, staged in PAGES.items()}
    for path in (ROOT / "docs").rglob("*.md"):
        found[path] = path.relative_to(ROOT / "docs")
    for path in (ROOT / "experiments").rglob("README.md"):
        folder = path.parent.relative_to(ROOT)
        found[path] = folder / "index.md"
    for path in (ROOT / "examples" / "notebooks").glob("*.ipynb"):
        found[path] = pathlib.Path("notebooks") / f"{path.stem}.md"
    return found


def notebook_text(path):
    """Cells as text and code."""
    parts = []
    for cell in json.loads(path.read_text("utf-8"))["cells"]:
        text = "".join(cell["source"])
        parts.append(text if cell["cell_type"] == "markdown" else f"```python\n{text}\n```")
    return "\n\n".join(parts) + "\n"


def relinked(text, path, staged):
    """Links from one page to another as they are in the site."""
    known = pages()

    def link(match):
        words, target = match.group(1), match.group(2)
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return match.group(0)
        file, _, place = target.partition("#")
        there = (path.parent / file).resolve()
        to = known.get(there)
        if to is None and there.suffix in (".png", ".svg"):
            to = there.relative_to(ROOT / "docs")
        if to is None:
            return words if words.startswith("`") else f"`{os.path.relpath(there, ROOT)}`"
        relative = os.path.relpath(to, staged.parent)
        return f"[{words}]({relative}{'#' + place if place else ''})"

    # not inside code
    parts = re.split(r"(^```.*?^```$|`[^`\n]*`(?!\]))", text, flags=re.S | re.M)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"\[([^\]\n]*)\]\(([^)\s]+)\)", link, parts[i])
    return "".join(parts)


def c_reference():
    """The header, whose comments are its reference."""
    header = (ROOT / "bindings/c/include/thigma/thigma_c.h").read_text("utf-8")
    return f"# C reference\n\n`thigma/thigma_c.h`, installed by `libthigma-dev`. [What it is for](../c.md).\n\n```c\n{header}```\n"


def main():
    out = pathlib.Path(sys.argv[1])
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(ROOT / "docs" / "images", out / "images")
    for path, staged in pages().items():
        target = out / staged
        target.parent.mkdir(parents=True, exist_ok=True)
        text = notebook_text(path) if path.suffix == ".ipynb" else path.read_text("utf-8")
        target.write_text(relinked(text, path, staged), "utf-8")
    reference = out / "reference"
    reference.mkdir()
    (reference / "c.md").write_text(c_reference(), "utf-8")
    (reference / "cpp.md").write_text(
        "# C++ reference\n\nOf the installed headers, by Doxygen: "
        '<a href="../../cpp/index.html">the pages</a>. The front door is `thigma/thigma.h`; '
        "[architecture](../architecture.md) has the rooms.\n", "utf-8")  # fmt: skip
    for module in ("thigma", "thigma.batch"):
        name = "python" if module == "thigma" else "batch"
        (reference / f"{name}.md").write_text(f"# `{module}`\n\n::: {module}\n", "utf-8")


if __name__ == "__main__":
    main()
