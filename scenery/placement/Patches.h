// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace scenery
{

/// Whether a place lies in one of the irregular patches that cover about `share` of the plane: value noise of two octaves, the coarser with
/// a grid of `sizeM`, above a threshold. The same seed gives the same patches, whoever asks.
bool isInPatch(glm::dvec2 place, double sizeM, double share, std::uint64_t seed);

} // namespace scenery
