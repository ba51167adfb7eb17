// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// A sum of weighted squared distances from planes that all pass through one point, its origin: a symmetric matrix, no more.
/// For a position and the planes of the faces around it this is what moving the position costs.
/// Source: Garland and Heckbert, "Surface simplification using quadric error metrics" (1997), §4; about the position itself instead of the
/// frame's origin, which saves the linear and the constant term and their rounding.
struct Quadric
{
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

    void addPlane(const glm::dvec3& unitNormal, double weight);
    double at(const glm::dvec3& fromOrigin) const;
    double trace() const { return xx + yy + zz; }
    glm::dmat3 matrix() const { return {xx, xy, xz, xy, yy, yz, xz, yz, zz}; }
};

} // namespace osgPMObjects::core
