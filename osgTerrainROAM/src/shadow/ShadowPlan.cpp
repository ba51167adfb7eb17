// SPDX-License-Identifier: Apache-2.0
#include "ShadowPlan.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace osgTerrainROAM
{

namespace
{

glm::dmat3 lightAxes(const glm::dvec3& sun)
{
    const glm::dvec3 north(0.0, 1.0, 0.0), east(1.0, 0.0, 0.0);
    const glm::dvec3 across = glm::normalize(glm::cross(std::abs(sun.y) < 0.9 ? north : east, sun));
    return glm::transpose(glm::dmat3(across, glm::cross(sun, across), sun));
}

} // namespace

ShadowPlan ShadowPlan::of(const glm::dvec3& eye, const glm::dvec3& sun,
                          const std::array<double, kMaps>& reachesM, int texels)
{
    ShadowPlan plan;
    plan.lightFromWorld = lightAxes(sun);
    const glm::dvec2 eyeInLight(plan.lightFromWorld * eye);
    for (int i = 0; i < kMaps; ++i)
    {
        const double texelM = 2.0 * reachesM[i] / texels;
        plan.maps[i] = {glm::floor(eyeInLight / texelM + 0.5) * texelM, reachesM[i]};
    }
    return plan;
}

std::array<ShadowMap, ShadowPlan::kMaps> ShadowPlan::from(const glm::dvec3& eye) const
{
    const glm::dvec2 eyeInLight(lightFromWorld * eye);
    std::array<ShadowMap, kMaps> seen = maps;
    for (ShadowMap& map : seen)
        map.centre -= eyeInLight;
    return seen;
}

} // namespace osgTerrainROAM
