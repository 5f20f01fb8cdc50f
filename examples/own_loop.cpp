// The two steps driven from one's own loop, without Session: what happens in a frame is yours.
#include <cstdio>
#include <memory>

#include "thigma/loop/contact_step.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/thigma.h"

using namespace thigma;

int main() {
  const Scene scene = load_scene("ellipsoid");
  SceneSession session = open_session(scene, {.device = "hand:"});
  const auto models = std::make_unique<Latest<LinearContactModel>>();
  const auto bodies = std::make_unique<Latest<StampedBody>>();
  const HapticPorts ports{session.device.get(), models.get(), bodies.get(), nullptr};
  HapticState state = initial_state(session.config.haptic, session.config.world_from_body);
  ContactScratch scratch;
  ContactSample contact;
  reserve_contact_scratch(session.config.contact, scratch);
  double largest = 0.0;
  for (int frame = 0; frame < 2000; ++frame) {
    contact_step(session.config.contact, {state.body, state.time, state.frame}, scratch, contact);
    models->publish(contact.model);
    const HapticSample sample =
        haptic_step(session.config.haptic, ports, {.now = 0.001 * frame}, state);
    largest = std::max(largest, sample.command.force.norm());
  }
  session.device->write({});  // zero force at the end
  std::printf("largest force %.2f N\n", largest);
}
