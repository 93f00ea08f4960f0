// panels/knobs.h - a widget for every setting of physics::Accuracy.
#pragma once

#include "engine/physics/accuracy.h"

namespace brittle::panels {

/// Between Gui::begin and end. True if the user changed something; the result is within range.
bool showKnobs(physics::Accuracy& accuracy);

}  // namespace brittle::panels
