// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// A quadric error: a sum of weighted squared distances from planes that all pass through one point, its
/// origin. For a position and the planes of its faces, it is the cost of moving the position.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997), section 4.
/// Differs: the origin is the position, not that of the frame; this saves the linear and the constant term
/// and their rounding errors.
struct Quadric
{
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

    void addPlane(const glm::dvec3& unitNormal, double weight);
    double at(const glm::dvec3& fromOrigin) const;
    double trace() const { return xx + yy + zz; }
    Quadric& operator+=(const Quadric& other)
    {
        xx += other.xx, yy += other.yy, zz += other.zz;
        xy += other.xy, xz += other.xz, yz += other.yz;
        return *this;
    }
    glm::dmat3 matrix() const { return {xx, xy, xz, xy, yy, yz, xz, yz, zz}; }
};

} // namespace osgPMObjects::core
