"""Recordings: the table of the program, vectors, damage."""

import csv

import numpy as np
import pytest

import thigma


@pytest.fixture(scope="module")
def recorded(scene, tmp_path_factory):
    path = tmp_path_factory.mktemp("recording") / "session.mcap"
    with thigma.Session(scene, device="hand:", duration=1.5, recording=path) as session:
        poses = [sample.pose for sample in session]
    return path, np.array(poses), session.summary


def test_columns_are_those_of_the_program_s_table(program, recorded, tmp_path):
    path, poses, summary = recorded
    recording = thigma.read_recording(path)
    program("export", path, "-o", tmp_path / "table.csv")
    with open(tmp_path / "table.csv") as file:
        table = list(csv.DictReader(file))
    assert list(recording.frames) == list(table[0]) and len(table) == summary.frames == 1500
    for name, column in recording.frames.items():
        assert column.shape == (1500,)
        for ours, theirs in zip(column.tolist(), (row[name] for row in table)):
            if isinstance(ours, str):
                assert ours == theirs
            else:
                assert not theirs or float(ours) == float(theirs), name
    np.testing.assert_array_equal(recording.vector("body"), poses[:, :3])
    np.testing.assert_array_equal(recording.vector("body q"), poses[:, 3:])
    assert recording.vector("command f").shape == (1500, 3)
    assert recording.contacts["contacts"].dtype == np.int64
    assert recording.config["rate_hz"] == 1000.0 and recording.cut_off == ""
    assert [event.kind for event in recording.events][:1] == ["grasped"]
    with pytest.raises(thigma.InputError, match="no vector 'bodi'"):
        recording.vector("bodi")
    assert repr(recording) == "<thigma.Recording 1500 frames, 1.499 s>"


def test_replay(recorded):
    report = thigma.replay(recorded[0])
    assert report.identical and report.frames == 1500 and report.reason == ""


def test_a_damaged_recording(recorded, tmp_path):
    whole = recorded[0].read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(whole[: len(whole) // 2])
    recording = thigma.read_recording(cut)
    assert recording.cut_off and 0 < len(recording.frames["frame"]) < 1500
    none = tmp_path / "none.mcap"
    none.write_bytes(b"no recording")
    with pytest.raises(thigma.InputError, match="none.mcap"):
        thigma.read_recording(none)


def test_a_table_of_pandas(recorded):
    pandas = pytest.importorskip("pandas")
    assert len(pandas.DataFrame(thigma.read_recording(recorded[0]).frames)) == 1500
