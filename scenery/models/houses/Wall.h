// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A hole in a wall with something in it. Units: metres; along the wall, and heights.
struct Opening
{
    double from, to, bottom, top;
    Detail detail = Detail::window;
    double depthM = 0.14; ///< how far behind the wall's face
    bool hasSill = true;
};

/// A flat upright wall. `start`: its left end as seen from outside, z = 0; `along`: unit vector to the right.
/// `rows`: heights at which its faces are cut, rising, the same for all walls of a house, so that they meet at the corners
/// without cracks; the bottoms and tops of its openings must be among them.
struct Wall
{
    glm::dvec3 start{0.0}, along{1.0, 0.0, 0.0};
    double lengthM = 1.0;
    std::vector<double> rows;
    std::vector<Opening> openings;
    bool hasGable = false; ///< a triangle on top
    double gableM = 0.0;   ///< its height

    glm::dvec3 outward() const { return {along.y, -along.x, 0.0}; }
    glm::dvec3 place(double atM, double heightM, double behindM = 0.0) const;
};

/// How often a wall's picture repeats: once in that many metres, both ways.
constexpr double kWallPictureM = 2.4;

/// Its face with the reveals of its openings. Begin a part of the wall's surface before.
void addWallFace(ModelBuilder& builder, const Wall& wall);

/// What stands in its openings: panes and doors; and the sills. Begin a part of the details' surface before.
void addOpenings(ModelBuilder& builder, const Wall& wall, bool doors);
void addSills(ModelBuilder& builder, const Wall& wall);

/// Whether a detail takes the tint of doors instead of that of window frames.
bool isDoor(Detail detail);

} // namespace scenery::models
