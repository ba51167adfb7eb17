// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// The ends of an edge, as point numbers.
using EdgeEnds = std::array<std::uint32_t, 2>;

/// The contact of two edges besides a common end. Exact.
struct EdgeContact
{
    std::array<bool, 2> endInFirst{};  ///< by end of the second edge: whether it lies inside the first
    std::array<bool, 2> endInSecond{}; ///< by end of the first edge: whether it lies inside the second
    bool crosses = false;              ///< whether they cross at a point inside both

    bool exists() const
    {
        return crosses || endInFirst[0] || endInFirst[1] || endInSecond[0] || endInSecond[1];
    }
};

EdgeContact contactOf(std::span<const glm::dvec2> points, const EdgeEnds& first, const EdgeEnds& second);

/// Calls `found` for each pair of edges that have a contact, in a fixed order.
/// Cost: n log n for sorting, and a test for each pair whose boxes overlap in x.
void forEachContact(std::span<const glm::dvec2> points, std::span<const EdgeEnds> edges,
                    const std::function<void(std::uint32_t, std::uint32_t, const EdgeContact&)>& found);

} // namespace osgPMObjects::core
