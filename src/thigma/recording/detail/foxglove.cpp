#include "thigma/recording/detail/foxglove.h"

#include <charconv>
#include <cmath>

#include "thigma/recording/detail/json_text.h"

namespace thigma::detail {
namespace {

struct Color {
  double r, g, b, a;
};
constexpr Color kObjectColor{0.95, 0.60, 0.25, 1.0};
constexpr Color kSceneColor{0.62, 0.66, 0.72, 1.0};
constexpr Color kForceColor{0.85, 0.12, 0.20, 1.0};
constexpr Color kContactColor{0.10, 0.45, 0.85, 1.0};

/// Opens an object under a key, calls `fill` with it and closes it.
template <class Fill>
void put_object(JsonObject& json, std::string& out, std::string_view key, const Fill& fill) {
  json.key(key);
  JsonObject inner(out);
  fill(inner);
  inner.close();
}

void put_time(JsonObject& json, std::string& out, std::string_view key, std::uint64_t time) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  put_object(json, out, key, [&](JsonObject& stamp) {
    stamp.integer("sec", static_cast<long long>(time / kSecond));
    stamp.integer("nsec", static_cast<long long>(time % kSecond));
  });
}

void put_point(JsonObject& json, std::string& out, std::string_view key, const Vec3& p) {
  put_object(json, out, key, [&](JsonObject& point) {
    point.number("x", p.x());
    point.number("y", p.y());
    point.number("z", p.z());
  });
}

void put_turn(JsonObject& json, std::string& out, std::string_view key, const Quat& q) {
  put_object(json, out, key, [&](JsonObject& turn) {
    turn.number("x", q.x());
    turn.number("y", q.y());
    turn.number("z", q.z());
    turn.number("w", q.w());
  });
}

void put_color(JsonObject& json, std::string& out, const Color& c) {
  put_object(json, out, "color", [&](JsonObject& color) {
    color.number("r", c.r);
    color.number("g", c.g);
    color.number("b", c.b);
    color.number("a", c.a);
  });
}

void put_pose(JsonObject& json, std::string& out, const Pose& pose) {
  put_object(json, out, "pose", [&](JsonObject& inner) {
    put_point(inner, out, "position", pose.position);
    put_turn(inner, out, "orientation", pose.orientation);
  });
}

void put_transform(std::string& out, std::uint64_t time, std::string_view child, const Pose& pose) {
  JsonObject json(out);
  put_time(json, out, "timestamp", time);
  json.word("parent_frame_id", "world");
  json.word("child_frame_id", child);
  put_point(json, out, "translation", pose.position);
  put_turn(json, out, "rotation", pose.orientation);
  json.close();
}

/// A scene of one entity, which replaces that of the same name; `fill` writes what is in it.
template <class Fill>
void put_entity(std::string& out, std::uint64_t time, std::string_view id, std::string_view frame,
                const Fill& fill) {
  JsonObject json(out);
  json.key("deletions");
  out += "[]";
  json.key("entities");
  out += '[';
  JsonObject entity(out);
  put_time(entity, out, "timestamp", time);
  entity.word("frame_id", frame);
  entity.word("id", id);
  put_time(entity, out, "lifetime", 0);  // until it is replaced
  entity.flag("frame_locked", true);     // goes along with its frame
  entity.key("metadata");
  out += "[]";
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"}) {
    entity.key(kind);
    out += '[';
    fill(std::string_view(kind));
    out += ']';
  }
  entity.close();
  out += ']';
  json.close();
}

template <class Items, class Put>
void put_items(JsonObject& json, std::string& out, std::string_view key, const Items& items,
               const Put& put) {
  json.key(key);
  out += '[';
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += ',';
    put(items[i]);
  }
  out += ']';
}

/// A picture shows no more than single precision.
void put_single(std::string& out, float value) {
  char text[24];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

void put_triangles(std::string& out, const RecordedSurface& surface) {
  JsonObject json(out);
  put_pose(json, out, {});
  put_items(json, out, "points", surface.positions, [&](const Vec3& p) {
    JsonObject point(out);
    for (int axis = 0; axis < 3; ++axis) {
      point.key(std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
      put_single(out, static_cast<float>(p[axis]));
    }
    point.close();
  });
  put_color(json, out, surface.is_object ? kObjectColor : kSceneColor);
  json.key("colors");
  out += "[]";
  put_items(json, out, "indices", surface.triangles, [&](const std::array<std::int32_t, 3>& t) {
    out += std::to_string(t[0]) + ',' + std::to_string(t[1]) + ',' + std::to_string(t[2]);
  });
  json.close();
}

void put_ball(std::string& out, const Vec3& at, double size) {
  JsonObject json(out);
  put_pose(json, out, {at, Quat::Identity()});
  put_point(json, out, "size", Vec3::Constant(size));
  put_color(json, out, kContactColor);
  json.close();
}

}  // namespace

void put_transforms(std::string& out, std::uint64_t time, const HapticSample& s) {
  JsonObject json(out);
  json.key("transforms");
  out += '[';
  put_transform(out, time, "object", {s.body.position, s.body.orientation});
  out += ',';
  put_transform(out, time, "hand", s.handle.pose);
  out += ']';
  json.close();
}

void put_surface(std::string& out, const RecordedSurface& surface) {
  put_entity(out, 0, surface.id, surface.is_object ? "object" : "world",
             [&](std::string_view kind) {
               if (kind == "triangles") put_triangles(out, surface);
             });
}

void put_force(std::string& out, std::uint64_t time, const HapticSample& s, double radius) {
  const double length = s.contact.force.norm() / kForcePerRadius * radius;
  put_entity(out, time, "force", "world", [&](std::string_view kind) {
    if (kind != "arrows" || !(length > 0.0) || !std::isfinite(length)) return;
    JsonObject json(out);
    const Quat along = Quat::FromTwoVectors(Vec3::UnitX(), s.contact.force);
    put_pose(json, out, {s.body.position, along});
    json.number("shaft_length", 0.8 * length);
    json.number("shaft_diameter", 0.03 * radius);
    json.number("head_length", 0.2 * length);
    json.number("head_diameter", 0.07 * radius);
    put_color(json, out, kForceColor);
    json.close();
  });
}

void put_contacts(std::string& out, std::uint64_t time, const ContactSample& sample,
                  double radius) {
  put_entity(out, time, "contacts", "world", [&](std::string_view kind) {
    if (kind != "spheres") return;
    bool is_first = true;
    const auto put = [&](const Vec3& at) {
      if (!is_first) out += ',';
      is_first = false;
      put_ball(out, at, 0.03 * radius);
    };
    for (const PlaneTerm& plane : sample.model.planes) put(plane.scene_point);
    for (const ContactRow& row : sample.model.constraints.rows) put(row.scene_point);
  });
}

// Names and types of the fields are those of Foxglove's public schemas; the text is ours.
std::string_view transforms_schema() {
  return R"({"title":"foxglove.FrameTransforms","type":"object","properties":{"transforms":{)"
         R"("type":"array","items":{"title":"foxglove.FrameTransform","type":"object",)"
         R"("properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{)"
         R"("type":"integer","minimum":0},"nsec":{"type":"integer","minimum":0,)"
         R"("maximum":999999999}}},"parent_frame_id":{"type":"string"},"child_frame_id":{)"
         R"("type":"string"},"translation":{"title":"foxglove.Vector3","type":"object",)"
         R"("properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},)"
         R"("rotation":{"title":"foxglove.Quaternion","type":"object","properties":{"x":{)"
         R"("type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{)"
         R"("type":"number"}}}}}}}})";
}

std::string_view scene_schema() {
  return R"({"title":"foxglove.SceneUpdate","type":"object","$defs":{"time":{"title":"time",)"
         R"("type":"object","properties":{"sec":{"type":"integer","minimum":0},"nsec":{)"
         R"("type":"integer","minimum":0,"maximum":999999999}}},"duration":{)"
         R"("title":"duration","type":"object","properties":{"sec":{"type":"integer"},"nsec":{)"
         R"("type":"integer","minimum":0,"maximum":999999999}}},"point":{)"
         R"("title":"foxglove.Point3","type":"object","properties":{"x":{"type":"number"},)"
         R"("y":{"type":"number"},"z":{"type":"number"}}},"color":{"title":"foxglove.Color",)"
         R"("type":"object","properties":{"r":{"type":"number"},"g":{"type":"number"},"b":{)"
         R"("type":"number"},"a":{"type":"number"}}},"pose":{"title":"foxglove.Pose",)"
         R"("type":"object","properties":{"position":{"$ref":"#/$defs/point"},"orientation":{)"
         R"("title":"foxglove.Quaternion","type":"object","properties":{"x":{"type":"number"},)"
         R"("y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}}}}},)"
         R"("properties":{"deletions":{"type":"array","items":{)"
         R"("title":"foxglove.SceneEntityDeletion","type":"object"}},"entities":{)"
         R"("type":"array","items":{"title":"foxglove.SceneEntity","type":"object",)"
         R"("properties":{"timestamp":{"$ref":"#/$defs/time"},"frame_id":{"type":"string"},)"
         R"("id":{"type":"string"},"lifetime":{"$ref":"#/$defs/duration"},"frame_locked":{)"
         R"("type":"boolean"},"metadata":{"type":"array","items":{)"
         R"("title":"foxglove.KeyValuePair","type":"object"}},"arrows":{"type":"array",)"
         R"("items":{"title":"foxglove.ArrowPrimitive","type":"object","properties":{"pose":{)"
         R"("$ref":"#/$defs/pose"},"shaft_length":{"type":"number"},"shaft_diameter":{)"
         R"("type":"number"},"head_length":{"type":"number"},"head_diameter":{)"
         R"("type":"number"},"color":{"$ref":"#/$defs/color"}}}},"cubes":{"type":"array"},)"
         R"("spheres":{"type":"array","items":{"title":"foxglove.SpherePrimitive",)"
         R"("type":"object","properties":{"pose":{"$ref":"#/$defs/pose"},"size":{)"
         R"("title":"foxglove.Vector3","type":"object","properties":{"x":{"type":"number"},)"
         R"("y":{"type":"number"},"z":{"type":"number"}}},"color":{"$ref":"#/$defs/color"}}}},)"
         R"("cylinders":{"type":"array"},"lines":{"type":"array"},"triangles":{"type":"array",)"
         R"("items":{"title":"foxglove.TriangleListPrimitive","type":"object","properties":{)"
         R"("pose":{"$ref":"#/$defs/pose"},"points":{"type":"array","items":{)"
         R"("$ref":"#/$defs/point"}},"color":{"$ref":"#/$defs/color"},"colors":{)"
         R"("type":"array","items":{"$ref":"#/$defs/color"}},"indices":{"type":"array",)"
         R"("items":{"type":"integer","minimum":0}}}}},"texts":{"type":"array"},"models":{)"
         R"("type":"array"}}}}}})";
}

}  // namespace thigma::detail
