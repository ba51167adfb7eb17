// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/geometry/ReferenceLine.h>

namespace worldmaking
{

/// The points of a street as a map has them, rounded: straight lines and arcs that touch them, with one
/// heading everywhere. An arc leaves the map's points by kMostOffsetM at most, and takes at most half of each
/// line beside it.
/// Frame: a plan, x east, y north, metres.
class CentreLine
{
public:
    static constexpr double kMostOffsetM = 2.0;
    static constexpr double kLeastStepM = 1.0; ///< points closer to the one before count for nothing

    /// `points`: two or more, not all in one place.
    explicit CentreLine(const std::vector<glm::dvec2>& points);

    double lengthM() const { return _lengthM; }
    osgRoads::core::PlanPoint at(double s) const { return _line.at(s); }

    /// Where the line is nearest to each of the points, metres along it, ascending.
    const std::vector<double>& pointsM() const { return _pointsM; }

    /// The radius of the sharpest arc, metres; infinite for a straight line.
    double leastRadiusM() const;

    /// Returns the elements of the part from `fromM` to `toM`, with s counted from `fromM`.
    osgRoads::core::ReferenceLine part(double fromM, double toM) const;

private:
    std::vector<std::size_t> keep(const std::vector<glm::dvec2>& points) const;

    osgRoads::core::ReferenceLine _line;
    std::vector<double> _pointsM;
    double _lengthM = 0.0;
};

} // namespace worldmaking
