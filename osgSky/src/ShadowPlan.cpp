// SPDX-License-Identifier: Apache-2.0
#include "ShadowPlan.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace osgSky
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
                          const std::array<double, kMaps>& reachesM, int texels, double cellShare)
{
    ShadowPlan plan;
    plan.lightFromWorld = lightAxes(sun);
    const glm::dvec3 eyeInLight = plan.lightFromWorld * eye;
    const double cellTexels = std::max(std::floor(cellShare * texels), 1.0);
    for (int i = 0; i < kMaps; ++i)
    {
        const double cellM = cellTexels * 2.0 * reachesM[i] / texels;
        plan.maps[i] = {glm::floor(eyeInLight / cellM + 0.5) * cellM, reachesM[i]};
        if (cellTexels == 1.0) plan.maps[i].centre.z = eyeInLight.z;
    }
    return plan;
}

std::array<ShadowMap, ShadowPlan::kMaps> ShadowPlan::from(const glm::dvec3& eye) const
{
    const glm::dvec3 eyeInLight = lightFromWorld * eye;
    std::array<ShadowMap, kMaps> seen = maps;
    for (ShadowMap& map : seen)
        map.centre -= eyeInLight;
    return seen;
}

} // namespace osgSky
