// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// Frame: world. Units: metres.
struct BoundingSphere
{
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// Frame: world. Units: metres.
struct OrientedBox
{
    glm::dvec3 centre{0.0};
    glm::dmat3 axes{1.0};      ///< columns: unit vectors at right angles to each other
    glm::dvec3 halfSizes{0.0}; ///< along the axes; 0 is allowed
};

/// The ellipsoid with these half axes. That of a box's half sizes lies within the box; times √3 it goes through the corners.
/// Frame: world. Units: metres.
struct Ellipsoid
{
    glm::dvec3 centre{0.0};
    glm::dmat3 halfAxes{0.0}; ///< columns; 0 is allowed

    static Ellipsoid within(const OrientedBox& box)
    {
        return {
            box.centre,
            {box.axes[0] * box.halfSizes.x, box.axes[1] * box.halfSizes.y, box.axes[2] * box.halfSizes.z}};
    }
};

/// The area of a volume that is not wholly beyond the near plane: no figure of it in the picture can be relied upon, and the
/// finest level is right.
inline constexpr double kFullArea = std::numeric_limits<double>::infinity();

} // namespace osgPMObjects::core
