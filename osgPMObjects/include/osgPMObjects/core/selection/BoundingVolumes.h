// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// A bounding sphere. Frame: world. Units: metres.
struct BoundingSphere
{
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// A bounding box whose axes may be rotated. Frame: world. Units: metres.
struct OrientedBox
{
    glm::dvec3 centre{0.0};
    glm::dmat3 axes{1.0};      ///< columns: orthogonal unit vectors
    glm::dvec3 halfSizes{0.0}; ///< along the axes; at least 0
};

/// A bounding ellipsoid, given by its half axes. Frame: world. Units: metres.
struct Ellipsoid
{
    glm::dvec3 centre{0.0};
    glm::dmat3 halfAxes{0.0}; ///< columns, orthogonal; they may be 0

    static Ellipsoid within(const OrientedBox& box)
    {
        return {
            box.centre,
            {box.axes[0] * box.halfSizes.x, box.axes[1] * box.halfSizes.y, box.axes[2] * box.halfSizes.z}};
    }
};

/// The projected area of a volume that is not wholly beyond the near plane. Its true area is not reliable, so
/// rules choose the finest level.
inline constexpr double kFullArea = std::numeric_limits<double>::infinity();

} // namespace osgPMObjects::core
