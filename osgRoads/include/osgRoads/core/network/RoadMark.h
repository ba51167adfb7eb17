// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/network/LaneType.h>

namespace osgRoads::core
{

enum class MarkType
{
    none,
    solid,
    broken,
    solidSolid,
    solidBroken,
    brokenSolid,
    brokenBroken,
    bottsDots,
    grass,
    curb,
    edge,
    custom,
};

inline constexpr Keywords<MarkType, 12> kMarkTypes = {{{"none", MarkType::none},
                                                       {"solid", MarkType::solid},
                                                       {"broken", MarkType::broken},
                                                       {"solid solid", MarkType::solidSolid},
                                                       {"solid broken", MarkType::solidBroken},
                                                       {"broken solid", MarkType::brokenSolid},
                                                       {"broken broken", MarkType::brokenBroken},
                                                       {"botts dots", MarkType::bottsDots},
                                                       {"grass", MarkType::grass},
                                                       {"curb", MarkType::curb},
                                                       {"edge", MarkType::edge},
                                                       {"custom", MarkType::custom}}};

enum class MarkColour
{
    standard, ///< white
    black,
    blue,
    green,
    orange,
    red,
    violet,
    white,
    yellow,
};

inline constexpr Keywords<MarkColour, 9> kMarkColours = {{{"standard", MarkColour::standard},
                                                          {"black", MarkColour::black},
                                                          {"blue", MarkColour::blue},
                                                          {"green", MarkColour::green},
                                                          {"orange", MarkColour::orange},
                                                          {"red", MarkColour::red},
                                                          {"violet", MarkColour::violet},
                                                          {"white", MarkColour::white},
                                                          {"yellow", MarkColour::yellow}}};

enum class MarkWeight
{
    standard,
    bold,
};

inline constexpr Keywords<MarkWeight, 2> kMarkWeights = {
    {{"standard", MarkWeight::standard}, {"bold", MarkWeight::bold}}};

enum class LaneChange
{
    both,
    none,
    increase, ///< only towards lanes of greater id
    decrease,
};

inline constexpr Keywords<LaneChange, 4> kLaneChanges = {{{"both", LaneChange::both},
                                                          {"none", LaneChange::none},
                                                          {"increase", LaneChange::increase},
                                                          {"decrease", LaneChange::decrease}}};

/// One line of a mark: repeated (length and space) or, in RoadMark::explicitLines, a single piece. Units:
/// metres.
struct MarkLine
{
    double length = 0.0;  ///< of a visible piece; 0: all along
    double space = 0.0;   ///< between pieces; 0: all along
    double tOffset = 0.0; ///< from the border of the lane, positive to the left
    double sOffset = 0.0; ///< start, from the start of the mark
    double width = 0.0;   ///< 0: that of the mark
    MarkColour colour = MarkColour::standard;
    std::string rule; ///< "no passing", "caution", "none"
};

/// A mark along the outer border of a lane (for the centre lane along the lane offset). It holds up to the
/// next mark.
/// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
struct RoadMark
{
    double s = 0.0; ///< sOffset, metres from the start of the lane section
    MarkType type = MarkType::none;
    MarkWeight weight = MarkWeight::standard;
    MarkColour colour = MarkColour::standard;
    double width = 0.0;  ///< metres; 0: not told
    double height = 0.0; ///< metres above the road
    LaneChange laneChange = LaneChange::both;
    std::string material;
    std::vector<MarkLine> lines;         ///< of <type>; empty: drawn by `type`
    std::vector<MarkLine> explicitLines; ///< of <explicit>
    CubicProfile sway; ///< lateral shift, metres, over the distance from the start of the mark
};

} // namespace osgRoads::core
