// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Keywords.h"
#include "simulation/writer/ElementWriter.h"

namespace simulation
{
namespace
{

void writeContent(ElementWriter parent, const WorldPosition& position)
{
    parent.child("WorldPosition")
        .set("x", position.xM)
        .set("y", position.yM)
        .set("z", position.zM)
        .set("h", position.orientation.headingRad)
        .set("p", position.orientation.pitchRad)
        .set("r", position.orientation.rollRad);
}

void writeContent(ElementWriter parent, const GeoPosition& position)
{
    ElementWriter element = parent.child("GeoPosition");
    element.set("latitudeDeg", position.latitudeDeg)
        .set("longitudeDeg", position.longitudeDeg)
        .set("height", position.heightM)
        .set("altitude", position.altitudeM);
    if (position.orientation == Orientation{}) return;
    element.child("Orientation")
        .set("h", position.orientation.headingRad)
        .set("p", position.orientation.pitchRad)
        .set("r", position.orientation.rollRad)
        .set("type", "absolute");
}

void writeContent(ElementWriter parent, const Polyline& polyline)
{
    ElementWriter element = parent.child("Polyline");
    for (const Vertex& vertex : polyline.vertices)
        writePosition(element.child("Vertex").set("time", vertex.timeS), vertex.position);
}

void writeContent(ElementWriter parent, const TeleportAction& action)
{
    writePosition(parent.child("TeleportAction"), action.position);
}

void writeContent(ElementWriter parent, const FollowTrajectoryAction& action)
{
    ElementWriter element = parent.child("RoutingAction").child("FollowTrajectoryAction");
    if (action.initialDistanceOffsetM != 0.0)
        element.set("initialDistanceOffset", action.initialDistanceOffsetM);
    ElementWriter holder = element.child("TrajectoryRef");
    if (const auto& recording = action.trajectory.recording)
        holder.child("CatalogReference")
            .set("catalogName", recording->file)
            .set("entryName", recording->track);
    else
    {
        ElementWriter trajectory = holder.child("Trajectory");
        trajectory.set("name", action.trajectory.name).set("closed", action.trajectory.closed);
        ElementWriter shape = trajectory.child("Shape");
        std::visit([&](const auto& content) { writeContent(shape, content); }, action.trajectory.shape);
    }
    ElementWriter reference = element.child("TimeReference");
    if (action.timing)
        reference.child("Timing")
            .set("domainAbsoluteRelative", wordFor(kTimingDomains, action.timing->domain))
            .set("scale", action.timing->scale)
            .set("offset", action.timing->offsetS);
    else
        reference.child("None");
    element.child("TrajectoryFollowingMode").set("followingMode", wordFor(kFollowingModes, action.mode));
}

void writeContent(ElementWriter parent, const AbsoluteTargetSpeed& target)
{
    parent.child("AbsoluteTargetSpeed").set("value", target.speedMps);
}

void writeContent(ElementWriter parent, const SpeedAction& action)
{
    ElementWriter element = parent.child("LongitudinalAction").child("SpeedAction");
    element.child("SpeedActionDynamics")
        .set("dynamicsShape", wordFor(kDynamicsShapes, action.dynamics.shape))
        .set("dynamicsDimension", wordFor(kDynamicsDimensions, action.dynamics.dimension))
        .set("value", action.dynamics.value);
    ElementWriter target = element.child("SpeedActionTarget");
    std::visit([&](const auto& content) { writeContent(target, content); }, action.target);
}

void writeWeather(ElementWriter element, const Weather& weather)
{
    const bool inOktas = weather.cloudState.ends_with("Oktas");
    if (!weather.cloudState.empty())
        element.set(inOktas ? "fractionalCloudCover" : "cloudState", weather.cloudState);
    element.set("temperature", weather.temperatureK).set("atmosphericPressure", weather.pressurePa);
    if (weather.sun)
        element.child("Sun")
            .set("azimuth", weather.sun->azimuthRad)
            .set("elevation", weather.sun->elevationRad)
            .set("intensity", weather.sun->intensity)
            .set("illuminance", weather.sun->illuminance);
    if (weather.fogVisualRangeM) element.child("Fog").set("visualRange", *weather.fogVisualRangeM);
    if (weather.precipitation)
        element.child("Precipitation")
            .set("precipitationType", weather.precipitation->type)
            .set("precipitationIntensity", weather.precipitation->intensity);
    if (weather.wind)
        element.child("Wind")
            .set("direction", weather.wind->directionRad)
            .set("speed", weather.wind->speedMps);
}

void writeContent(ElementWriter parent, const EnvironmentAction& action)
{
    const Environment& environment = action.environment;
    ElementWriter element = parent.child("EnvironmentAction").child("Environment");
    element.set("name", environment.name);
    if (environment.timeOfDay)
        element.child("TimeOfDay")
            .set("animation", environment.timeOfDay->animation)
            .set("dateTime", formatDateTime(environment.timeOfDay->dateTime));
    if (environment.weather) writeWeather(element.child("Weather"), *environment.weather);
    if (!environment.roadFriction) return;
    ElementWriter road = element.child("RoadCondition");
    road.set("frictionScaleFactor", *environment.roadFriction);
    if (!environment.roadWetness.empty()) road.set("wetness", environment.roadWetness);
    if (environment.ground)
        road.child("Properties")
            .child("Property")
            .set("name", "ground")
            .set("value", textOf(*environment.ground));
}

void writeContent(ElementWriter parent, const EntityAction& action)
{
    ElementWriter element = parent.child("EntityAction");
    element.set("entityRef", action.entity);
    if (action.isDeleted)
        element.child("DeleteEntityAction");
    else if (ElementWriter added = element.child("AddEntityAction"); action.position)
        writePosition(added, *action.position);
}

} // namespace

void writePosition(ElementWriter parent, const Position& position)
{
    ElementWriter element = parent.child("Position");
    std::visit([&](const auto& content) { writeContent(element, content); }, position);
}

void writePrivateAction(ElementWriter parent, const PrivateAction& action)
{
    ElementWriter element = parent.child("PrivateAction");
    std::visit([&](const auto& content) { writeContent(element, content); }, action);
}

void writeGlobalAction(ElementWriter parent, const GlobalAction& action)
{
    ElementWriter element = parent.child("GlobalAction");
    std::visit([&](const auto& content) { writeContent(element, content); }, action);
}

} // namespace simulation
