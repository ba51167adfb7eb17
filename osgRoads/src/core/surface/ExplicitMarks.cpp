// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11.9.3 (explicit).
#include "ExplicitMarks.h"

#include <glm/geometric.hpp>

#include <osgRoads/core/query/MarkStrokes.h>

#include "PaintColour.h"

namespace osgRoads::core
{

namespace
{

constexpr double kBendM = 0.005, kLongestPieceM = 16.0, kShortestPieceM = 0.25;
constexpr int kMostHalvings = 10; ///< of a stroke: with a sway that leaps away there is no end of pieces

/// Cuts a stroke where the border bends away from the straight line.
class StrokeCutter
{
public:
    StrokeCutter(const PlacedNetwork& network, int road, const LaneSection& section, const MarkStroke& stroke,
                 std::vector<Decal>& into)
        : _network(network), _road(road), _section(section), _stroke(stroke), _into(into)
    {
    }

    void cut(double from, double to, int halvings = kMostHalvings) const
    {
        const glm::dvec3 start = at(from), middle = at(0.5 * (from + to)), end = at(to);
        const glm::dvec2 way(end - start);
        const double length = glm::length(way);
        if (!(length > 1e-6)) return;
        const double aside = glm::distance(glm::dvec2(middle), 0.5 * glm::dvec2(start + end));
        if (halvings > 0 && length > kShortestPieceM && (length > kLongestPieceM || aside > kBendM))
        {
            cut(from, 0.5 * (from + to), halvings - 1);
            cut(0.5 * (from + to), to, halvings - 1);
            return;
        }
        Decal decal;
        decal.start = start;
        decal.along = way / length;
        decal.length = length;
        decal.widthStart = decal.widthEnd = _stroke.width;
        decal.paint = paintOf(_stroke.colour);
        _into.push_back(decal);
    }

private:
    glm::dvec3 at(double s) const
    {
        return _network.surfacePoint(_road, s, strokeT(_network.road(_road), _section, _stroke, s));
    }

    const PlacedNetwork& _network;
    int _road;
    const LaneSection& _section;
    const MarkStroke& _stroke;
    std::vector<Decal>& _into;
};

void addLane(const PlacedNetwork& network, int road, const LaneSection& section, const Lane& lane,
             std::vector<Decal>& into)
{
    for (const MarkStroke& stroke : markStrokes(network.road(road), section, lane))
        if (stroke.mark && !stroke.mark->explicitLines.empty())
            StrokeCutter(network, road, section, stroke, into).cut(stroke.sStart, stroke.sEnd);
}

bool hasExplicitLines(const Lane& lane)
{
    for (const RoadMark& mark : lane.marks)
        if (!mark.explicitLines.empty()) return true;
    return false;
}

} // namespace

void addExplicitMarks(const PlacedNetwork& network, int road, std::vector<Decal>& into)
{
    for (const LaneSection& section : network.road(road).sections)
    {
        if (hasExplicitLines(section.centre)) addLane(network, road, section, section.centre, into);
        for (const auto* side : {&section.left, &section.right})
            for (const Lane& lane : *side)
                if (hasExplicitLines(lane)) addLane(network, road, section, lane, into);
    }
}

} // namespace osgRoads::core
