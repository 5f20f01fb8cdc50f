#pragma once
// A scene: what is grasped, what stands around it, and every number of the interaction.

#include <optional>
#include <string>
#include <vector>

#include "thigma/contact/resolution.h"
#include "thigma/loop/haptic_params.h"
#include "thigma/math/pose.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/models/model_request.h"
#include "thigma/scene/simulated_body.h"
#include "thigma/session/session.h"

namespace thigma {

struct HapticTexture;

/// What coefficients two materials make together.
enum class CombineRule : std::uint8_t { geometric, average, minimum, maximum };

/// Coefficients of two surfaces. By the geometric mean a surface without friction slides on
/// everything, and two of one material have what the material has.
/// Thread    [offline]; valid where both are.
Friction combined(const Friction& a, const Friction& b, CombineRule rule);

/// What an object is made of.
struct Material {
  Friction friction;
  double restitution = 0.0;  // share of an approach speed that comes back, 0..1
  // how it rings when it is met; what is not set is that of TapChoice
  std::optional<double> tap_amplitude{}, tap_frequency{}, tap_decay{};
};

/// One object of a scene: where its surface comes from and where it stands.
struct SceneObject {
  std::string name;  // for reports; the mesh's own when the scene gives none
  std::string mesh;  // path that can be opened, or the procedural address as given
  std::optional<models::ModelRequest> model;  // set: procedural, `mesh` is no file
  bool is_textured = false;                   // `mesh` is a .tex file or, with the next, procedural
  std::optional<models::TexturedRequest> textured_model;
  std::string level_textures;        // path of the .tex file over the levels of `mesh`; empty: none
  double unit_scale = 1.0;           // metres per unit of the mesh, > 0
  Pose world_from_mesh;              // of the scaled mesh
  std::optional<Material> material;  // otherwise the friction of ContactGains
  bool has_relief() const { return is_textured || !level_textures.empty(); }
};

/// A response by the name that scenes and --response have for it.
struct ResponseName {
  const char* name;
  ResponseKind kind;
};
inline constexpr ResponseName kResponseNames[] = {
    {"penalty", ResponseKind::coupled},     {"coupled", ResponseKind::coupled},  // its older name
    {"direct", ResponseKind::direct},       {"constraint", ResponseKind::constrained},
    {"potential", ResponseKind::potential},
};

/// Response of a name, none for another word. Thread [offline].
std::optional<ResponseKind> response_of(const std::string& name);

/// Contact response. What is not set follows from the object's size, default_gains.
struct ContactGains {
  std::optional<double> stiffness;      // k [N/m]
  std::optional<double> damping;        // b [N s/m]; otherwise from damping_ratio
  std::optional<double> damping_ratio;  // b = 2 ratio sqrt(k m)
  std::optional<double> tolerance;      // d [m]
  int max_clusters = 5;                 // K
  // k and b belong to the contact as a whole; false: to each cluster, as in Eq. 5.37
  bool is_divided_among_clusters = true;
  // contacts of large patches over the area these share; false: one point a pair
  bool distributes_wide_contacts = true;
  Resolution resolution{.is_exact = false};  // levels of detail at s0 = 2.5 %
  std::optional<ResponseKind> response;      // not set: default_response
  // Contacts are carried along by this share of the look-ahead (Resolution::carry). Not set: as
  // `resolution` says, or, with the constrained response, a tenth
  std::optional<double> carry;
  // The constrained response is exact unless this asks for levels far away, at `resolution`.
  bool has_levels_far = false;
  Friction friction{};                           // of objects without a material
  CombineRule combine = CombineRule::geometric;  // of two materials
  // of the potential response, see PotentialLaw; the area otherwise follows from the object's size
  std::optional<int> exponent;  // p
  std::optional<double> area;   // A0 [m^2]
  TextureParams texture;        // how relief is looked for
};

/// Virtual coupling. What is not set follows from the object's size, default_gains.
struct CouplingGains {
  std::optional<double> linear_stiffness;   // k_c [N/m]
  std::optional<double> linear_damping;     // b_c [N s/m]; otherwise from damping_ratio
  std::optional<double> angular_stiffness;  // k_theta [N m/rad]
  std::optional<double> angular_damping;    // b_theta [N m s/rad]; otherwise from damping_ratio
  // b_c = 2 ratio sqrt(k_c m), b_theta = 2 ratio sqrt(k_theta I)
  std::optional<double> damping_ratio;
  std::optional<double> max_force;   // where the linear spring levels off [N; virtual]
  std::optional<double> max_torque;  // and the angular one [N m; virtual]
  bool is_saturated = true;          // false: springs stay linear
};

/// The device and how its workspace lies in the world.
struct DeviceChoice {
  std::string uri = "hand:";
  std::optional<double> motion_scale;  // s [virtual m / device m]
  std::optional<double> force_scale;   // f [device N / virtual N]; otherwise 1 / s
  Pose world_from_device;
  // from the object towards the scene [world]; otherwise along the closest points
  std::optional<Vec3> approach;
  GraspPlace grasp_place = GraspPlace::grasp_point;
  double turn_rate = kButtonTurnRate;  // [rad/s]
};

/// Taps: what of impacts is felt beyond the coupling. Off, nobody feels any.
struct TapChoice {
  bool is_on = false;
  Tap usual{.amplitude = 5.0};  // of objects whose material does not tell
};

/// A whole scene, as a file or the command line gives it.
struct SceneDescription {
  std::string file;                  // where it was read, for reports
  std::string text;                  // the TOML it was read from; empty: made in code
  std::string title;                 // one line
  bool repairs = false;              // meshes that need it are repaired: they came with the scene
  SceneObject object;                // the grasped one
  std::vector<SceneObject> statics;  // in contact order: body 0, 1, ...
  std::optional<double> mass;        // of the object [kg]
  // instead of mass, for closed meshes [kg/m^3]; neither: kDefaultMass
  std::optional<double> density;
  std::optional<Vec3> grasp_point;  // [m; scaled mesh frame]; otherwise the centre of mass
  Vec3 gravity = Vec3::Zero();      // [m/s^2; world]
  bool has_auto_gains = false;      // gains that are not set follow from the device (docs/gains.md)
  ContactGains contact;
  CouplingGains coupling;
  DeviceChoice device;
  TapChoice taps;
  SafetyLimits safety;
  bool is_strict = false;   // late frames are faults even where the device holds nobody
  bool is_passive = false;  // with the passivity controller
  std::optional<SimulatedBody> simulation;     // set: nobody holds the object
  double rate = 1000.0;                        // of haptic frames [Hz]
  int contact_every = 1, contact_latency = 1;  // lockstep, see SessionConfig
};

/// Friction of the object on each static body of a scene, in their order.
/// errors    InputError for coefficients that are negative, not finite or in the wrong order
/// Thread    [offline]
std::vector<Friction> pair_friction(const SceneDescription& scene);

/// What the object does where it meets each static body: the larger restitution of the two, their
/// taps by the geometric mean. Empty where nothing throws back and nothing taps.
/// errors    InputError for numbers out of range
/// Thread    [offline]
std::vector<ImpactPair> pair_impacts(const SceneDescription& scene);

/// Whether anything of the scene has a texture.
bool has_relief(const SceneDescription& scene);

/// The response of a scene that names none: constrained, but coupled where that cannot be: relief
/// that is used, and what moves by itself. Thread [offline].
ResponseKind default_response(const SceneDescription& scene, bool uses_relief);

inline constexpr double kDefaultMass = 0.010;  // of a grasped object [kg] (Sec. 5.5)

/// What a session has to know of the grasped object's surface.
struct ObjectMeasure {
  MassProperties measure;  // for unit density
  Ball ball;               // smallest enclosing
};

/// An object's surface and size.
struct LoadedObject : ObjectMeasure {
  TriangleMesh mesh;  // scaled [m; mesh frame]
};

/// Reads or makes the texture of a textured object, scaled.
/// Thread [offline]; InputError as read_texture and make_textured_model.
HapticTexture load_texture(const SceneObject& object);

/// Reads or makes the surface of an object; of a textured one the coarse surface.
/// Thread [offline]; InputError as load_usable_mesh and make_model.
LoadedObject load_object(const SceneObject& object, bool repair = false);

/// Gains for a grasped object of this radius, in the virtual world.
///
/// The text's numbers (Sec. 5.5) hold for hand-sized objects: 10 g, contact 2 to 5 kN/m, coupling
/// 300 N/m (it uses 200 to 500), saturation 4 N. Objects of 2.5 to 10 cm radius keep motion scale s
/// = 1; others are brought into that range. Lengths and forces then go with s, so that stiffness,
/// mass and every frequency stay, and torques and k_theta go with s^2. d = 1 % of the radius; k
/// = 1.25 s / d within 2 to 5 kN/m: a press of 1 N then leaves the surfaces apart, which is also
/// where the query is cheap. k_theta = 0.3 k_c radius^2, at most 0.6 s^2 N m/rad: the text's for
/// its spoon.
struct DefaultGains {
  double motion_scale = 1.0;  // s
  double contact_stiffness = 2000.0, contact_damping_ratio = 0.7;
  double tolerance = 0.0;           // [m]
  double contact_area = 0.0;        // A0 of the potential response [m^2]
  double linear_stiffness = 300.0;  // [N/m]
  double angular_stiffness = 0.0;   // [N m/rad]
  double damping_ratio = 0.7;       // of both coupling springs
  double max_force = 4.0;           // [N; virtual]
  double max_torque = 0.15;         // [N m; virtual]
};
DefaultGains default_gains(double radius);

/// Coupling of a grasped body, by the gains given and the defaults for the others. Saturated, it is
/// linear up to half of the greatest force and levels off beyond (Fig. 5.4).
/// Thread  [offline]; InputError where the gains allow no saturation.
Coupling make_coupling(const CouplingGains& given, const DefaultGains& gains,
                       const RigidBody& body);

/// Everything of a session that a scene and its object decide; hierarchies and static bodies are
/// the caller's to add.
///
/// Body axes are the mesh's, the origin is the centre of mass: haptic.body, contact.body_from_mesh,
/// world_from_body. With has_auto_gains, gains left open follow from the device of the scene's
/// address, the object and the rate (dynamics/gains.h); otherwise from the object's size.
/// errors    InputError: density of an open mesh, a mesh without volume, gains that contradict each
///           other; with has_auto_gains also DeviceAddressError and DeviceUnavailable
/// Thread    [offline]
SessionConfig make_session_config(const SceneDescription& scene, const ObjectMeasure& object);

/// The same with the surfaces: all of a session that does not depend on the device.
///
/// hierarchy  of the grasped object; outlives the session
/// statics    hierarchies and poses, in the order of the scene
SessionConfig make_session_config(const SceneDescription& scene, const ObjectMeasure& object,
                                  const ClodHierarchy& hierarchy, std::vector<SceneBody> statics);

/// The scene of `run --object A --against B`: B at the identity, A at `pose`, both scaled, all
/// gains by default.
///
/// object, against  mesh files or procedural addresses
/// errors           InputError for a missing file, an unknown model or a scale that is not positive
/// Thread           [offline]
SceneDescription scene_from_pair(const std::string& object, const std::string& against,
                                 double scale = 1.0, const Pose& pose = {});

}  // namespace thigma
