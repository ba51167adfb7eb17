// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace simulation
{

inline const std::string kCar =
    R"(<Vehicle name="car" vehicleCategory="car">
<BoundingBox><Center x="1.4" y="0" z="0.75"/><Dimensions width="2" length="5" height="1.5"/></BoundingBox>
<Performance maxSpeed="70" maxDeceleration="10" maxAcceleration="5"/>
<Axles><FrontAxle maxSteering="0.5" wheelDiameter="0.8" trackWidth="1.6" positionX="3" positionZ="0.4"/>
<RearAxle maxSteering="0" wheelDiameter="0.8" trackWidth="1.6" positionX="0" positionZ="0.4"/></Axles>
<Properties/></Vehicle>)";

/// A scenario with one car, `Ego`, around whatever the test is about.
struct ScenarioText
{
    std::string header = R"(<FileHeader revMajor="1" revMinor="3" date="d" description="d" author="a"/>)";
    std::string declarations;
    std::string catalogs;
    std::string entities = R"(<ScenarioObject name="Ego">)" + kCar + "</ScenarioObject>";
    std::string globals;  ///< GlobalAction elements
    std::string privates; ///< PrivateAction elements of Ego
    std::string stories;
    std::string stop;

    std::string text() const
    {
        const std::string own =
            privates.empty() ? "" : "<Private entityRef=\"Ego\">" + privates + "</Private>";
        return "<?xml version=\"1.0\"?>\n<OpenSCENARIO>\n" + header + declarations + catalogs +
               "\n<RoadNetwork/>\n<Entities>" + entities + "</Entities>\n<Storyboard>\n<Init><Actions>" +
               globals + own + "</Actions></Init>\n" + stories + stop + "\n</Storyboard>\n</OpenSCENARIO>\n";
    }
};

inline std::string speedAction(double speed, const std::string& shape = "step",
                               const std::string& dimension = "time", double value = 0.0)
{
    return "<PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape=\"" + shape +
           "\" dynamicsDimension=\"" + dimension + "\" value=\"" + std::to_string(value) +
           "\"/><SpeedActionTarget><AbsoluteTargetSpeed value=\"" + std::to_string(speed) +
           "\"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>";
}

inline std::string teleport(const std::string& position)
{
    return "<PrivateAction><TeleportAction><Position>" + position +
           "</Position></TeleportAction></PrivateAction>";
}

inline std::string vertex(const std::string& position, const std::string& time = "")
{
    return "<Vertex" + (time.empty() ? "" : " time=\"" + time + "\"") + "><Position>" + position +
           "</Position></Vertex>";
}

inline std::string followTrajectory(const std::string& vertices, const std::string& reference = "<None/>",
                                    const std::string& mode = "position", const std::string& closed = "false")
{
    return "<PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name=\"t\" "
           "closed=\"" +
           closed + "\"><Shape><Polyline>" + vertices +
           "</Polyline></Shape></Trajectory></TrajectoryRef><TimeReference>" + reference +
           "</TimeReference><TrajectoryFollowingMode followingMode=\"" + mode +
           "\"/></FollowTrajectoryAction></RoutingAction></PrivateAction>";
}

inline const std::string kTiming = R"(<Timing domainAbsoluteRelative="relative" scale="1" offset="0"/>)";

inline std::string timeCondition(double seconds, const std::string& rule = "greaterOrEqual",
                                 const std::string& edge = "none", double delay = 0.0)
{
    return "<ConditionGroup><Condition name=\"c\" delay=\"" + std::to_string(delay) + "\" conditionEdge=\"" +
           edge + "\"><ByValueCondition><SimulationTimeCondition value=\"" + std::to_string(seconds) +
           "\" rule=\"" + rule + "\"/></ByValueCondition></Condition></ConditionGroup>";
}

inline std::string event(const std::string& name, const std::string& action, const std::string& trigger,
                         const std::string& priority = "parallel", int count = 1)
{
    return "<Event name=\"" + name + "\" priority=\"" + priority + "\" maximumExecutionCount=\"" +
           std::to_string(count) + "\"><Action name=\"" + name + "Action\">" + action +
           "</Action><StartTrigger>" + trigger + "</StartTrigger></Event>";
}

inline std::string story(const std::string& events)
{
    return R"(<Story name="story"><Act name="act"><ManeuverGroup name="group" maximumExecutionCount="1">
<Actors selectTriggeringEntities="false"><EntityRef entityRef="Ego"/></Actors><Maneuver name="maneuver">)" +
           events + "</Maneuver></ManeuverGroup><StartTrigger>" + timeCondition(0.0) +
           "</StartTrigger></Act></Story>";
}

inline std::string stopAt(double seconds)
{
    return "<StopTrigger>" + timeCondition(seconds) + "</StopTrigger>";
}

} // namespace simulation
