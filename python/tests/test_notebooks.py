"""The notebooks run, and are kept without output."""

import os
import pathlib

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
folder = pathlib.Path(__file__).resolve().parents[2] / "examples" / "notebooks"
notebooks = sorted(folder.glob("*.ipynb"))


def test_there_are_three():
    assert [path.stem for path in notebooks] == ["gains", "levels_of_detail", "scan_to_force"]


@pytest.mark.parametrize("path", notebooks, ids=lambda path: path.stem)
def test_notebook(path, tmp_path):
    pytest.importorskip("ipykernel")
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            assert not cell.outputs and cell.execution_count is None, "stripped of output"
    client = nbclient.NotebookClient(
        notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    )
    client.execute()
    text = str([cell.get("outputs") for cell in notebook.cells])
    assert "image/png" in text, "its plots are there"
    if path.stem == "scan_to_force":
        wanted = "<iframe" if os.environ.get("THIGMA_PROGRAM") else "no program"
        assert wanted in text
