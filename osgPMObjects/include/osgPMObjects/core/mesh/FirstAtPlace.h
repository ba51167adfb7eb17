// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/HashIndex.h>

namespace osgPMObjects::core
{

/// Returns by position the first one with equal coordinates: splits have duplicated some. Cost: linear.
inline std::vector<std::uint32_t> firstAtPlace(std::span<const glm::dvec3> positions)
{
    const auto hashOf = [&](std::uint32_t i)
    { return stir(stir(stir(0, bitsOf(positions[i].x)), bitsOf(positions[i].y)), bitsOf(positions[i].z)); };
    HashIndex index(positions.size());
    std::vector<std::uint32_t> first;
    first.reserve(positions.size());
    for (std::uint32_t p = 0; p < positions.size(); ++p)
        first.push_back(index.findOrAdd(
            p, hashOf(p), [&](std::uint32_t i) { return positions[i] == positions[p]; }, hashOf));
    return first;
}

} // namespace osgPMObjects::core
