// SPDX-License-Identifier: Apache-2.0
#include "DriveWay.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/ChooseDrive.h>

#include "ground/TileGround.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LanePath.h"

namespace trainer
{

namespace
{

using osgRoads::core::RouteLeg;
using osgRoads::core::Signal;

constexpr const char* kStopSign = "206";   // of the German regulations
constexpr const char* kLights = "1000001"; // of OpenDRIVE's own signals
constexpr double kAboveBedM = 0.2;         // a road lies so far above the ground that is cut to it

/// Whether a signal stops who drives along a leg.
bool holdsFor(const Signal& signal, const RouteLeg& leg)
{
    if (signal.type != kStopSign && signal.type != kLights) return false;
    if (signal.orientation != '0' && (signal.orientation == '+') != leg.lane.isForward) return false;
    if (signal.s < std::min(leg.sFrom, leg.sTo) || signal.s > std::max(leg.sFrom, leg.sTo)) return false;
    if (signal.validities.empty()) return true;
    return std::any_of(signal.validities.begin(), signal.validities.end(),
                       [&](const osgRoads::core::LaneValidity& lanes)
                       {
                           return leg.lane.lane >= std::min(lanes.fromLane, lanes.toLane) &&
                                  leg.lane.lane <= std::max(lanes.fromLane, lanes.toLane);
                       });
}

std::vector<simulation::DriverStop> stopsOn(const osgRoads::core::RoadNetwork& network,
                                            const osgRoads::core::LaneRoute& route)
{
    std::vector<simulation::DriverStop> stops;
    double begunM = 0.0;
    for (const RouteLeg& leg : route.legs)
    {
        for (const Signal& signal : network.roads[static_cast<std::size_t>(leg.lane.road)].signals)
            if (holdsFor(signal, leg))
                stops.push_back({begunM + std::abs(signal.s - leg.sFrom),
                                 signal.type == kStopSign ? std::string() : signal.id});
        begunM += std::abs(leg.sTo - leg.sFrom);
    }
    std::stable_sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.atM < b.atM; });
    return stops;
}

/// Land and roads, asked for together: which of both is higher tells the kind.
class WheelsGround final : public simulation::Ground
{
public:
    explicit WheelsGround(const SceneTerrain& scene)
        : _land(ground::groundOf(scene.terrain->tile()->tile)),
          _roads(scene.roads),
          _corner(scene.cornerM, 0.0)
    {
    }

    void below(std::span<const glm::dvec3> points, std::span<simulation::GroundPoint> answers) const override
    {
        constexpr double kAroundM = 0.5;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            answers[i] = at(points[i] - _corner);
            if (!answers[i].isKnown) continue;
            const auto slope = [&](const glm::dvec3& step)
            {
                const auto on = at(points[i] - _corner + step), back = at(points[i] - _corner - step);
                return on.isKnown && back.isKnown ? (on.heightM - back.heightM) / (2.0 * kAroundM) : 0.0;
            };
            answers[i].normal =
                glm::normalize(glm::dvec3(-slope({kAroundM, 0.0, 0.0}), -slope({0.0, kAroundM, 0.0}), 1.0));
        }
    }

    void heightsBelow(std::span<const glm::dvec3> points,
                      std::span<simulation::GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = at(points[i] - _corner);
    }

private:
    simulation::GroundPoint at(const glm::dvec3& point) const
    {
        using simulation::GroundKind;
        constexpr double kClimbableM = 0.5;
        const auto land = _land(point.x, point.y, point.z + kClimbableM);
        if (!land) return {};
        if (!_roads) return {land->heightM, {0.0, 0.0, 1.0}, GroundKind::grass, true};
        const double height =
            scenery::heightOnRoads(*_roads, {point.x, point.y, land->heightM}, point.z + kClimbableM);
        const bool isRoad = std::abs(height - land->heightM) > kAboveBedM;
        return {height, {0.0, 0.0, 1.0}, isRoad ? GroundKind::asphalt : GroundKind::grass, true};
    }

    simulation::GroundProvider _land;
    std::shared_ptr<const osgRoads::core::PlacedNetwork> _roads;
    glm::dvec3 _corner;
};

} // namespace

foundation::Result<simulation::DriverPath> driveWay(const SceneTerrain& scene, const std::string& file,
                                                    double lengthM)
{
    if (!scene.roads)
        return foundation::Error{file, "no roads to drive along",
                                 "give an OpenDRIVE network, or name one with the key roads of a .roam file"};
    const osgRoads::core::RoadNetwork& network = scene.roads->network();
    const osgRoads::core::LaneRoute route =
        osgRoads::core::chooseDrive(network, osgRoads::core::LaneGraph(network), lengthM);
    std::vector<simulation::DriverPoint> points;
    for (const scenery::LanePathPoint& point : scenery::lanePath(*scene.roads, route))
        points.push_back({point.place + glm::dvec3(scene.cornerM, 0.0), point.limitMps});
    if (points.size() < 20)
        return foundation::Error{file, "no lane for cars that is 20 m long",
                                 "give a network with roads for cars"};
    return simulation::DriverPath(points, stopsOn(network, route));
}

std::shared_ptr<const simulation::Ground> groundForWheels(const SceneTerrain& scene)
{
    return std::make_shared<const WheelsGround>(scene);
}

} // namespace trainer
