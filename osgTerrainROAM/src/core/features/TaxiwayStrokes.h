// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "RunwayStrokes.h"

namespace osgTerrainROAM::core
{

/// Lists the yellow strokes of a paved taxiway: a line along its middle, rounded where it bends, and a
/// holding position wherever it leaves a runway, as seen from there: two dashed lines across it, then two
/// whole ones. `path`: its middle; `runways`: all around.
///
/// Where they lie: holdingPositions().
/// Source: ICAO Annex 14, 8th edition, 5.2.8 (line), 5.2.10 with figure 5-8 (pattern A); widths of a holding
/// position's lines as in FAA AC 150/5340-1.
/// Simplified: the line ends at the runway's edge.
std::vector<Stroke> taxiwayStrokes(const std::vector<glm::dvec2>& path, double widthM,
                                   std::span<const RunwayFrame> runways);

} // namespace osgTerrainROAM::core
