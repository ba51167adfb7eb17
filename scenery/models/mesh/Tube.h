// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A round bar along a bent line.
struct Tube
{
    std::vector<glm::dvec3> line; ///< at least two points, neighbours differ
    std::vector<double> radiiM;   ///< by point; 0 closes an end to a tip
    int sides = 8;                ///< three or more
    glm::dvec2 repeats{1.0, 1.0}; ///< of the texture: around, and along per metre
    double flareLobes = 0.0;      ///< above 0: the first rings widen into that many roots
    std::vector<float> light;     ///< by point, or empty for 1
};

/// Adds the closed surface of a tube, with normals perpendicular to the line. The frame is carried along
/// without twist: the frame of a ring is that of the ring before, turned by the smallest rotation that makes
/// it perpendicular to the line.
void addTube(ModelBuilder& builder, const Tube& tube);

/// Returns a straight tube between two points.
void addBar(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radiusM, int sides,
            const glm::vec2& uv);

} // namespace scenery::models
