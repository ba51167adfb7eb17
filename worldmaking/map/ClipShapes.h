// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Cuts lines and areas that reach far beyond a rectangle down to it: what is made of them costs time and
/// room by their size, and a map may hold an ocean, a cable across it, or a point that somebody mistyped.
/// Shapes that reach less than `marginDeg` beyond it stay as they are; others are cut there. A shape may fall
/// into several, with the same id and tags; one that lies wholly beyond goes. Areas that cross themselves are
/// mended first. Returns the number of shapes that were cut or went.
std::size_t clipTo(const MapBounds& bounds, double marginDeg, LandMap& map);

} // namespace worldmaking
