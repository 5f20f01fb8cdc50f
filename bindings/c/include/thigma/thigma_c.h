#ifndef THIGMA_THIGMA_C_H
#define THIGMA_THIGMA_C_H
/* The door for C, and for what calls C: handles, plain structs, error codes. docs/c.md.
 *
 * Units are SI. A pose is seven numbers x, y, z, qx, qy, qz, qw, world from body; axes are
 * right-handed, z up, x towards the operator, y to the right. A wrench is force, then torque.
 *
 * A function that can fail returns a thigma_result and leaves its results alone where it is not
 * THIGMA_OK or THIGMA_ENDED; thigma_last_error() then says in one line what, where and what was
 * expected. What a function hands out as thigma_X** is the caller's, to be given to thigma_X_free;
 * NULL may be freed. Pointers into a handle live as long as it does. Text is UTF-8 with a 0 at its
 * end.
 *
 * Thread: a handle is for one thread at a time; different handles for any. No function calls back.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define THIGMA_API __attribute__((visibility("default")))
#else
#define THIGMA_API
#endif

typedef int32_t thigma_result;
enum {
  THIGMA_OK = 0,
  THIGMA_FAILED = 1,             /* the system refused, or memory ended */
  THIGMA_BAD_ARGUMENT = 2,       /* NULL, a size that is none, a closed session */
  THIGMA_DEVICE_UNAVAILABLE = 3, /* not plugged in, or not of this build */
  THIGMA_BAD_INPUT = 4,          /* a mesh, a scene, a file or numbers that cannot be used */
  THIGMA_ENDED = 5               /* no error: the session is over, its last sample is filled in */
};

/* "0.1.0". */
THIGMA_API const char* thigma_version(void);
/* Of the last call of this thread that failed; "" before. Lives until the next that fails. */
THIGMA_API const char* thigma_last_error(void);

/* ---- meshes and levels of detail ---- */

typedef struct thigma_mesh thigma_mesh;
typedef struct thigma_clod thigma_clod;

/* A mesh from memory; equal positions become one vertex, as when a file is read.
 * vertices   x, y, z each [1 / scale m]
 * triangles  three indices each, counter-clockwise from outside
 * scale      metres per unit, > 0 */
THIGMA_API thigma_result thigma_mesh_create(const double* vertices, int64_t vertex_count,
                                            const int32_t* triangles, int64_t triangle_count,
                                            double scale, thigma_mesh** mesh);
/* A mesh file of any kind that is read. */
THIGMA_API thigma_result thigma_mesh_load(const char* path, double scale, thigma_mesh** mesh);
THIGMA_API void thigma_mesh_free(thigma_mesh* mesh);
THIGMA_API int64_t thigma_mesh_vertex_count(const thigma_mesh* mesh);   /* 0 of NULL */
THIGMA_API int64_t thigma_mesh_triangle_count(const thigma_mesh* mesh); /* 0 of NULL */
THIGMA_API const double* thigma_mesh_vertices(const thigma_mesh* mesh); /* [m] */
THIGMA_API const int32_t* thigma_mesh_triangles(const thigma_mesh* mesh);

/* The finest surface alone: what exact contacts need. */
THIGMA_API thigma_result thigma_clod_exact(const thigma_mesh* mesh, thigma_clod** clod);
/* Contact levels of detail; may take minutes. threads: 0, as many as there are. */
THIGMA_API thigma_result thigma_clod_build(const thigma_mesh* mesh, int32_t threads,
                                           thigma_clod** clod);
/* .clod files, as `thigma build` writes them. */
THIGMA_API thigma_result thigma_clod_load(const char* path, double scale, thigma_clod** clod);
THIGMA_API thigma_result thigma_clod_save(const thigma_clod* clod, const char* path);
THIGMA_API void thigma_clod_free(thigma_clod* clod);
THIGMA_API double thigma_clod_radius(const thigma_clod* clod); /* [m]; 0 of NULL */
/* Levels with a mesh of their own; 0 of thigma_clod_exact and of NULL. */
THIGMA_API int32_t thigma_clod_level_count(const thigma_clod* clod);

/* ---- contacts ---- */

typedef struct thigma_query {
  uint32_t struct_size; /* sizeof(thigma_query) */
  int32_t is_exact;     /* 1: finest patches, what follows is ignored but step_time */
  double tolerance;     /* contacts are pairs at most this far apart [m] */
  double threshold;     /* s0, a fraction of the smaller radius */
  int64_t budget_tests; /* pairs looked at, at most; 0: no limit */
  double step_time;     /* from pose to pose [s] */
} thigma_query;
/* Sets struct_size and the defaults: exact, tolerance 0, threshold 0.025, 1 ms. */
THIGMA_API void thigma_query_init(thigma_query* query);

typedef struct thigma_contact {
  double point[3];       /* on the object [m; world] */
  double scene_point[3]; /* on the scene [m; world] */
  double normal[3];      /* out of the object, into the scene [world] */
  double depth;          /* positive where they overlap [m] */
  double bound;          /* of the error of depth, 0 of exact contacts [m] */
  int32_t object_level, scene_level;
} thigma_contact;

typedef struct thigma_tracker thigma_tracker;

/* Contacts of an object with a scene from frame to frame; it keeps what it needs of both.
 * scene_pose  of the scene; NULL: the identity */
THIGMA_API thigma_result thigma_tracker_create(const thigma_clod* object, const thigma_clod* scene,
                                               const double* scene_pose, const thigma_query* query,
                                               thigma_tracker** tracker);
THIGMA_API void thigma_tracker_free(thigma_tracker* tracker);
/* Contacts at a pose of the object.
 * contacts  room for `capacity`, filled from the first; NULL with 0
 * count     how many there are, which may be more
 * distance  NULL, or the least; infinite without a contact [m] */
THIGMA_API thigma_result thigma_tracker_contacts(thigma_tracker* tracker, const double* pose,
                                                 thigma_contact* contacts, int64_t capacity,
                                                 int64_t* count, double* distance);

/* ---- scenes and sessions ---- */

typedef struct thigma_scene thigma_scene;
typedef struct thigma_session thigma_session;

/* A scene file, or the name of a built-in scene; may take minutes where levels are built. */
THIGMA_API thigma_result thigma_scene_load(const char* path, thigma_scene** scene);
/* Two mesh files, the second at the identity. pose: of the first; NULL: the identity. */
THIGMA_API thigma_result thigma_scene_pair(const char* object, const char* against, double scale,
                                           const double* pose, thigma_scene** scene);
/* Two meshes from memory, the second at the identity; kept by the scene. Contacts are exact, the
 * object never enters. pose: of the first; NULL: the identity. */
THIGMA_API thigma_result thigma_scene_of_meshes(const thigma_mesh* object,
                                                const thigma_mesh* against, const double* pose,
                                                thigma_scene** scene);
THIGMA_API void thigma_scene_free(thigma_scene* scene); /* sessions of it go on */

typedef struct thigma_session_options {
  uint32_t struct_size;  /* sizeof(thigma_session_options) */
  int32_t has_threads;   /* 0: in lockstep, by thigma_session_step; 1: at the pace of the clock */
  const char* device;    /* address, such as "hand:" or "null:"; NULL: the scene's */
  const char* recording; /* path of an .mcap file to write; NULL: none */
  double duration;       /* [s]; 0: until it is finished */
  double rate;           /* haptic frames a second; 0: the scene's [Hz] */
  uint64_t seed;
} thigma_session_options;
THIGMA_API void thigma_session_options_init(thigma_session_options* options);

typedef struct thigma_handle {
  uint32_t struct_size; /* sizeof(thigma_handle) */
  uint32_t buttons;     /* 1: the hand holds the object */
  double pose[7];       /* [m; device frame] */
} thigma_handle;

typedef struct thigma_sample {
  uint32_t struct_size; /* sizeof(thigma_sample), set by the caller */
  int32_t fault;        /* 0: none */
  uint64_t frame;
  double time;              /* [s] */
  double handle[7];         /* [m; world] */
  double pose[7];           /* of the object's centre of mass [m; world] */
  double contact_wrench[6]; /* on the object about its centre of mass [N, N m; world] */
  double command[6];        /* sent to the hand, about the handle [N, N m; device frame] */
  double penetration;       /* -infinity: none near [m] */
  int64_t contacts;
} thigma_sample;

typedef struct thigma_summary {
  uint32_t struct_size; /* sizeof(thigma_summary), set by the caller */
  int32_t end;          /* 0 duration, 1 device finished, 2 stopped, 3 fault */
  uint64_t frames, missed;
  double seconds;
  double force_max, torque_max; /* [N, N m] */
  double penetration_max;       /* [m] */
  uint64_t state_hash;
} thigma_summary;

/* options  NULL: the defaults */
THIGMA_API thigma_result thigma_session_open(const thigma_scene* scene,
                                             const thigma_session_options* options,
                                             thigma_session** session);
/* Makes frames in lockstep.
 * handle  held for these frames; NULL: the device's own
 * sample  NULL, or the last of them
 * returns THIGMA_ENDED where the session ended before */
THIGMA_API thigma_result thigma_session_step(thigma_session* session, uint64_t frames,
                                             const thigma_handle* handle, thigma_sample* sample);
/* Starts the threads of a session that has them. */
THIGMA_API thigma_result thigma_session_start(thigma_session* session);
THIGMA_API int32_t thigma_session_is_running(const thigma_session* session); /* 0 of NULL */
/* The last frame, on threads a few milliseconds late; THIGMA_BAD_ARGUMENT before the first. */
THIGMA_API thigma_result thigma_session_last(const thigma_session* session, thigma_sample* sample);
/* Ends it with zero force and completes its recording. summary: NULL, or filled in. */
THIGMA_API thigma_result thigma_session_finish(thigma_session* session, thigma_summary* summary);
THIGMA_API void thigma_session_free(thigma_session* session); /* finishes it */

/* ---- axes of others; `from` may be `to` ----
 * Unity: left-handed, x right, y up, z forward [m]. Unreal: left-handed, x forward, y right, z up
 * [cm]. Forces and torques keep their units. */
THIGMA_API void thigma_pose_to_unity(const double* from, double* to);
THIGMA_API void thigma_pose_from_unity(const double* from, double* to);
THIGMA_API void thigma_wrench_to_unity(const double* from, double* to);
THIGMA_API void thigma_pose_to_unreal(const double* from, double* to);
THIGMA_API void thigma_pose_from_unreal(const double* from, double* to);
THIGMA_API void thigma_wrench_to_unreal(const double* from, double* to);

#ifdef __cplusplus
}
#endif
#endif
