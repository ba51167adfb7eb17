// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/geometry/PlanPoint.h>

namespace osgRoads::core
{

/// A curve whose curvature changes evenly with its length (Euler spiral), from the origin along x.
/// The heading at s is κ₀·s + c·s²/2 with c = (κ₁ − κ₀)/length; the position is the integral of its cosine
/// and sine. It is computed by Gauss–Legendre quadrature from the nearest of stored points that lie 0.5 rad
/// or less apart, so the error stays near that of double arithmetic: 1e-12 of the length.
/// Source: ASAM OpenDRIVE 1.8, 9.5 (spiral).
class Clothoid
{
public:
    /// `length` > 0, metres. Limit: turns of at most kMostTurnRad in sum.
    Clothoid(double curvatureAtStart, double curvatureAtEnd, double length);

    /// Returns the point at arc length s; beyond the ends the spiral goes on.
    PlanPoint at(double s) const;

    double curvatureAt(double s) const { return _curvature + _curvatureRate * s; }
    double headingAt(double s) const { return s * (_curvature + 0.5 * _curvatureRate * s); }

    static constexpr double kMostTurnRad = 200.0;

private:
    glm::dvec2 advance(double from, double to) const;

    double _curvature, _curvatureRate, _spacing;
    std::vector<glm::dvec2> _points; ///< at every multiple of _spacing
};

} // namespace osgRoads::core
