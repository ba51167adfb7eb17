// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/DrawnContact.h"

#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/roam/DrawnGround.h>

namespace scenery
{

namespace
{

constexpr double kSlopeStepM = 0.05;

std::optional<double> drawnAt(const DrawnScene& scene, const glm::dvec2& at, double highestM)
{
    std::optional<double> drawn =
        osgRoads::core::drawnHeight(scene.roads, scene.choices, scene.view, scene.settings, at, highestM);
    const auto ground = osgTerrainROAM::core::drawnGroundAt(scene.ground, at.x, at.y);
    const bool isOpen = ground && scene.openings && scene.openings->isOpen(ground->position);
    if (ground && !isOpen && ground->position.z <= highestM)
        drawn = drawn ? std::max(*drawn, ground->position.z) : ground->position.z;
    return drawn;
}

/// The slope along an axis: the gentler one of both sides, so that a kerb is none.
double slopeAlong(const DrawnScene& scene, const glm::dvec2& at, const glm::dvec2& axis, double heightM,
                  double highestM)
{
    double gentlest = INFINITY;
    for (const double sign : {-1.0, 1.0})
        if (const auto beside = drawnAt(scene, at + sign * kSlopeStepM * axis, highestM))
            gentlest = std::min(gentlest, std::fabs(*beside - heightM) / kSlopeStepM);
    return std::isfinite(gentlest) ? gentlest : 0.0;
}

} // namespace

std::optional<DrawnContact> contactAt(const DrawnScene& scene, const glm::dvec3& place)
{
    const double highestM = place.z + kHeadroomM;
    const glm::dvec2 at(place);
    const std::optional<double> drawn = drawnAt(scene, at, highestM);
    if (!drawn) return std::nullopt;
    const double east = slopeAlong(scene, at, {1.0, 0.0}, *drawn, highestM);
    const double north = slopeAlong(scene, at, {0.0, 1.0}, *drawn, highestM);
    DrawnContact contact{.place = place};
    contact.gapM = (*drawn - place.z) / std::sqrt(1.0 + east * east + north * north);
    contact.distanceM = glm::distance(place, scene.view.eyeWorld);
    contact.gapPx = contact.gapM * scene.view.pixelsPerTangent / contact.distanceM;
    return contact;
}

} // namespace scenery
