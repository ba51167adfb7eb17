// SPDX-License-Identifier: Apache-2.0
#include "ChunkCuts.h"

#include <algorithm>
#include <cmath>

namespace osgRoads::core
{

namespace
{

constexpr double kShortestM = 0.05; ///< cuts are not closer than this, but at the ends

/// Adds the starts within a lane section of what lies along the road or (with `from`) along the section.
template<class Pieces>
void addStarts(const Pieces& pieces, double from, std::vector<double>& cuts)
{
    for (const auto& piece : pieces)
        cuts.push_back(from + piece.s);
}

std::vector<double> wishedCuts(const Road& road, const LaneSection& section, std::vector<double> cuts)
{
    addStarts(road.referenceLine.elements(), 0.0, cuts);
    addStarts(road.elevation.pieces(), 0.0, cuts);
    addStarts(road.superelevationRad.pieces(), 0.0, cuts);
    addStarts(road.laneOffset.pieces(), 0.0, cuts);
    addStarts(road.shapes, 0.0, cuts);
    for (const RoadStructure& structure : road.structures)
        cuts.insert(cuts.end(), {structure.s, structure.s + structure.length});
    addStarts(section.centre.marks, section.s, cuts);
    for (const auto* side : {&section.left, &section.right})
        for (const Lane& lane : *side)
        {
            addStarts(lane.marks, section.s, cuts);
            addStarts(lane.heights, section.s, cuts);
            addStarts(lane.width.pieces(), section.s, cuts);
        }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

} // namespace

std::vector<double> chunkCuts(const Road& road, const LaneSection& section, const std::vector<double>& more,
                              double longestM)
{
    const double start = std::max(section.s, 0.0), end = std::min(section.end, road.length);
    std::vector<double> cuts;
    if (!(end > start)) return cuts;
    cuts.push_back(start);
    const auto reach = [&](double to)
    {
        const double from = cuts.back();
        const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / longestM)));
        for (int i = 1; i < parts; ++i)
            cuts.push_back(from + (to - from) * i / parts);
        cuts.push_back(to);
    };
    for (const double cut : wishedCuts(road, section, more))
        if (cut > cuts.back() + kShortestM && cut < end - kShortestM) reach(cut);
    reach(end);
    return cuts;
}

} // namespace osgRoads::core
