// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace scenery
{

/// A placed object. Frame: the scene's east-north-up; `axes`: forward, left and up of the object. Units:
/// metres.
struct Placement
{
    glm::dvec3 position{0.0}; ///< of the object's 0
    glm::dmat3 axes{1.0};
    double scale = 1.0;
    std::uint32_t field = 0;  ///< of SceneryDescription::fields
    std::uint32_t object = 0; ///< of objectsOf()

    bool operator==(const Placement&) const = default;
};

/// Returns the axes of an upright object whose forward axis is at `headingRad`, counter-clockwise from east.
inline glm::dmat3 uprightAxes(double headingRad)
{
    const double c = std::cos(headingRad), s = std::sin(headingRad);
    return {{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
}

} // namespace scenery
