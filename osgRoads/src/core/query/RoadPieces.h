// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/query/BoxTree.h>

namespace osgRoads::core
{

/// A short stretch of one element of a reference line, with a rectangle along its chord that holds the
/// stretch and its lanes.
struct RoadPiece
{
    std::uint32_t road = 0, element = 0;
    double from = 0.0, to = 0.0; ///< metres after the start of the element
    glm::dvec2 start{0.0, 0.0}, direction{1.0, 0.0};
    double length = 0.0;     ///< of the chord
    double leftReach = 0.0;  ///< of the rectangle, from the chord to the left, at least 0
    double rightReach = 0.0; ///< likewise to the right
    double sagitta = 0.0;    ///< the rectangle begins before the chord and ends after it by this

    /// Returns the square of the distance from the rectangle; 0 inside.
    double squareTo(glm::dvec2 point) const;

    /// Returns the distance from the start of the element of the point of the chord that is nearest to
    /// `point`.
    double guessAt(glm::dvec2 point) const;

    PlanBox box() const;
};

/// Cuts the reference lines of all usable roads into pieces: at most 20 m long (longer in networks of more
/// than 4000 km, so that their number stays bounded) and turning by 0.3 rad at most.
std::vector<RoadPiece> piecesOf(const RoadNetwork& network);

} // namespace osgRoads::core
