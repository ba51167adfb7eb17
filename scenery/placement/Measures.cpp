// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/Measures.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace scenery
{

Measures measuresOf(const osgPMObjects::core::Mesh& mesh, double foundationM, Stance stance,
                    double nearGroundM)
{
    Measures measures{0.0, foundationM, glm::dvec2(1e9), glm::dvec2(-1e9), stance, false};
    double baseRadius = 0.0;
    for (const glm::dvec3& position : mesh.positions)
    {
        const glm::dvec2 place(position);
        measures.radiusM = std::max(measures.radiusM, glm::length(place));
        if (position.z > nearGroundM) continue;
        measures.baseLow = glm::min(measures.baseLow, place);
        measures.baseHigh = glm::max(measures.baseHigh, place);
        baseRadius = std::max(baseRadius, glm::length(place));
    }
    if (measures.baseLow.x > measures.baseHigh.x) // nothing of it is near the ground
        measures.baseLow = measures.baseHigh = glm::dvec2(0.0);
    measures.isCrowned = stance == Stance::upright && baseRadius < 0.5 * measures.radiusM;
    return measures;
}

} // namespace scenery
