// SPDX-License-Identifier: Apache-2.0
#include "MaterialContrast.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace osgPMObjects::core
{

namespace
{

/// A difference of a channel that counts in full.
constexpr float kDistinct = 0.25f;

double contrastOf(const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 away = glm::abs(a - b);
    return std::min(1.0f, std::max({away.r, away.g, away.b}) / kDistinct);
}

} // namespace

std::vector<double> materialContrasts(std::span<const Material> materials, std::span<const glm::vec3> colours,
                                      std::span<const double> areas)
{
    std::vector<double> contrasts(materials.size(), 1.0);
    const std::size_t known = std::min(materials.size(), colours.size());
    const auto isLarger = [&](std::size_t a, std::size_t b) // of equal ones, the first counts as larger
    { return std::pair(areas[a], b) > std::pair(areas[b], a); };
    for (std::size_t own = 0; own < known; ++own)
        for (std::size_t other = 0; other < known; ++other)
            if (isLarger(other, own) && materials[other].isTransparent == materials[own].isTransparent)
                contrasts[own] = std::min(contrasts[own], contrastOf(colours[own], colours[other]));
    return contrasts;
}

} // namespace osgPMObjects::core
