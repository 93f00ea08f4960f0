// physics/ids.h - handles of what a world holds. Zero is null; a handle to something gone is detected.
#pragma once

#include "engine/core/handle.h"

namespace brittle::physics {

using BodyHandle = Handle<struct BodyTag>;
using ShapeHandle = Handle<struct ShapeTag>;
using ContactHandle = Handle<struct ContactTag>;
using JointHandle = Handle<struct JointTag>;
using DriveHandle = Handle<struct DriveTag>;

}  // namespace brittle::physics
