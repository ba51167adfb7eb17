// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scenery/placement/Measures.h"
#include "scenery/placement/PlaceScenery.h"

namespace scenery
{

/// A body over the ground that hides the sky from it: an ellipse. Frame: the scene's. Units: metres.
struct SkyOccluder
{
    glm::dvec2 place;     ///< of its middle
    glm::dvec2 ahead;     ///< unit vector of its first half axis
    glm::dvec2 halfM;     ///< half axes
    double heightM = 0.0; ///< of its lower side above the ground
    double opaque = 1.0;  ///< share of the light that it keeps out
};

/// An upright wall. Its outer side lies to the right of the way from `from` to `to`.
struct SkyWall
{
    glm::dvec2 from, to;
    double heightM = 0.0; ///< above the ground before it
};

/// What hides the sky from the ground.
struct SkyOccluders
{
    std::vector<SkyOccluder> bodies;
    std::vector<SkyWall> walls;

    void add(SkyOccluders more);
};

/// The share of the light of an even sky that a wall keeps from level ground at a distance before its middle,
/// when the wall is long. What the wall itself throws back is taken off. Source: Howell, A Catalog of
/// Radiation Heat Transfer Configuration Factors, B-5: a strip without end.
double hiddenByWall(double awayM, double heightM);

/// The same for a level disc above the ground, `awayM` beside its middle. Source: Howell, B-13: a disc in a
/// parallel plane.
double hiddenByDisc(double awayM, double radiusM, double heightM);

/// What generated models of a scenery hide: crowns, vehicles, walls of houses. `measures`: of its objects, in
/// the order of objectsOf(). Models of files are left out.
SkyOccluders occludersOf(const SceneryDescription& description, const PlacedScenery& placed,
                         const std::vector<Measures>& measures);

} // namespace scenery
