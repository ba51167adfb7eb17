// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/vec2.hpp>

namespace worldmaking
{

/// A place on earth to a centimetre, by which points in common are found.
using PlaceKey = std::pair<std::int64_t, std::int64_t>;

/// `degrees`: east and north (WGS84).
inline PlaceKey placeKeyOf(const glm::dvec2& degrees)
{
    constexpr double kPerDegree = 1e7;
    return {std::llround(degrees.x * kPerDegree), std::llround(degrees.y * kPerDegree)};
}

} // namespace worldmaking
