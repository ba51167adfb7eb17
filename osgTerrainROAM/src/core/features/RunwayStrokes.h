// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/features/FeatureCells.h>

#include "RunwayFrame.h"

namespace osgTerrainROAM::core
{

/// A painted rectangle, given by its middle line from `a` to `b`. Metres.
struct Stroke
{
    glm::dvec2 a, b;
    double halfWidthM = 0.0;
    FeatureCells::Paint paint = FeatureCells::white;
};

/// Lists the strokes of a runway: asphalt, centre line, threshold bars, edge lines, aiming points,
/// designators, edge lights and rubber of tyres; boards where it is not paved.
/// Source: ICAO Annex 14, 8th edition, 5.2.2 to 5.2.7 and 5.3.9; simplified: no touchdown zone marking,
/// digits of straight strokes, the designator follows from the direction when the map has none.
std::vector<Stroke> runwayStrokes(const RunwayFrame& frame);

} // namespace osgTerrainROAM::core
