// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <osgRoads/core/network/Road.h>

namespace worldmaking
{

/// Units: metres.
using WidthAlong = std::function<double(double)>;

/// Returns how wide what lies to the right of a road's line can be at s before it folds over the centre of a
/// bend to the right; infinite elsewhere.
double roomInBend(const osgRoads::core::Road& road, double s);

/// Returns the width of a strip to the right of a road: the wish, and in bends no more than leaves the strip
/// unfolded. Its ends keep the wish, since other roads join there.
/// `insideM`: between the road's line and the strip. Where all of the wish fits, it is its one piece.
osgRoads::core::CubicProfile widthInBend(const osgRoads::core::Road& road, const osgRoads::core::Cubic& wish,
                                         const WidthAlong& insideM);

} // namespace worldmaking
