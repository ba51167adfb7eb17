// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// A runway as a rectangle.
struct RunwayFrame
{
    glm::dvec2 a, b; ///< ends of the centre line
    double widthM = 0.0;
    std::string designator; ///< "09/27": the first number is read at `a`
    bool hasBed = true;     ///< false: an area already paints the asphalt
    bool isPaved = true;    ///< false: grass or gravel with boards along its edges
};

/// Returns each runway once: where a map has both a line and an area of it, the line tells ends and
/// designator.
std::vector<RunwayFrame> runwaysOf(const std::vector<GroundFeature>& features);

/// Fits a rectangle along the longest side of an area; nothing for an apron: when it is no longer than 5
/// times its width.
bool runwayOfArea(const std::vector<std::vector<glm::dvec2>>& rings, RunwayFrame& frame);

/// The designators at `a` and at `b`, from the direction where the map has none.
std::pair<std::string, std::string> designatorsOf(const RunwayFrame& frame);

} // namespace osgTerrainROAM::core
