// SPDX-License-Identifier: Apache-2.0
#include "TwinFolds.h"

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

bool foldsWithTwin(const MirrorTwins& twins, std::span<const glm::dvec3> positions, const Star& star,
                   std::uint32_t other, const glm::dvec3& at)
{
    const std::uint32_t twin = twins.of(star.middle), twinOfOther = twins.of(other);
    constexpr std::uint32_t kNone = MirrorTwins::kNone;
    if (twin == kNone || twinOfOther == kNone || twin == star.middle || twin == other || twinOfOther == other)
        return false;
    const glm::dvec3 image = twins.image(at);
    const auto placeOf = [&](std::uint32_t p)
    { return p == twin || p == twinOfOther ? image : positions[p]; };
    for (const Star::Spoked& spoked : star.faces)
    {
        const bool crosses = spoked.has(twin) || spoked.has(twinOfOther);
        const bool vanishes = spoked.has(other) || (spoked.has(twin) && spoked.has(twinOfOther));
        if (!crosses || vanishes) continue;
        const glm::dvec3 normal = glm::cross(placeOf(spoked.second) - at, placeOf(spoked.third) - at);
        if (!(glm::dot(normal, spoked.normal) > 0.0)) return true;
    }
    return false;
}

} // namespace osgPMObjects::core
