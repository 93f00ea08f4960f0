// physics/ids.h - handles of what a world holds. Zero is null; a handle to something gone is detected.
#pragma once

#include <cstdint>

#include "engine/core/handle.h"

namespace brittle::physics {

using BodyHandle = Handle<struct BodyTag>;
using ShapeHandle = Handle<struct ShapeTag>;
using ContactHandle = Handle<struct ContactTag>;
using JointHandle = Handle<struct JointTag>;
using DriveHandle = Handle<struct DriveTag>;

/// Where there is none, of indices that are no handles.
inline constexpr std::uint32_t kNoProxy = 0xffffffff;    // a shape's leaf in the broad phase
inline constexpr std::uint32_t kNoContact = 0xffffffff;  // the end of a shape's list of contacts
inline constexpr std::uint32_t kNoStrike = 0xffffffff;   // a contact with nothing breakable

}  // namespace brittle::physics
