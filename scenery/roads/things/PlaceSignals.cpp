// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 14.1 (signal), 14.5 (physical position).
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/PaintedItem.h>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/SignCodes.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using models::RoadModel;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgRoads::core::Signal;

constexpr double kNearPoleM = 0.5;

bool hasPole(const Road& road, const Signal& signal)
{
    for (const auto& object : road.objects)
        if (object.type == "pole" && std::hypot(object.s - signal.s, object.t - signal.t) < kNearPoleM)
            return true;
    return false;
}

/// Sizes in steps of a centimetre, so that equal signs share a model.
double rounded(double metres)
{
    return std::round(100.0 * metres) / 100.0;
}

void setSizes(RoadModel& model, const Signal& signal, bool ownPost)
{
    const bool isLight = !lensesOf(model).empty();
    if (!isLight)
    {
        model.widthM = rounded(signal.width);
        model.heightM = rounded(signal.height);
    }
    const double headM = model.kind == RoadModel::Kind::trafficLight ? 0.84 : 0.56;
    model.raisedM = rounded(signal.zOffset);
    // A light whose height reaches from the road up: the lamps are at its top.
    if (isLight && signal.zOffset < 1.0) model.raisedM = rounded(std::max(signal.height - headM, 2.1));
    if (!isLight && signal.zOffset < 0.3 && signal.height < 1.5) model.raisedM = 2.0;
    if (ownPost) model.postDepthM = models::kPostDepthM;
}

} // namespace

glm::dmat3 uprightAxes(const PlacedNetwork& placed, int road, double s, double t, double headingRad)
{
    const double length = placed.road(road).length, step = std::min(0.5, 0.25 * length);
    const double at = std::clamp(s, step, std::max(step, length - step));
    glm::dvec3 along = placed.surfacePoint(road, at + step, t) - placed.surfacePoint(road, at - step, t);
    along.z = 0.0;
    along = glm::length(along) > 1e-9 ? glm::normalize(along) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 left(-along.y, along.x, 0.0);
    const glm::dvec3 forward = std::cos(headingRad) * along + std::sin(headingRad) * left;
    return {forward, glm::dvec3(-forward.y, forward.x, 0.0), glm::dvec3(0.0, 0.0, 1.0)};
}

double headingOf(const Signal& signal)
{
    return signal.headingRad + (signal.orientation == '-' ? std::numbers::pi : 0.0);
}

void addStanding(RoadThings& into, const RoadModel& model, const StandingThing& thing)
{
    const auto found = std::find(into.models.begin(), into.models.end(), model);
    into.standing.push_back(thing);
    into.standing.back().model = static_cast<std::size_t>(found - into.models.begin());
    if (found == into.models.end()) into.models.push_back(model);
}

void placeSignals(const PlacedNetwork& placed, int road, RoadThings& into)
{
    for (const Signal& signal : placed.road(road).signals)
    {
        auto model = signModel(signal);
        const std::string kind =
            "signal " + (signal.country.empty() ? std::string("?") : signal.country) + " " + signal.type;
        if (!model)
        {
            if (!osgRoads::core::paintKind(signal)) ++into.withoutModel[kind];
            continue;
        }
        ++into.withModel[kind];
        setSizes(*model, signal, !hasPole(placed.road(road), signal));
        model->isTwoSided = signal.orientation == '0';
        StandingThing thing;
        int onRoad = road;
        double s = signal.s, t = signal.t;
        if (signal.post && signal.post->isOnRoad && placed.network().roadIndex(signal.post->roadId) >= 0)
        {
            onRoad = placed.network().roadIndex(signal.post->roadId);
            s = signal.post->s;
            t = signal.post->t;
        }
        thing.position = placed.surfacePoint(onRoad, s, t);
        thing.axes = uprightAxes(placed, onRoad, s, t, headingOf(signal));
        if (!lensesOf(*model).empty()) thing.signalId = signal.id;
        addStanding(into, *model, thing);
    }
}

} // namespace scenery::roads
