// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/RoadLine.h"

#include <algorithm>
#include <cmath>

#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

void addPiece(const osgRoads::core::PlacedNetwork& placed, int road, const RoadLine& line,
              const glm::dvec2& range, RoadThings& into)
{
    OwnThing piece;
    const int steps = std::max(1, static_cast<int>(std::ceil((range.y - range.x) / line.stepM)));
    std::vector<models::SweepStation> stations;
    for (int i = 0; i <= steps; ++i)
    {
        const double s = range.x + (range.y - range.x) * i / steps, t = line.lineT(s);
        const glm::dvec3 at = placed.surfacePoint(road, s, t);
        if (i == 0) piece.origin = at;
        const glm::dvec3 left = uprightAxes(placed, road, s, t, 0.0)[1];
        stations.push_back({at - piece.origin, {left.x, left.y}, line.profileAt(s)});
    }
    models::ModelBuilder builder;
    builder.begin("line", line.surface, line.tint);
    models::addSweep(builder, stations, line.uvPerM);
    piece.model = builder.finish();
    if (!piece.model.mesh.faces.empty()) into.own.push_back(std::move(piece));
}

} // namespace

void addRoadLine(const osgRoads::core::PlacedNetwork& placed, int road, const RoadLine& line,
                 RoadThings& into)
{
    const double from = std::max(line.s, 0.0), to = std::min(line.sEnd, placed.road(road).length);
    if (to - from < 0.01) return;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / kPieceM)));
    for (int i = 0; i < pieces; ++i)
        addPiece(placed, road, line, {from + (to - from) * i / pieces, from + (to - from) * (i + 1) / pieces},
                 into);
}

} // namespace scenery::roads
