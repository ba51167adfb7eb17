// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A round bar along a bent line.
struct Tube
{
    std::vector<glm::dvec3> line; ///< two points or more, no two neighbours equal
    std::vector<double> radiiM;   ///< by point; 0 closes an end to a tip
    int sides = 8;                ///< three or more
    glm::dvec2 repeats{1.0, 1.0}; ///< of the texture: around, and along per metre
    double flareLobes = 0.0;      ///< above 0: the first rings swell into that many roots
    std::vector<float> light;     ///< by point, or empty for 1
};

/// Its closed skin, with normals that look straight away from the line. The frame is carried along without twist: each
/// ring's is the one before, turned by the least that brings it across the line.
void addTube(ModelBuilder& builder, const Tube& tube);

/// A straight bar between two places.
void addBar(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radiusM, int sides,
            const glm::vec2& uv);

} // namespace scenery::models
