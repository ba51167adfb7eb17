// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/geometry/Cubic.h>

namespace osgRoads::core
{

struct ValueRange
{
    double least = 0.0, greatest = 0.0;

    void include(double value)
    {
        least = value < least ? value : least;
        greatest = value > greatest ? value : greatest;
    }
};

/// Returns a range that holds every value of the profile on [from, to]: that of the control values of each
/// piece, within which a polynomial stays (Farin, *Curves and Surfaces for CAGD*, 2002, chapter 5).
ValueRange boundsOf(const CubicProfile& profile, double from, double to);

} // namespace osgRoads::core
