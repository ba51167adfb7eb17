// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM::core
{

/// A painted rectangle, given by its middle line from `a` to `b`. Metres.
struct Stroke
{
    glm::dvec2 a, b;
    double halfWidthM = 0.0;
    FeatureCells::Paint paint = FeatureCells::white;
};

/// A runway as a rectangle.
struct RunwayFrame
{
    glm::dvec2 a, b; ///< ends of the centre line
    double widthM = 0.0;
    std::string designator; ///< "09/27": the first number is read at `a`
    bool hasBed = true;     ///< false: an area already paints the asphalt
    bool isPaved = true;    ///< false: grass or gravel with boards along its edges
};

/// Fits a rectangle along the longest side of an area; nothing for an apron: when it is no longer than 5
/// times its width.
bool runwayOfArea(const std::vector<std::vector<glm::dvec2>>& rings, RunwayFrame& frame);

/// Lists the strokes of a runway: asphalt, centre line, threshold bars, edge lines, aiming points,
/// designators, edge lights and rubber of tyres; boards where it is not paved.
/// Source: ICAO Annex 14, 8th edition, 5.2.2 to 5.2.7 and 5.3.9; simplified: no touchdown zone marking,
/// digits of straight strokes, the designator follows from the direction when the map has none.
std::vector<Stroke> runwayStrokes(const RunwayFrame& frame);

} // namespace osgTerrainROAM::core
