// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/RedLight.h"

#include <cmath>
#include <numbers>

#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

bool isRed(const ActionScene& scene, const RoadStop& stop)
{
    const auto& states = scene.signalStates();
    const auto found = stop.signal.empty() ? states.end() : states.find(stop.signal);
    return found != states.end() && !letsPass(found->second);
}

/// The way from `fromM` to the first red light on a piece of a road.
std::optional<double> redOn(const ActionScene& scene, const RoadPlace& place, double fromM, double toM)
{
    for (const RoadStop& stop : stopsBetween(scene.roads()->network(), place.road, place.lane, fromM, toM))
        if (isRed(scene, stop)) return std::fabs(stop.sM - fromM);
    return std::nullopt;
}

/// From the reference point along the lanes.
std::optional<double> wayToRedLight(const ActionScene& scene, const EntityMotion& motion, double lookAheadM)
{
    constexpr double kStepM = 5.0;
    const RoadScene& roads = *scene.roads();
    RoadPlace place = *motion.state().place;
    place.relativeHeadingRad = looksForward(place) ? 0.0 : std::numbers::pi;
    std::optional<RandomDraw> turns = motion.turns();
    bool goesOn = true;
    for (double wayM = 0.0; goesOn && wayM < lookAheadM; wayM += kStepM)
    {
        const RoadPlace before = place;
        goesOn = walk(roads, place, kStepM, motion.way(), turns ? &*turns : nullptr);
        if (before.road == place.road)
        {
            if (const auto red = redOn(scene, before, before.s, place.s)) return wayM + *red;
            continue;
        }
        const double endM = looksForward(before) ? roads.roadAt(before).length : 0.0;
        if (const auto red = redOn(scene, before, before.s, endM)) return wayM + *red;
        const double startM = looksForward(place) ? 0.0 : roads.roadAt(place).length;
        if (const auto red = redOn(scene, place, startM, place.s))
            return wayM + std::fabs(endM - before.s) + *red;
    }
    return std::nullopt;
}

} // namespace

std::optional<double> redLightAhead(ActionScene& scene, int actor, double lookAheadM, double brakesMps2)
{
    const EntityMotion& motion = scene.motion(actor);
    if (!scene.roads() || !motion.state().place || scene.signalStates().empty()) return std::nullopt;
    const BoundingBox& box = scene.scenario().entities[static_cast<std::size_t>(actor)].box();
    const double frontM = box.centre.x + 0.5 * box.lengthM;
    const auto wayM = wayToRedLight(scene, motion, lookAheadM + frontM);
    if (!wayM || *wayM < frontM) return std::nullopt;
    const double gapM = *wayM - frontM, speed = motion.state().speedMps;
    if (speed * speed > 2.0 * brakesMps2 * gapM && gapM > 0.0 && speed > 1.0) return std::nullopt;
    return gapM;
}

} // namespace simulation
