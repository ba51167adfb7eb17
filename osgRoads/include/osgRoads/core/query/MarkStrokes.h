// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// A painted stretch of a road mark, along the outer border of a lane. Units: metres.
struct MarkStroke
{
    int laneId = 0;
    double sStart = 0.0, sEnd = 0.0; ///< along the road
    double tOffset = 0.0;            ///< of its middle, from the border, positive to the left
    double width = 0.0;
    double height = 0.0; ///< above the road
    MarkColour colour = MarkColour::standard;
    const RoadMark* mark = nullptr;
};

/// The sizes of marks that a file does not tell.
inline constexpr double kMarkWidthM = 0.12, kBoldMarkWidthM = 0.25;
inline constexpr double kDashM = 3.0, kGapM = 6.0; ///< of broken marks
inline constexpr double kDoubleSpaceM = 0.12;      ///< between the lines of a double mark

/// Returns what is painted for the marks of one lane: lines of <explicit>, else those of <type>, else what
/// the type of the mark means. Types that are no paint (none, grass, curb, edge) give nothing. A pattern that
/// repeats within 0.1 m is one long stroke.
/// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
std::vector<MarkStroke> markStrokes(const Road& road, const LaneSection& section, const Lane& lane);

/// Returns the lines of a mark that repeat along the border: those of <type>, else what the type of the mark
/// means, with their widths. None for a mark with explicit lines.
std::vector<MarkLine> repeatedLines(const RoadMark& mark);

/// Returns the t of the middle of a stroke at s.
double strokeT(const Road& road, const LaneSection& section, const MarkStroke& stroke, double s);

} // namespace osgRoads::core
