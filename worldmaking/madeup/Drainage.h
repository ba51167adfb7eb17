// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "worldmaking/madeup/GroundGrid.h"

namespace worldmaking
{

/// A stream, from its spring down. Frame: the plane. Units: metres.
struct Stream
{
    std::vector<glm::dvec2> points;
    double areaKm2 = 0.0; ///< that it drains at its end

    double widthM() const { return std::clamp(1.2 * std::sqrt(areaKm2), 1.5, 14.0); }
};

/// Where water runs on a ground: the area above each point, and streams where it is large. Hollows are filled
/// up to their lowest rim.
/// Source: Barnes, Lehman & Mulla, *Priority-flood: an optimal depression-filling and watershed-labeling
/// algorithm for digital elevation models*, 2014, algorithm 1; the way down is that by which the flood came.
class Drainage
{
public:
    explicit Drainage(const GroundGrid& ground);

    /// The area that drains through the nearest point of the grid, km².
    double areaKm2(const glm::dvec2& place) const;

    /// The courses on land where the area exceeds `leastKm2`, each from its beginning to the sea, the border
    /// or a larger one, in which its last point lies too.
    std::vector<Stream> streams(double leastKm2) const;

private:
    const GroundGrid& _ground;
    std::vector<int> _below; ///< the point that each runs to; -1: out of the grid, or into the sea
    std::vector<float> _areaKm2;
    std::vector<int> _order; ///< as the flood came: each after the one below it
};

} // namespace worldmaking
