/* A box led onto a plate, a frame at a time, and their contacts: in C. */
#include <stdio.h>
#include <stdlib.h>
#include <thigma/thigma_c.h>

static void check(thigma_result result) {
  if (result == THIGMA_OK) return;
  fprintf(stderr, "%s\n", thigma_last_error());
  exit(1);
}

int main(int argc, char** argv) {
  if (argc != 3) return 2; /* two mesh files */
  const double above[7] = {0, 0, 0.03, 0, 0, 0, 1};
  thigma_scene* scene;
  thigma_session* session;
  thigma_session_options options;
  check(thigma_scene_pair(argv[1], argv[2], 1.0, above, &scene));
  thigma_session_options_init(&options);
  options.device = "null:";
  check(thigma_session_open(scene, &options, &session));
  thigma_handle handle = {sizeof handle, 1, {0, 0, 0, 0, 0, 0, 1}};
  thigma_sample sample = {.struct_size = sizeof sample};
  for (int i = 0; i < 1000; ++i) {
    handle.pose[2] = -2e-5 * i;
    check(thigma_session_step(session, 1, &handle, &sample));
  }
  thigma_summary summary = {.struct_size = sizeof summary};
  check(thigma_session_finish(session, &summary));
  thigma_session_free(session);
  thigma_scene_free(scene);
  printf("pressed with %.2f N at %.2f mm\n", sample.command[2], 1e3 * sample.pose[2]);

  thigma_mesh *box, *plate;
  thigma_clod *object, *against;
  thigma_tracker* tracker;
  thigma_query query;
  thigma_contact contacts[64];
  int64_t count;
  double distance;
  check(thigma_mesh_load(argv[1], 1.0, &box));
  check(thigma_mesh_load(argv[2], 1.0, &plate));
  check(thigma_clod_exact(box, &object));
  check(thigma_clod_exact(plate, &against));
  thigma_query_init(&query);
  query.tolerance = 0.002;
  check(thigma_tracker_create(object, against, NULL, &query, &tracker));
  check(thigma_tracker_contacts(tracker, sample.pose, contacts, 64, &count, &distance));
  printf("%d contacts, distance %.2f mm\n", (int)count, 1e3 * distance);
  thigma_tracker_free(tracker);
  thigma_clod_free(object), thigma_clod_free(against);
  thigma_mesh_free(box), thigma_mesh_free(plate);
  return count > 0 && summary.frames == 1000 ? 0 : 1;
}
