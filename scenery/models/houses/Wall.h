// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// An opening in a wall and its content. Units: metres along the wall, and heights.
struct Opening
{
    double from, to, bottom, top;
    Detail detail = Detail::window;
    double depthM = 0.14; ///< how far behind the wall's face
    bool hasSill = true;
};

/// A flat upright wall. `start`: its left end seen from outside, z = 0; `along`: unit vector to the right.
/// `rows`: increasing heights at which its faces are cut, the same for all walls of a house, so that there
/// are no cracks at the corners; they must contain the bottoms and tops of its openings.
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

/// The period of the wall texture in metres, in both axes.
constexpr double kWallPictureM = 2.4;

/// Adds the face of the wall with the reveals of its openings. Precondition: a part of the wall surface has
/// begun.
void addWallFace(ModelBuilder& builder, const Wall& wall);

/// Adds panes, doors and sills. Precondition: a part of the details surface has begun.
void addOpenings(ModelBuilder& builder, const Wall& wall, bool doors);
void addSills(ModelBuilder& builder, const Wall& wall);

/// Returns whether a detail takes the tint of doors instead of that of window frames.
bool isDoor(Detail detail);

} // namespace scenery::models
