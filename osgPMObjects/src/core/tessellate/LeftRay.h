// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// An edge given by its lower and its upper end, as point numbers.
struct UprightEdge
{
    std::uint32_t low, high;
};

/// Returns the first edge that a ray from `from` to the left (-x) hits; nothing if it hits none. The ray lies
/// an infinitesimal step above `from`, so that it passes through no point. The edges must not cross, and have
/// low.y < high.y. Exact. Cost: linear.
std::optional<std::size_t> firstEdgeLeft(std::span<const glm::dvec2> points,
                                         std::span<const UprightEdge> edges, const glm::dvec2& from);

} // namespace osgPMObjects::core
