// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace scenery
{

/// Returns whether a point is in one of the irregular patches that cover about `share` of the plane: value
/// noise of two octaves above a threshold, the coarser octave with a grid of `sizeM`. The same seed gives the
/// same patches.
bool isInPatch(glm::dvec2 place, double sizeM, double share, std::uint64_t seed);

} // namespace scenery
