// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// An edge by its lower and its higher end, as numbers of points.
struct UprightEdge
{
    std::uint32_t low, high;
};

/// The edge that a ray hits first which leaves `from` to the left (-x), a hair above it, so that it passes no point; among
/// edges that do not cross. Nothing when it hits none. Exact. Cost: linear. `edges`: low.y < high.y.
std::optional<std::size_t> firstEdgeLeft(std::span<const glm::dvec2> points,
                                         std::span<const UprightEdge> edges, const glm::dvec2& from);

} // namespace osgPMObjects::core
