#pragma once
// What pages are told of a run, and what they may choose in it.

#include <optional>
#include <string>
#include <vector>

#include "run_session.h"
#include "viewer/server/messages.h"

#include "thigma/dynamics/gains.h"

namespace thigma::app {

/// Surfaces and hierarchies of the run, which outlives the view.
live::SceneView view_of(const Run& run);

/// Who may move the object: the device the program was started with, the page, and a hand.
std::vector<std::string> devices_of(const Run& run);

/// What gains of this run are judged for, as far as the device is known; nothing for the direct
/// response, which has none. Thread [offline].
std::optional<GainTask> gains_of(const Run& run);

/// Responses by the names of --response, in the order of ResponseKind.
std::vector<std::string> response_choices();

/// What pages may choose that takes a new session.
std::vector<live::LiveParameter> choices_of(const Run& run);

/// Where the page is; beyond this machine it asks for a token.
live::WebAddress page_address(const RunOptions& options);

/// The line that says so. address: as the server has it.
std::string page_line(const RunOptions& options, const std::string& address);

/// A name no file has yet, in the user's folder for recordings, which is made where it is not
/// there, and takes files. Throws IoError.
std::string next_recording();

}  // namespace thigma::app
