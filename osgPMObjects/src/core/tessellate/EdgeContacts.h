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

/// Ends of an edge, as numbers of points.
using EdgeEnds = std::array<std::uint32_t, 2>;

/// How two edges meet, other than in a common end. Exact.
struct EdgeContact
{
    std::array<bool, 2> endInFirst{};  ///< which ends of the second edge lie inside the first
    std::array<bool, 2> endInSecond{}; ///< and the other way round
    bool crosses = false;              ///< at a point inside both

    bool exists() const
    {
        return crosses || endInFirst[0] || endInFirst[1] || endInSecond[0] || endInSecond[1];
    }
};

EdgeContact contactOf(std::span<const glm::dvec2> points, const EdgeEnds& first, const EdgeEnds& second);

/// Calls `found` for each pair of edges with a contact, in a fixed order.
/// Cost: n log n for sorting, and a test for each pair whose boxes overlap in x.
void forEachContact(std::span<const glm::dvec2> points, std::span<const EdgeEnds> edges,
                    const std::function<void(std::uint32_t, std::uint32_t, const EdgeContact&)>& found);

} // namespace osgPMObjects::core
