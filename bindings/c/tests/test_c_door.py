#!/usr/bin/env python3
"""test_c_door.py LIBRARY FOLDER: calls the C door by ctypes; every wrong argument is a code and a line."""
import ctypes as c
import math
import pathlib
import random
import sys
import unittest

import make_boxes

door = c.CDLL(sys.argv[1])
folder = pathlib.Path(sys.argv[2])
OK, FAILED, BAD_ARGUMENT, UNAVAILABLE, BAD_INPUT, ENDED = range(6)
Seven, Six = c.c_double * 7, c.c_double * 6
door.thigma_last_error.restype = door.thigma_version.restype = c.c_char_p
door.thigma_mesh_vertex_count.restype = door.thigma_mesh_triangle_count.restype = c.c_int64
door.thigma_mesh_vertices.restype = c.POINTER(c.c_double)
door.thigma_mesh_triangles.restype = c.POINTER(c.c_int32)
door.thigma_clod_radius.restype = c.c_double
HERE = Seven(0, 0, 0, 0, 0, 0, 1)


class Query(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("is_exact", c.c_int32), ("tolerance", c.c_double),
                ("threshold", c.c_double), ("budget_tests", c.c_int64), ("step_time", c.c_double)]


class Contact(c.Structure):
    _fields_ = [("point", c.c_double * 3), ("scene_point", c.c_double * 3), ("normal", c.c_double * 3),
                ("depth", c.c_double), ("bound", c.c_double), ("object_level", c.c_int32), ("scene_level", c.c_int32)]


class Options(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("has_threads", c.c_int32), ("device", c.c_char_p),
                ("recording", c.c_char_p), ("duration", c.c_double), ("rate", c.c_double), ("seed", c.c_uint64)]


class Handle(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("buttons", c.c_uint32), ("pose", Seven)]


class Sample(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("fault", c.c_int32), ("frame", c.c_uint64), ("time", c.c_double),
                ("handle", Seven), ("pose", Seven), ("contact_wrench", Six), ("command", Six),
                ("penetration", c.c_double), ("contacts", c.c_int64)]


class Summary(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("end", c.c_int32), ("frames", c.c_uint64), ("missed", c.c_uint64),
                ("seconds", c.c_double), ("force_max", c.c_double), ("torque_max", c.c_double),
                ("penetration_max", c.c_double), ("state_hash", c.c_uint64)]


def last():
    return door.thigma_last_error().decode()


def make_mesh(size, scale=1.0, corners=None, faces=None):
    """Code and handle."""
    corners = make_boxes.corners(*size) if corners is None else corners
    faces = make_boxes.FACES if faces is None else faces
    v = (c.c_double * (3 * len(corners)))(*[x for corner in corners for x in corner])
    t = (c.c_int32 * (3 * len(faces)))(*[i - 1 for face in faces for i in face])
    mesh = c.c_void_p()
    code = door.thigma_mesh_create(v, c.c_int64(len(corners)), t, c.c_int64(len(faces)), c.c_double(scale),
                                   c.byref(mesh))
    return code, mesh


def box_clod():
    mesh, clod = make_mesh((0.02, 0.02, 0.02))[1], c.c_void_p()
    assert door.thigma_clod_exact(mesh, c.byref(clod)) == OK
    door.thigma_mesh_free(mesh)
    return clod


def make_query(**values):
    query = Query()
    door.thigma_query_init(c.byref(query))
    for name, value in values.items():
        setattr(query, name, value)
    return query


class Door(unittest.TestCase):
    def refused(self, code, result, *words):
        self.assertEqual(result, code, last())
        self.assertNotIn("\n", last())
        for word in words:
            self.assertIn(word, last())

    def test_meshes(self):
        code, mesh = make_mesh((1, 2, 3), scale=0.5)
        self.assertEqual(code, OK)
        self.assertEqual((door.thigma_mesh_vertex_count(mesh), door.thigma_mesh_triangle_count(mesh)), (8, 12))
        self.assertEqual(max(door.thigma_mesh_vertices(mesh)[0:24]), 0.75)
        self.assertEqual(sorted(set(door.thigma_mesh_triangles(mesh)[0:36])), list(range(8)))
        door.thigma_mesh_free(mesh)
        self.assertEqual(door.thigma_mesh_vertex_count(None), 0)
        nan = [(math.nan, 0, 0)] + make_boxes.corners(1, 1, 1)[1:]
        self.refused(BAD_INPUT, make_mesh(None, corners=nan)[0], "vertex 0")
        self.refused(BAD_INPUT, make_mesh((1, 1, 1), faces=[(1, 2, 9)])[0], "vertex 8", "expected 0 to 7")
        self.refused(BAD_INPUT, make_mesh((1, 1, 1), faces=[])[0])
        self.refused(BAD_INPUT, make_mesh((1, 1, 1), scale=math.nan)[0], "scale")
        self.refused(BAD_ARGUMENT, door.thigma_mesh_create(None, c.c_int64(3), None, c.c_int64(1), c.c_double(1), None),
                     "mesh: NULL")
        self.refused(BAD_ARGUMENT, door.thigma_mesh_create(None, c.c_int64(-1), None, c.c_int64(1), c.c_double(1),
                                                           c.byref(mesh)), "vertex_count")
        self.refused(BAD_INPUT, door.thigma_mesh_load(b"/none.obj", c.c_double(1), c.byref(mesh)), "/none.obj")

    def test_levels(self):
        mesh, clod, again = c.c_void_p(), c.c_void_p(), c.c_void_p()
        self.assertEqual(door.thigma_mesh_load(b"procedural:ball?triangles=320", c.c_double(1), c.byref(mesh)), OK)
        self.assertEqual(door.thigma_clod_build(mesh, 2, c.byref(clod)), OK)
        self.assertGreater(door.thigma_clod_level_count(clod), 1)
        path = str(folder / "ball.clod").encode()
        self.assertEqual(door.thigma_clod_save(clod, path), OK)
        self.assertEqual(door.thigma_clod_load(path, c.c_double(2), c.byref(again)), OK)
        self.assertEqual(door.thigma_clod_radius(again), 2 * door.thigma_clod_radius(clod))
        self.refused(FAILED, door.thigma_clod_save(clod, b"/none/of/this.clod"), "/none/of/this")
        self.refused(BAD_INPUT, door.thigma_clod_load(path, c.c_double(0), c.byref(again)))
        self.refused(BAD_ARGUMENT, door.thigma_clod_build(mesh, -1, c.byref(again)), "threads")
        for handle in (clod, again):
            door.thigma_clod_free(handle)
        door.thigma_mesh_free(mesh)

    def test_contacts_of_two_boxes(self):
        """1.5 mm above, the faces are that far apart."""
        clod, tracker, count, distance = box_clod(), c.c_void_p(), c.c_int64(), c.c_double()
        query = make_query(tolerance=0.002)
        self.assertEqual(door.thigma_tracker_create(clod, clod, None, c.byref(query), c.byref(tracker)), OK)
        contacts = (Contact * 2)()
        at = Seven(0, 0, 0.0215, 0, 0, 0, 1)
        self.assertEqual(door.thigma_tracker_contacts(tracker, at, contacts, c.c_int64(2), c.byref(count),
                                                      c.byref(distance)), OK)
        self.assertGreater(count.value, 0)
        self.assertAlmostEqual(distance.value, 0.0015, 12)
        self.assertAlmostEqual(contacts[0].normal[2], -1.0, 9)
        self.assertLessEqual(contacts[0].depth, -0.0015 + 1e-12)
        whole = count.value
        self.assertEqual(door.thigma_tracker_contacts(tracker, at, None, c.c_int64(0), c.byref(count), None), OK)
        self.assertEqual(count.value, whole)
        far = Seven(0, 0, 1, 0, 0, 0, 1)
        self.assertEqual(door.thigma_tracker_contacts(tracker, far, None, c.c_int64(0), c.byref(count),
                                                      c.byref(distance)), OK)
        self.assertEqual((count.value, distance.value), (0, math.inf))
        bad = Seven(0, 0, 0, 0, 0, 0, 2)
        self.refused(BAD_INPUT, door.thigma_tracker_contacts(tracker, bad, None, c.c_int64(0), c.byref(count), None),
                     "length 2.0")
        self.refused(BAD_ARGUMENT, door.thigma_tracker_contacts(tracker, at, None, c.c_int64(1), c.byref(count), None),
                     "contacts: NULL")
        self.refused(BAD_ARGUMENT, door.thigma_tracker_contacts(None, at, None, c.c_int64(0), c.byref(count), None))
        door.thigma_tracker_free(tracker)
        for values in ({"tolerance": -1.0}, {"tolerance": math.nan}, {"step_time": 0.0}):
            wrong = make_query(**values)
            self.refused(BAD_INPUT, door.thigma_tracker_create(clod, clod, None, c.byref(wrong), c.byref(tracker)),
                         next(iter(values)))
        wrong = make_query(struct_size=7)
        self.refused(BAD_ARGUMENT, door.thigma_tracker_create(clod, clod, None, c.byref(wrong), c.byref(tracker)),
                     "struct_size 7, expected 40")
        levels = make_query(tolerance=0.001, is_exact=0)
        self.refused(BAD_INPUT, door.thigma_tracker_create(clod, clod, None, c.byref(levels), c.byref(tracker)),
                     "without levels of detail")
        door.thigma_clod_free(clod)

    def open(self, **values):
        scene, session, options = c.c_void_p(), c.c_void_p(), Options()
        above = Seven(0, 0, 0.03, 0, 0, 0, 1)
        names = [str(folder / name).encode() for name in ("box.obj", "plate.obj")]
        self.assertEqual(door.thigma_scene_pair(*names, c.c_double(1), above, c.byref(scene)), OK, last())
        door.thigma_session_options_init(c.byref(options))
        for name, value in {"device": b"hand:", **values}.items():
            setattr(options, name, value)
        code = door.thigma_session_open(scene, c.byref(options), c.byref(session))
        door.thigma_scene_free(scene)
        return code, session

    def test_a_session_in_lockstep_and_its_end(self):
        code, session = self.open(duration=0.02)
        sample, summary = Sample(c.sizeof(Sample)), Summary(c.sizeof(Summary))
        self.assertEqual(code, OK)
        self.refused(BAD_ARGUMENT, door.thigma_session_last(session, c.byref(sample)), "no frame")
        self.assertEqual(door.thigma_session_step(session, c.c_uint64(19), None, c.byref(sample)), OK)
        self.assertEqual((sample.frame, door.thigma_session_is_running(session)), (18, 1))
        self.assertEqual(door.thigma_session_step(session, c.c_uint64(5), None, c.byref(sample)), ENDED)
        self.assertEqual((sample.frame, door.thigma_session_is_running(session)), (19, 0))
        self.refused(BAD_ARGUMENT, door.thigma_session_start(session), "lockstep")
        self.refused(BAD_ARGUMENT, door.thigma_session_step(session, c.c_uint64(0), None, None), "frames")
        wrong = Handle(c.sizeof(Handle), 1, Seven(0, 0, math.inf, 0, 0, 0, 1))
        self.refused(BAD_INPUT, door.thigma_session_step(session, c.c_uint64(1), c.byref(wrong), None), "handle: inf")
        self.assertEqual(door.thigma_session_finish(session, c.byref(summary)), OK)
        self.assertEqual((summary.frames, summary.end, summary.missed), (20, 0, 0))
        self.refused(BAD_ARGUMENT, door.thigma_session_step(session, c.c_uint64(1), None, None), "is closed")
        door.thigma_session_free(session)

    def test_a_session_on_threads(self):
        code, session = self.open(has_threads=1)
        summary = Summary(c.sizeof(Summary))
        self.assertEqual(code, OK)
        self.refused(BAD_ARGUMENT, door.thigma_session_step(session, c.c_uint64(1), None, None), "on threads")
        self.assertEqual(door.thigma_session_start(session), OK)
        sample = Sample(c.sizeof(Sample))
        while door.thigma_session_last(session, c.byref(sample)) != OK or sample.frame < 20:
            self.assertEqual(door.thigma_session_is_running(session), 1)
        self.assertEqual(door.thigma_session_finish(session, c.byref(summary)), OK)
        self.assertGreaterEqual(summary.frames, 20)
        self.assertEqual(summary.end, 2)
        door.thigma_session_free(session)

    def test_a_scene_of_meshes_in_memory(self):
        """Its frames are those of the same meshes from files; the meshes may go."""
        hashes = []
        for from_memory in (True, False):
            scene, session, options = c.c_void_p(), c.c_void_p(), Options()
            summary, above = Summary(c.sizeof(Summary)), Seven(0, 0, 0.03, 0, 0, 0, 1)
            if from_memory:
                box, plate = (make_mesh(size)[1] for size in ((0.02, 0.02, 0.02), (0.1, 0.1, 0.02)))
                self.refused(BAD_ARGUMENT, door.thigma_scene_of_meshes(box, None, above, c.byref(scene)), "against: NULL")
                self.assertEqual(door.thigma_scene_of_meshes(box, plate, above, c.byref(scene)), OK, last())
                door.thigma_mesh_free(box), door.thigma_mesh_free(plate)
            else:
                names = [str(folder / name).encode() for name in ("box.obj", "plate.obj")]
                self.assertEqual(door.thigma_scene_pair(*names, c.c_double(1), above, c.byref(scene)), OK, last())
            door.thigma_session_options_init(c.byref(options))
            options.device, options.duration = b"hand:", 0.3
            self.assertEqual(door.thigma_session_open(scene, c.byref(options), c.byref(session)), OK, last())
            self.assertEqual(door.thigma_session_step(session, c.c_uint64(1000), None, None), ENDED)
            self.assertEqual(door.thigma_session_finish(session, c.byref(summary)), OK)
            hashes.append(summary.state_hash)
            door.thigma_session_free(session), door.thigma_scene_free(scene)
        self.assertEqual(*hashes)

    def test_what_opens_no_session(self):
        for code, values, word in ((UNAVAILABLE, {"device": b"hond:"}, "hond"), (UNAVAILABLE, {"device": b"web:"}, "web"),
                                   (BAD_INPUT, {"duration": -1.0}, "duration"), (FAILED, {"recording": b"/none/x"}, "/none"),
                                   (BAD_ARGUMENT, {"struct_size": 3}, "struct_size 3")):
            self.refused(code, self.open(**values)[0], word)
        scene = c.c_void_p()
        self.refused(BAD_INPUT, door.thigma_scene_load(b"jawz", c.byref(scene)), "jaws")
        self.refused(BAD_ARGUMENT, door.thigma_scene_load(None, c.byref(scene)), "path: NULL")

    def test_axes_of_others(self):
        """Mapping a posed point is posing the mapped point; a wrench turns with its axes."""

        def turned(q, v):
            x, y, z, w = q
            t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
            return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
                    v[2] + w * t[2] + x * t[1] - y * t[0]]

        rules = {"unity": lambda v: [v[1], v[2], -v[0]], "unreal": lambda v: [-100 * v[0], 100 * v[1], 100 * v[2]]}
        pick = random.Random(3)
        for name, rule in rules.items():
            for _ in range(20):
                p, q, v = ([pick.gauss(0, 1) for _ in range(n)] for n in (3, 4, 3))
                q = [x / math.hypot(*q) for x in q]
                theirs, back = Seven(), Seven()
                getattr(door, f"thigma_pose_to_{name}")(Seven(*p, *q), theirs)
                getattr(door, f"thigma_pose_from_{name}")(theirs, back)
                for a, b in zip(back, p + q):
                    self.assertAlmostEqual(a, b, 12)
                posed = [a + b for a, b in zip(turned(q, v), p)]
                mapped = [a + b for a, b in zip(turned(theirs[3:7], rule(v)), theirs[0:3])]
                for a, b in zip(rule(posed), mapped):
                    self.assertAlmostEqual(a, b, 10)
                # Torque of a force at a lever, by the cross product's formula, which is theirs as well.
                f = [pick.gauss(0, 1) for _ in range(3)]
                cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
                wrench = Six()
                getattr(door, f"thigma_wrench_to_{name}")(Six(*f, *cross(v, f)), wrench)
                scale = 1 if name == "unity" else 100
                for a, b in zip(wrench[3:6], cross(rule(v), rule(f))):
                    self.assertAlmostEqual(a * scale**2, b, 8)

    def test_texts(self):
        self.assertRegex(door.thigma_version().decode(), r"^\d+\.\d+\.\d+$")
        for free in ("mesh", "clod", "tracker", "scene", "session"):
            getattr(door, f"thigma_{free}_free")(None)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
