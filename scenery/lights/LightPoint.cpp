// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/LightPoint.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace scenery
{

namespace
{

double aboveDeg(const glm::dvec3& from)
{
    return glm::degrees(std::atan2(from.z, std::hypot(from.x, from.y)));
}

} // namespace

bool isLit(const Flash& flash, double timeS)
{
    if (flash.periodS <= 0.0) return true;
    const double turns = (timeS - flash.startS) / flash.periodS;
    return (turns - std::floor(turns)) * flash.periodS < flash.litS;
}

double candelaTowards(const LightPoint& light, const glm::dvec3& eye, double timeS)
{
    if (!isLit(light.flash, timeS)) return 0.0;
    const glm::dvec3 from = eye - light.place;
    const double asideDeg = glm::degrees(std::atan2(from.y, from.x)) - light.headingDeg;
    return light.candela * shareOf(beamOf(light.beam), asideDeg, aboveDeg(from) - light.tiltDeg);
}

glm::vec3 colourTowards(const LightPoint& light, const glm::dvec3& eye)
{
    if (!light.below) return light.colour;
    const double beyond = aboveDeg(eye - light.place) - light.below->angleDeg;
    const double share = std::clamp(0.5 + beyond / kColourChangeDeg, 0.0, 1.0);
    return glm::mix(light.below->colour, light.colour, static_cast<float>(share));
}

} // namespace scenery
