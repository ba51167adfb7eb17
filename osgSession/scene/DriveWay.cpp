// SPDX-License-Identifier: Apache-2.0
#include "DriveWay.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/ChooseDrive.h>

#include "LaneMaterial.h"
#include "SceneGround.h"
#include "scenery/ground/TileGround.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LanePath.h"
#include "simulation/road/StopSignals.h"

namespace trainer
{

namespace
{

using osgRoads::core::RouteLeg;

constexpr double kAboveBedM = 0.2; // a road lies so far above the ground that is cut to it

std::vector<simulation::DriverStop> stopsOn(const osgRoads::core::RoadNetwork& network,
                                            const osgRoads::core::LaneRoute& route)
{
    std::vector<simulation::DriverStop> stops;
    double begunM = 0.0;
    for (const RouteLeg& leg : route.legs)
    {
        for (const simulation::RoadStop& stop :
             simulation::stopsBetween(network, leg.lane.road, leg.lane.lane, leg.sFrom, leg.sTo))
            stops.push_back({begunM + std::abs(stop.sM - leg.sFrom), stop.signal});
        begunM += std::abs(leg.sTo - leg.sFrom);
    }
    return stops;
}

/// Land, roads and sea, asked for together: which of them is highest tells the kind.
class WheelsGround final : public simulation::Ground
{
public:
    WheelsGround(const SceneTerrain& scene, std::optional<simulation::GroundKind> paving)
        : _terrain(scene.terrain),
          _land(ground::groundOf(scene.terrain->tile()->tile)),
          _roads(scene.roads),
          _sea(scene.seaLevelM),
          _paving(paving.value_or(simulation::GroundKind::asphalt)),
          _asksLanes(!paving && scene.roads && hasMaterials(scene.roads->network())),
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
            askLane(points[i], answers[i]);
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
        {
            answers[i] = at(points[i] - _corner);
            askLane(points[i], answers[i]);
        }
    }

private:
    /// What the lane itself is made of.
    void askLane(const glm::dvec3& point, simulation::GroundPoint& answer) const
    {
        if (!_asksLanes || answer.kind != _paving) return;
        const glm::dvec3 on = glm::dvec3(point.x, point.y, answer.heightM) - _corner;
        answer.kind = laneMaterialAt(*_roads, on).value_or(_paving);
    }

    simulation::GroundPoint at(const glm::dvec3& point) const
    {
        using simulation::GroundKind;
        constexpr double kClimbableM = 0.5;
        const auto land = _land(point.x, point.y, point.z + kClimbableM);
        if (!land) return {};
        const double height =
            _roads ? scenery::heightOnRoads(*_roads, {point.x, point.y, land->heightM}, point.z + kClimbableM)
                   : land->heightM;
        const double sea = _sea ? seaHeightAt(*_sea, point + _corner) : height;
        if (height < sea) return {sea, {0.0, 0.0, 1.0}, GroundKind::water, true, 1.0, sea - height};
        const bool isRoad = std::abs(height - land->heightM) > kAboveBedM;
        return {height, {0.0, 0.0, 1.0}, isRoad ? _paving : GroundKind::grass, true};
    }

    osg::ref_ptr<osgTerrainROAM::RoamTerrain> _terrain; ///< kept for _land
    simulation::GroundProvider _land;
    std::shared_ptr<const osgRoads::core::PlacedNetwork> _roads;
    std::optional<double> _sea;
    simulation::GroundKind _paving; ///< of roads that do not say
    bool _asksLanes;
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

std::shared_ptr<const simulation::Ground> groundForWheels(const SceneTerrain& scene,
                                                          std::optional<simulation::GroundKind> paving)
{
    if (!scene.terrain) return std::make_shared<const simulation::ProvidedGround>(scene.ground());
    return std::make_shared<const WheelsGround>(scene, paving);
}

} // namespace trainer
