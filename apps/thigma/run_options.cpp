#include "run_options.h"

#include <charconv>
#include <cmath>

#include "viewer/server/origin.h"

#include "thigma/core/error.h"
#include "thigma/scene/scene_description.h"

namespace thigma::app {

void add_run_options(CLI::App& verb, RunOptions& o) {
  verb.add_option("scene", o.scene,
                  "scene file (.toml), a packed scene or a recording (.mcap), or the name of a "
                  "built-in scene, such as jaws");
  verb.add_option("--object", o.object, "mesh to hold, instead of a scene");
  verb.add_option("--against", o.against, "mesh that stands still, with --object");
  verb.add_option("--scale", o.scale,
                  "metres per unit of both meshes, with --object; without it neither may be larger "
                  "than 1 m in radius");
  verb.add_option("--pose", o.pose_text, "x,y,z,qx,qy,qz,qw of the object [m], with --object");
  verb.add_option(
      "--device", o.device,
      "hand: (simulated), web: (mouse on the page), script:FILE, replay:FILE, null:, or "
      "one that is plugged in, such as dhd:0 (thigma devices lists them)");
  verb.add_option("--duration", o.duration, "seconds; without it until Ctrl-C");
  verb.add_flag("--headless", o.is_headless, "no page, no live table; ends with the summary");
  verb.add_flag("--lockstep", o.is_lockstep,
                "virtual clock: as fast as it goes, same inputs same bits");
  verb.add_option("--rate", o.rate, "haptic frames a second");
  verb.add_option("--record", o.record, "write a recording (.mcap)");
  verb.add_option("--replay", o.replay,
                  "show a recording (.mcap) on the page, with a time slider, before any session");
  verb.add_option("--histograms", o.histograms, "write the durations of every stage (.csv)");
  verb.add_option("--spin", o.spin,
                  "microseconds polled before each deadline; by default as wake-ups ask for");
  add_resolution_options(verb, o.resolution);
  verb.add_flag("--no-blend", o.has_no_blend,
                "contacts change their level of detail at once, not gradually");
  verb.add_option(
      "--response", o.response,
      "constraint: the object never enters, felt through a simulated body and its "
      "coupling (default, but where something has relief or levels are asked for); "
      "potential: springs over the area of contact, whose force is the gradient of one "
      "energy; penalty: clusters push like springs, felt through the same coupling (coupled is "
      "its older name); direct: contact forces as they are");
  verb.add_option("--friction", o.friction,
                  "Coulomb's coefficient of every contact, whatever the materials say");
  verb.add_flag(
      "--passivity", o.is_passive,
      "let late samples give no energy away: damps the handle, softens what is not backed");
  verb.add_flag("--no-cache", o.has_no_cache, "build levels of detail anew and keep nothing");
  verb.add_flag("--repair", o.is_repair, "repair meshes that need it");
  verb.add_option("--fault", o.fault_text,
                  "make the device fail, to see what the safety rules do: unplug@T, nan@T, "
                  "stall=S@T, hang=S@T, comma-separated; at T seconds, for S seconds");
  verb.add_option("--texture", o.texture,
                  "on: refuse a scene without textures; off: coarse surfaces alone");
  verb.add_option("--port", o.port, "of the page on this machine; 0 or none: any free one");
  verb.add_option("--bind", o.bind,
                  "address of this machine at which other machines reach the page, 0.0.0.0 for all "
                  "of them: they watch, and control with the token of the address printed");
  verb.add_flag("--embed", o.is_embedded,
                "pages of this machine, such as a notebook, may show the page in a frame");
}

bool has_page(const RunOptions& o) { return !o.is_headless && (!o.is_lockstep || o.port); }

std::string check_run_options(const RunOptions& o) {
  const bool has_pair = !o.object.empty() || !o.against.empty();
  if (!o.replay.empty() && !has_page(o))
    return "--replay belongs to the page, which --headless and --lockstep leave out; thigma replay "
           "runs a recording again without it";
  if (!o.replay.empty() && !has_pair && o.scene.empty()) return {};
  if (has_pair == !o.scene.empty()) {
    return has_pair ? "run takes a scene or --object with --against, not both"
                    : "run needs a scene, or --object MESH --against MESH";
  }
  if (has_pair && (o.object.empty() || o.against.empty()))
    return "--object and --against belong together";
  if (!has_pair && (!o.pose_text.empty() || o.scale)) {
    return "--pose and --scale belong to --object and --against; a scene file has its own";
  }
  if (o.scale && !(*o.scale > 0.0 && std::isfinite(*o.scale)))
    return "--scale must be a number above 0";
  if (o.duration && !(*o.duration > 0.0 && *o.duration < 1e9)) {
    return "--duration must be above 0 and below 1e9 seconds; without it the run lasts until "
           "Ctrl-C";
  }
  // As of solver.rate in a scene: more slowly, a contact model is too old before the next frame.
  if (o.rate && !(*o.rate >= 50.0 && *o.rate <= 20000.0)) return "--rate must be 50 to 20000 Hz";
  if (o.spin && !(*o.spin >= 0.0 && *o.spin <= 20000.0)) return "--spin must be 0 to 20000 us";
  if (!o.response.empty() && !response_of(o.response)) return kWrongResponse;
  if (o.friction && !(*o.friction >= 0.0 && std::isfinite(*o.friction)))
    return "--friction must be a number, 0 or more";
  Resolution resolution;
  const std::string wrong = apply(o.resolution, resolution);
  if (!wrong.empty()) return wrong;
  if (!o.texture.empty() && o.texture != "on" && o.texture != "off")
    return "--texture is on or off";
  if (o.port && o.is_headless) return "--port belongs to the page, which --headless leaves out";
  if (!o.bind.empty() && !has_page(o))
    return "--bind belongs to the page, which --headless and --lockstep leave out";
  if (!o.bind.empty() && !live::is_address(o.bind))
    return "--bind must be a numeric address of this machine, such as 192.168.0.2 or 0.0.0.0";
  if (o.is_embedded && !has_page(o))
    return "--embed belongs to the page, which --headless and --lockstep leave out";
  if (!o.pose_text.empty() && !parse_pose(o.pose_text))
    return "--pose must be seven numbers: x,y,z,qx,qy,qz,qw";
  return {};
}

std::optional<Pose> parse_pose(const std::string& text) {
  double v[7];
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < 7; ++i) {
    if (i > 0) {
      if (at == end || *at != ',') return std::nullopt;
      ++at;
    }
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, v[i]);
    if (error != std::errc{} || !std::isfinite(v[i])) return std::nullopt;
    at = next;
  }
  if (at != end) return std::nullopt;
  const Quat q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1.0) <= 1e-6)) {
    throw InputError("--pose: quaternion of length " + std::to_string(q.norm()) +
                     ", expected 1 to 1e-6");
  }
  return Pose{Vec3(v[0], v[1], v[2]), q.normalized()};
}

}  // namespace thigma::app
