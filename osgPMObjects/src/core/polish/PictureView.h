// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// A view direction with the axes of its image. Parallel projection, light from the camera.
struct PictureView
{
    glm::dvec3 right, up, towardsEye;
};

inline PictureView viewFrom(const glm::dvec3& towardsEye)
{
    const glm::dvec3 pole =
        std::abs(towardsEye.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(pole, towardsEye));
    return {right, glm::cross(towardsEye, right), towardsEye};
}

/// Returns directions all around, from above to below, about evenly spaced: each turned by the golden angle
/// from the one before.
/// Source: Swinbank and Purser, *Fibonacci grids: a novel approach to global modelling* (2006).
inline std::vector<PictureView> viewsAround(int count)
{
    const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<PictureView> views;
    for (int i = 0; i < count; ++i)
    {
        const double z = 1.0 - (2.0 * i + 1.0) / count, level = std::sqrt(1.0 - z * z);
        views.push_back(viewFrom({level * std::cos(goldenAngle * i), level * std::sin(goldenAngle * i), z}));
    }
    return views;
}

} // namespace osgPMObjects::core
