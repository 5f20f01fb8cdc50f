"""Sessions: a frame at a call, whole runs, threads that Python cannot hold up."""

import json
import signal
import sys
import threading
import time

import numpy as np
import pytest

import thigma


def test_steps_are_the_program_s_frames(program, tmp_path):
    """State hash of the run of another process, over every number of every frame."""
    said = json.loads(program("run", "--object", "procedural:ball?triangles=320",
                              "--against", "procedural:torus?triangles=500",
                              "--device", "hand:", "--response", "constraint", "--duration", "1.5",
                              "--headless", "--lockstep", "--json"))  # fmt: skip
    scene = thigma.scene_from_pair(
        "procedural:ball?triangles=320", "procedural:torus?triangles=500", response="constraint"
    )
    with thigma.Session(scene, device="hand:", duration=1.5) as session:
        frames = [sample.frame for sample in session]
    assert frames == list(range(1500))
    assert session.summary.frames == 1500 and session.summary.end == "duration"
    assert session.summary.state_hash == said["state_hash"]
    assert session.summary.force_max > 0.1
    figures = session.summary.figures  # all but what is measured by the clock of the processor
    assert set(said) - set(figures) == {"scene", "device", "safety_events", "state_hash"}
    for group in ("force", "torque", "friction", "passivity", "ridden_out", "levels"):
        assert figures[group] == said[group]
    assert figures["contact"]["contacts_mean"] == said["contact"]["contacts_mean"]
    assert figures["constraint"]["rows_mean"] == said["constraint"]["rows_mean"]
    assert figures["haptic"]["step_cpu_us"]["p50"] > 0.0 and figures["haptic"]["deadlines"] is None
    again = thigma.Session(scene, device="hand:", duration=1.5)
    assert again.run().state_hash == said["state_hash"]
    many = thigma.Session(scene, device="hand:", duration=1.5)
    while many.step(frames=7) is not None:
        pass
    assert many.close().state_hash == said["state_hash"]


def test_a_controller_of_one_s_own(scene):
    """A hand led through the first touch: the box stays outside, the spring pushes back."""
    with thigma.Session(scene, device="null:") as session:
        up = session.step((0, 0, 0, 0, 0, 0, 1))
        assert up.is_grasped and up.frame == 0
        start = up.pose[2]
        for i in range(1, 1000):
            sample = session.step((0, 0, -0.02 * min(1.0, i / 500), 0, 0, 0, 1))
        for _ in range(500):
            sample = session.step((0, 0, -0.02, 0, 0, 0, 1))
    assert start == pytest.approx(0.03, abs=1e-6)
    assert sample.device_handle[2] == -0.02 and sample.handle[2] < 0.018, "inside the other box"
    assert 0.02 <= sample.pose[2] < 0.021, "outside of the other box"
    assert sample.command[2] > 0.5, "pushed up"
    assert np.abs(sample.handle_velocity).max() == 0.0
    assert session.last.frame == 1499 and session.summary.frames == 1500
    assert session.summary.end == "stopped"


def test_velocity_of_a_handle(scene):
    with thigma.Session(scene, device="null:") as session:
        session.step((0, 0, 0, 0, 0, 0, 1))
        moved = session.step((0, 0, 1e-4, 0, 0, 0, 1))
        scale = moved.handle_velocity[2] / 0.1
        told = session.step((0, 0, 2e-4, 0, 0, 0, 1), velocity=(0.2, 0, 0, 0, 0, 0))
        assert scale > 0 and told.handle_velocity[0] == pytest.approx(0.2 * scale)
        assert session.step((0, 0, 0, 0, 0, 0, 1), buttons=0).buttons == 0
        assert session.step().device_handle[2] == 0.0, "the device's own again"


def test_arrays_of_a_sample_are_documented(scene):
    with thigma.Session(scene, device="null:") as session:
        sample = session.step()
        assert repr(sample).startswith("<thigma.Sample frame 0, 0.000 s, force ")
        names = [n for n in dir(sample) if not n.startswith("_")]
        assert len(names) == 19
        for name in names:
            assert getattr(type(sample), name).__doc__
        for name, size in (("pose", 7), ("handle", 7), ("command", 6), ("momentum", 6)):
            assert getattr(sample, name).shape == (size,)


def test_a_closed_session(scene):
    session = thigma.Session(scene, device="null:", duration=0.01)
    with pytest.raises(thigma.Error, match="not closed yet"):
        session.summary
    session.run()
    for call in (session.step, session.run, session.start):
        with pytest.raises(thigma.Error, match="session: is closed, expected an open one"):
            call()
    assert session.close() is session.summary and not session.is_running
    assert "closed" in repr(session) and session.last.frame == 9


def test_an_exception_inside_closes(scene, tmp_path):
    with pytest.raises(ZeroDivisionError):
        with thigma.Session(scene, device="null:", recording=tmp_path / "r.mcap") as session:
            session.step(frames=20)
            1 / 0
    assert session.summary.frames == 20
    assert len(thigma.read_recording(tmp_path / "r.mcap").frames["frame"]) == 20


@pytest.mark.parametrize(
    "options, error, text",
    [
        ({"device": "hond:"}, thigma.DeviceUnavailable, "hond"),
        ({"device": "hand:?speed=fast"}, ValueError, "speed"),
        ({"device": "web:"}, thigma.DeviceUnavailable, "page"),
        ({"duration": float("nan")}, thigma.InputError, "duration"),
        ({"duration": -1}, thigma.InputError, "duration"),
        ({"start": (0, 0, 0)}, thigma.InputError, "shape"),
        ({"start": (0, 0, 0, 0, 0, 0, 2)}, thigma.InputError, "length 2.0"),
        ({"recording": "/none/of/this.mcap"}, OSError, "none"),
    ],
)
def test_what_opens_no_session(scene, options, error, text):
    with pytest.raises(error, match=text):
        thigma.Session(scene, **{"device": "null:", **options})


@pytest.mark.parametrize(
    "options, text",
    [
        ({"handle": (0, 0, 0)}, "shape"),
        ({"handle": (0, 0, float("nan"), 0, 0, 0, 1)}, "handle: nan"),
        ({"handle": (0, 0, 0, 0, 0, 0, 1), "velocity": (0, 0, 0)}, "velocity: shape"),
        ({"handle": (0, 0, 0, 0, 0, 0, 1), "velocity": [np.inf] * 6}, "velocity: not finite"),
        ({"frames": 0}, "frames"),
        ({"buttons": -1}, "buttons"),
    ],
)
def test_what_is_no_step(scene, options, text):
    with thigma.Session(scene, device="null:") as session:
        with pytest.raises(thigma.InputError, match=text):
            session.step(**options)
        assert session.step().frame == 0, "the session goes on"


def test_scenes_that_are_none(tmp_path):
    with pytest.raises(thigma.InputError, match="jaw"):
        thigma.load_scene("jawz")
    with pytest.raises(thigma.InputError, match="none.obj"):
        thigma.scene_from_pair(tmp_path / "none.obj", "procedural:ball")
    with pytest.raises(ValueError, match="response: 'soft'"):
        thigma.scene_from_pair("procedural:ball", "procedural:ball", response="soft")
    with pytest.raises(TypeError, match="expected a thigma.Scene"):
        thigma.Session("jaws")
    assert "jaws" in thigma.builtin_scenes()


def test_ctrl_c_ends_a_run(scene):
    session = thigma.Session(scene, device="null:")
    timer = threading.Timer(0.3, signal.raise_signal, (signal.SIGINT,))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        session.run()
    assert session.summary.frames > 0 and session.summary.end == "stopped"


def test_other_threads_of_python_run_meanwhile(scene):
    """A lockstep run gives Python's lock away: the other thread counts while it lasts."""
    counted = []
    done = threading.Event()

    def count():
        while not done.is_set():
            counted.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    session = thigma.Session(scene, device="null:")
    begin = time.perf_counter()
    session.step(frames=30000)
    end = time.perf_counter()
    done.set()
    thread.join()
    session.close()
    inside = [t for t in counted if begin + 0.1 * (end - begin) < t < end - 0.1 * (end - begin)]
    assert inside, "the lock was held all the time"


def test_a_session_on_threads(scene):
    with thigma.Session(scene, device="hand:", threads=True, duration=0.3) as session:
        assert not session.is_running and session.last is None
        summary = session.run()
    assert summary.frames + summary.missed == 300 and summary.end == "duration"
    with pytest.raises(thigma.Error, match="step of a session on threads"):
        thigma.Session(scene, device="null:", threads=True).step()
    with pytest.raises(thigma.Error, match="start of a session in lockstep"):
        thigma.Session(scene, device="null:").start()


def test_threads_go_on_while_python_holds_its_lock(scene):
    """Pure Python that never gives the lock away; the session makes frames all the same."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(30.0)
    try:
        with thigma.Session(scene, device="hand:", threads=True) as session:
            session.start()
            while session.last is None:
                time.sleep(0.01)
            before = session.last.frame
            end = time.perf_counter() + 0.5
            while time.perf_counter() < end:
                pass
            after = session.last.frame
    finally:
        sys.setswitchinterval(interval)
    assert after > before + 50


def test_gains(program_json, scene, tmp_path):
    said = program_json("tune", "jaws")
    gains = thigma.tune_body("hand:", 0.01, 1e-6)
    body = program_json("tune", "--device", "hand:", "--mass", "0.01", "--inertia", "1e-6")
    assert gains.linear.stiffness == body["linear"]["stiffness"]
    assert gains.angular.damping == body["angular"]["damping"]
    assert gains.linear.binds == body["linear"]["binds"] and said["linear"]["stiffness"] > 0
    of_scene = thigma.tune(scene)
    assert of_scene.linear.stiffness > 0 and isinstance(of_scene.warnings, list)
    for wrong in ({"mass": 0.0}, {"inertia": -1.0}, {"rate": 1.0}, {"response": "soft"}):
        with pytest.raises(thigma.InputError, match=next(iter(wrong))):
            thigma.tune_body(**{"device": "hand:", "mass": 0.01, "inertia": 1e-6, **wrong})
