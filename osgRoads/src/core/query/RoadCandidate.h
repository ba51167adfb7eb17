// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <osgRoads/core/query/RoadLocator.h>

#include "RoadPieces.h"

namespace osgRoads::core
{

inline constexpr double kSameDistanceM = 1e-9; ///< distances that differ by less are equal

/// A road near the point, with what decides between several.
struct RoadCandidate
{
    RoadMatch match;
    double lateral = std::numeric_limits<double>::max(); ///< from the reference line, without sign

    bool isBetterThan(const RoadCandidate& other) const
    {
        if (match.distance < other.match.distance - kSameDistanceM) return true;
        if (match.distance > other.match.distance + kSameDistanceM) return false;
        if (lateral < other.lateral - kSameDistanceM) return true;
        return lateral <= other.lateral + kSameDistanceM && match.position.road < other.match.position.road;
    }
};

/// Returns the position of a point on a piece's road. `height` NaN: on the surface.
RoadCandidate candidateOn(const RoadNetwork& network, const RoadPiece& piece, glm::dvec2 point,
                          double height);

} // namespace osgRoads::core
