// SPDX-License-Identifier: Apache-2.0
#include "worldtool/RideFiles.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include <foundation/WholeFile.h>

namespace worldtool
{

namespace
{

constexpr double kDriveS = 60.0, kFlightS = 90.0, kCarMps = 16.0;
constexpr double kBeforeTownM = 640.0; ///< from its middle: the road just before its first houses
constexpr double kPastRunwayM = 250.0, kClimbedM = 110.0, kClimbMps = 38.0;
constexpr double kDegrees = 57.29577951308232;
constexpr int kTraffic = 30;

/// Where the car begins.
struct LaneStart
{
    std::string road;
    int lane = -1;
    double s = 0.0;
};

/// The place of a road between settlements from which one comes to the town after the fewest metres beyond
/// kBeforeTownM.
std::optional<LaneStart> startBefore(const glm::dvec2& town, const osgRoads::core::RoadNetwork& network)
{
    std::optional<LaneStart> best;
    double least = 1e300;
    for (const osgRoads::core::Road& road : network.roads)
    {
        if (!road.junctionId.empty() || road.length < 120.0) continue;
        for (double s = 30.0; s < road.length - 30.0; s += 20.0)
        {
            const auto point = road.referenceLine.at(s);
            const glm::dvec2 ahead(std::cos(point.headingRad), std::sin(point.headingRad)),
                toTown = town - point.position;
            const double awayM = glm::length(toTown), facing = glm::dot(ahead, toTown) / std::max(awayM, 1.0);
            if (std::abs(facing) < 0.7) continue;
            const double cost = std::abs(awayM - kBeforeTownM) + 200.0 * (1.0 - std::abs(facing));
            if (cost >= least) continue;
            least = cost;
            best = LaneStart{road.id, facing > 0.0 ? -1 : 1, s};
        }
    }
    return best;
}

template<class... Values>
std::string formatted(const char* format, Values... values)
{
    char text[1600];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string carEntity()
{
    return R"(        <ScenarioObject name="car">
            <Vehicle name="car_blue" vehicleCategory="car" mass="1500">
                <BoundingBox><Center x="1.4" y="0" z="0.75"/><Dimensions width="1.8" length="4.5" height="1.5"/></BoundingBox>
                <Performance maxSpeed="55" maxAcceleration="5" maxDeceleration="9"/>
                <Axles>
                    <FrontAxle maxSteering="0.6" wheelDiameter="0.62" trackWidth="1.54" positionX="2.7" positionZ="0.31"/>
                    <RearAxle maxSteering="0" wheelDiameter="0.62" trackWidth="1.54" positionX="0" positionZ="0.31"/>
                </Axles>
                <Properties/>
            </Vehicle>
            <ObjectController><Controller name="Driver"><Properties/></Controller></ObjectController>
        </ScenarioObject>
)";
}

/// An aircraft of the scene that flies circuits of a runway.
struct Circuit
{
    glm::dvec3 from{0.0}, to{0.0}; ///< ends of the runway in the scene
    double widthM = 30.0;

    std::string entity() const
    {
        const double course = std::fmod(450.0 - std::atan2(to.y - from.y, to.x - from.x) * kDegrees, 360.0);
        return formatted(R"(        <ScenarioObject name="aircraft">
            <MiscObject name="aircraft" miscObjectCategory="none" mass="1100">
                <BoundingBox><Center x="0" y="0" z="1.4"/><Dimensions width="11" length="8.1" height="2.75"/></BoundingBox>
                <Properties><Property name="domain" value="air"/></Properties>
            </MiscObject>
            <ObjectController><Controller name="Autopilot"><Properties>
                <Property name="orders" value="circuit; circuit; circuit; land"/>
                <Property name="strip" value="%.2f,%.2f,%.4f,%.1f,%.1f"/>
            </Properties></Controller></ObjectController>
        </ScenarioObject>
)",
                         from.x, from.y, course, glm::length(glm::dvec2(to - from)), widthM);
    }

    std::string start() const
    {
        const glm::dvec2 along = glm::normalize(glm::dvec2(to - from));
        const glm::dvec2 place = glm::dvec2(to) + kPastRunwayM * along;
        return formatted(R"(                <Private entityRef="aircraft">
                    <PrivateAction><TeleportAction><Position><WorldPosition x="%.2f" y="%.2f" z="%.2f" h="%.6f"/></Position></TeleportAction></PrivateAction>
                    <PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0"/>
                        <SpeedActionTarget><AbsoluteTargetSpeed value="%.1f"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>
                    <PrivateAction><ControllerAction><ActivateControllerAction longitudinal="true" lateral="true"/></ControllerAction></PrivateAction>
                </Private>
)",
                         place.x, place.y, to.z + kClimbedM, std::atan2(along.y, along.x), kClimbMps);
    }
};

std::string carStart(const LaneStart& start)
{
    return formatted(
        R"(                <GlobalAction><TrafficAction trafficName="traffic"><TrafficSwarmAction semiMajorAxis="700" semiMinorAxis="700" innerRadius="40" offset="0" numberOfVehicles="%d">
                    <CentralObject entityRef="car"/>
                    <TrafficDefinition name="mix">
                        <VehicleCategoryDistribution><VehicleCategoryDistributionEntry category="car" weight="0.8"/><VehicleCategoryDistributionEntry category="van" weight="0.15"/><VehicleCategoryDistributionEntry category="truck" weight="0.05"/></VehicleCategoryDistribution>
                        <ControllerDistribution><ControllerDistributionEntry weight="1"><Controller name="IntelligentDriver"><Properties/></Controller></ControllerDistributionEntry></ControllerDistribution>
                    </TrafficDefinition>
                </TrafficSwarmAction></TrafficAction></GlobalAction>
                <Private entityRef="car">
                    <PrivateAction><TeleportAction><Position><LanePosition roadId="%s" laneId="%d" s="%.1f"/></Position></TeleportAction></PrivateAction>
                    <PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0"/>
                        <SpeedActionTarget><AbsoluteTargetSpeed value="%.1f"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>
                    <PrivateAction><ControllerAction><ActivateControllerAction longitudinal="true" lateral="true"/></ControllerAction></PrivateAction>
                </Private>
)",
        kTraffic, start.road.c_str(), start.lane, start.s, kCarMps);
}

std::string scenarioOf(const std::string& entities, const std::string& starts, double endS)
{
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- Made by worldtool build. -->
<OpenSCENARIO>
    <FileHeader revMajor="1" revMinor="3" date="2024-01-01T00:00:00" description="Traffic and an aircraft in the circuit" author="osgTrainer"/>
    <CatalogLocations/>
    <RoadNetwork><LogicFile filepath="roads.xodr"/><SceneGraphFile filepath="world.roam"/></RoadNetwork>
    <Entities>
)" + entities +
           R"(    </Entities>
    <Storyboard>
        <Init>
            <Actions>
                <GlobalAction><EnvironmentAction><Environment name="summer">
                    <TimeOfDay animation="false" dateTime="2024-06-21T15:30:00Z"/>
                    <Weather fractionalCloudCover="twoOktas"><Fog visualRange="60000"/></Weather>
                </Environment></EnvironmentAction></GlobalAction>
)" + starts +
           formatted(R"(            </Actions>
        </Init>
        <StopTrigger><ConditionGroup><Condition name="end" delay="0" conditionEdge="none"><ByValueCondition>
            <SimulationTimeCondition value="%.0f" rule="greaterOrEqual"/></ByValueCondition></Condition></ConditionGroup></StopTrigger>
    </Storyboard>
</OpenSCENARIO>
)",
                     endS);
}

} // namespace

foundation::Outcome writeRides(const RideSource& source, const std::filesystem::path& world)
{
    if (source.places.empty()) return foundation::success();
    const auto town = source.plane.toPlan(source.places.front().degrees);
    const auto start = town ? startBefore(*town, source.network) : std::nullopt;
    if (!start) return foundation::success();
    std::optional<Circuit> circuit;
    if (!source.runways.empty())
    {
        const worldmaking::Runway& runway = source.runways.front();
        circuit = Circuit{source.placeInScene(runway.from), source.placeInScene(runway.to), runway.widthM};
    }
    const std::string car = carEntity(), aircraft = circuit ? circuit->entity() : std::string();
    const std::string starts = carStart(*start) + (circuit ? circuit->start() : std::string());
    if (const auto written =
            foundation::writeWholeFile(world / "drive.xosc", scenarioOf(car + aircraft, starts, kDriveS));
        !written || !circuit)
        return written;
    return foundation::writeWholeFile(world / "circuit.xosc", scenarioOf(aircraft + car, starts, kFlightS));
}

} // namespace worldtool
