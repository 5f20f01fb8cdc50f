"""press.py LIBRARY OBJECT AGAINST: a box led onto a plate through libthigma_c.so, by ctypes alone."""
import ctypes as c
import sys

door = c.CDLL(sys.argv[1])
door.thigma_last_error.restype = c.c_char_p


class Handle(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("buttons", c.c_uint32), ("pose", c.c_double * 7)]


class Sample(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("fault", c.c_int32), ("frame", c.c_uint64),
                ("time", c.c_double), ("handle", c.c_double * 7), ("pose", c.c_double * 7),
                ("contact_wrench", c.c_double * 6), ("command", c.c_double * 6),
                ("penetration", c.c_double), ("contacts", c.c_int64)]


class Options(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("has_threads", c.c_int32), ("device", c.c_char_p),
                ("recording", c.c_char_p), ("duration", c.c_double), ("rate", c.c_double),
                ("seed", c.c_uint64)]


def check(result):
    if result != 0:
        raise RuntimeError(door.thigma_last_error().decode())


scene, session, options = c.c_void_p(), c.c_void_p(), Options()
above = (c.c_double * 7)(0, 0, 0.03, 0, 0, 0, 1)
names = [name.encode() for name in sys.argv[2:4]]
check(door.thigma_scene_pair(*names, c.c_double(1.0), above, c.byref(scene)))
door.thigma_session_options_init(c.byref(options))
options.device = b"null:"
check(door.thigma_session_open(scene, c.byref(options), c.byref(session)))
handle = Handle(c.sizeof(Handle), 1, (0, 0, 0, 0, 0, 0, 1))
sample = Sample(c.sizeof(Sample))
for i in range(1000):
    handle.pose[2] = -2e-5 * i
    check(door.thigma_session_step(session, c.c_uint64(1), c.byref(handle), c.byref(sample)))
door.thigma_session_free(session)
door.thigma_scene_free(scene)
print(f"pressed with {sample.command[2]:.2f} N at {1e3 * sample.pose[2]:.2f} mm")
