// SPDX-License-Identifier: Apache-2.0
#include "SceneryWays.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/Stations.h>

namespace trainer
{

namespace
{

constexpr double kMarginM = 2.5;      ///< beside driving entities
constexpr double kEyeRoomM = 14.0;    ///< behind the first point: room for a chase camera
constexpr double kTreetopsM = 45.0;   ///< above the ground; no object is higher
constexpr double kWingMarginM = 25.0; ///< beside entities that fly below tree tops
constexpr double kStepM = 1.0, kJumpM = 200.0;
constexpr double kRoadStepM = 10.0, kRoadMarginM = 2.0; ///< beside verges

/// The path of one entity, split where it jumps.
struct Track
{
    std::vector<std::vector<glm::dvec2>> all, low; ///< low: parts where objects would be in the way

    static void extend(std::vector<std::vector<glm::dvec2>>& pieces, glm::dvec2 place, bool goesOn)
    {
        if (pieces.empty() || !goesOn || glm::length(pieces.back().back() - place) > kJumpM)
            pieces.push_back({place});
        else if (glm::length(pieces.back().back() - place) >= kStepM)
            pieces.back().push_back(place);
    }
};

double halfWidthOf(const simulation::ScenarioObject& entity)
{
    const simulation::BoundingBox& box = entity.box();
    const double halfM = 0.5 * std::max(box.widthM, 1.0) + std::abs(box.centre.y);
    return halfM + (entity.isAirborne() ? kWingMarginM : kMarginM);
}

void addTrack(const Track& track, const simulation::ScenarioObject& entity, scenery::Ways& ways)
{
    for (const auto& piece : track.low)
    {
        ways.keepClear.push_back({piece, halfWidthOf(entity)});
        const double room = std::max(kEyeRoomM, entity.box().lengthM + kMarginM);
        ways.keepClear.push_back({{piece.front()}, room});
        ways.keepClear.push_back({{piece.back()}, room});
    }
    for (const auto& piece : track.all)
        ways.paths.push_back(piece);
}

} // namespace

scenery::Ways waysOf(const simulation::Scenario& scenario, const simulation::PlayerOptions& options,
                     double longestS)
{
    scenery::Ways ways;
    const auto player = simulation::ScenarioPlayer::create(scenario, options);
    if (!player) return ways; // whoever plays it in earnest says why
    std::vector<Track> tracks(scenario.entities.size());
    std::vector<bool> wasLow(tracks.size(), false);
    while (true)
    {
        for (std::size_t i = 0; i < tracks.size(); ++i)
        {
            const simulation::EntityState& state = (*player)->entities()[i];
            const glm::dvec2 place(state.position);
            Track::extend(tracks[i].all, place, true);
            const auto ground = options.ground ? options.ground(place.x, place.y) : std::nullopt;
            const bool isLow = !ground || state.position.z - ground->heightM < kTreetopsM;
            if (isLow) Track::extend(tracks[i].low, place, wasLow[i]);
            wasLow[i] = isLow;
        }
        if ((*player)->isFinished() || (*player)->timeS() >= longestS) break;
        (*player)->step();
    }
    for (std::size_t i = 0; i < tracks.size(); ++i)
        addTrack(tracks[i], scenario.entities[i], ways);
    return ways;
}

void keepRoadsClear(const osgRoads::core::PlacedNetwork& roads, scenery::Ways& ways)
{
    for (std::size_t i = 0; i < roads.network().roads.size(); ++i)
    {
        const int index = static_cast<int>(i);
        const osgRoads::core::Road& road = roads.road(index);
        if (!road.isUsable) continue;
        std::vector<glm::dvec2> line;
        double halfM = 0.0;
        for (const double s : osgRoads::core::evenStations(road.length, kRoadStepM))
        {
            const auto lanes = osgRoads::core::extentAt(road, s);
            line.emplace_back(roads.surfacePoint(index, s, 0.5 * (lanes.rightT + lanes.leftT)));
            halfM = std::max(halfM, 0.5 * (lanes.leftT - lanes.rightT));
        }
        ways.keepClear.push_back({std::move(line), halfM + osgRoads::core::RoadBed{}.vergeM + kRoadMarginM});
    }
}

} // namespace trainer
