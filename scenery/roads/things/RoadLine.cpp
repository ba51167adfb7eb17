// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/RoadLine.h"

#include <algorithm>
#include <cmath>

#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

/// The piece of a body between two stations, from `low` to `high` across, in shares of their profiles' frame.
void addBody(const RoadLine& line, const models::SweepStation& from, const models::SweepStation& to,
             const glm::dvec3& origin, const glm::dvec2& span, RoadThings& into)
{
    const auto at = [&](const models::SweepStation& station)
    { return glm::dvec2(origin + station.at) + 0.5 * (span.x + span.y) * station.left; };
    double lowM = 1e9, highM = -1e9;
    for (const models::SweepStation* station : {&from, &to})
    {
        for (const glm::dvec2& corner : station->profile)
        {
            lowM = std::min(lowM, station->at.z + corner.y);
            highM = std::max(highM, station->at.z + corner.y);
        }
        highM = std::max(highM, station->at.z + line.bodyTopM);
    }
    simulation::Obstacle body = simulation::pieceBetween(*line.body, at(from), at(to), span.y - span.x);
    body.lowM = origin.z + lowM;
    body.highM = origin.z + highM;
    into.bodies.add(body);
}

/// What vehicles meet of a line: a piece between every two stations; of a tube one for each wall, between the
/// feet of its outside and its inside.
void addBodies(const RoadLine& line, const std::vector<models::SweepStation>& stations,
               const glm::dvec3& origin, RoadThings& into)
{
    for (std::size_t i = 0; i + 1 < stations.size(); ++i)
    {
        const Profile& profile = stations[i].profile;
        const auto [least, most] = std::minmax_element(
            profile.begin(), profile.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        if (!line.isTube)
        {
            addBody(line, stations[i], stations[i + 1], origin, {least->x, most->x}, into);
            continue;
        }
        double insideM = most->x;
        for (const glm::dvec2& corner : profile)
            if (corner.y <= profile.front().y + 1e-6) insideM = std::min(insideM, std::abs(corner.x));
        addBody(line, stations[i], stations[i + 1], origin, {least->x, -insideM}, into);
        addBody(line, stations[i], stations[i + 1], origin, {insideM, most->x}, into);
    }
}

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
    if (line.body) addBodies(line, stations, piece.origin, into);
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
