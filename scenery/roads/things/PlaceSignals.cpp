// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 14.1 (signal), 14.5 (physical position).
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/ObjectInstances.h>

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
constexpr double kOverheadM = 3.0;    ///< from this height on a sign over a lane hangs
constexpr double kNearGantryM = 3.0;  ///< along the road
constexpr double kBesideRoadM = 0.75; ///< post of an arm, from the lanes

/// The poles and gantries that a file has along a road, which may carry its signals. Look-ups: logarithmic.
class Carriers
{
public:
    explicit Carriers(const Road& road)
    {
        for (const auto& object : road.objects)
        {
            if (object.type != "pole" && object.type != "gantry") continue;
            for (const auto& one : osgRoads::core::objectInstances(object))
                if (!one.isStretch) (object.type == "pole" ? _poles : _gantries).emplace(one.s, one.t);
        }
    }

    bool hasPoleAt(double s, double t) const
    {
        for (auto pole = _poles.lower_bound(s - kNearPoleM);
             pole != _poles.end() && pole->first < s + kNearPoleM; ++pole)
            if (std::hypot(pole->first - s, pole->second - t) < kNearPoleM) return true;
        return false;
    }

    bool hasGantryAt(double s) const
    {
        const auto gantry = _gantries.lower_bound(s - kNearGantryM);
        return gantry != _gantries.end() && gantry->first < s + kNearGantryM;
    }

private:
    std::multimap<double, double> _poles, _gantries; ///< t by s
};

/// Returns how far to the right of a signal over a lane its post stands, in the signal's frame; 0 for a
/// signal beside the lanes.
double armOf(const Road& road, const Signal& signal)
{
    if (signal.zOffset < kOverheadM) return 0.0;
    const auto lane = osgRoads::core::laneAt(road, signal.s, signal.t);
    if (!lane || !isForCars(lane->lane->type)) return 0.0;
    const auto lanes = osgRoads::core::extentAt(road, signal.s);
    const double toLeft = lanes.leftT + kBesideRoadM - signal.t,
                 toRight = signal.t - lanes.rightT + kBesideRoadM;
    const double arm = toLeft < toRight ? -toLeft : toRight;
    return signal.orientation == '-' ? -arm : arm;
}

/// Sizes in steps of a centimetre, angles in hundredths, so that equal signs share a model.
double rounded(double value)
{
    return std::round(100.0 * value) / 100.0 + 0.0; // no -0
}

void setSizes(RoadModel& model, const Signal& signal)
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
    model.pitchRad = rounded(signal.post ? signal.post->pitchRad : signal.pitchRad);
    model.rollRad = rounded(signal.post ? signal.post->rollRad : signal.rollRad);
}

void setPost(RoadModel& model, const Road& road, const Signal& signal, const Carriers& carriers)
{
    if (carriers.hasPoleAt(signal.s, signal.t)) return;
    model.armM = rounded(armOf(road, signal));
    if (model.armM != 0.0 && carriers.hasGantryAt(signal.s))
        model.armM = 0.0;
    else
        model.postDepthM = models::kPostDepthM;
}

/// Returns how far a light has to move to its left, so that lights of one post do not lie in each other.
double asideOf(const Road& road, const Signal& signal)
{
    if (signal.type != "1000002") return 0.0;
    for (const Signal& other : road.signals)
        if (other.type == "1000001" && std::hypot(other.s - signal.s, other.t - signal.t) < 0.3 &&
            other.orientation == signal.orientation)
            return 0.36;
    return 0.0;
}

} // namespace

glm::dmat3 tiltedAxes(const glm::dmat3& upright, double pitchRad, double rollRad)
{
    return pitchRad == 0.0 && rollRad == 0.0 ? upright : upright * models::pitchAndRoll(pitchRad, rollRad);
}

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
    const auto [known, isNew] = into.modelIndex.emplace(model, into.models.size());
    if (isNew) into.models.push_back(model);
    into.standing.push_back(thing);
    into.standing.back().model = known->second;
}

void placeSignals(const PlacedNetwork& placed, int road, RoadThings& into)
{
    const Carriers carriers(placed.road(road));
    for (const Signal& signal : placed.road(road).signals)
    {
        auto model = signModel(signal);
        if (!model) continue;
        setSizes(*model, signal);
        setPost(*model, placed.road(road), signal, carriers);
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
        if (!signal.post) thing.position += thing.axes[1] * asideOf(placed.road(road), signal);
        if (!lensesOf(*model).empty()) thing.signalId = signal.id;
        addStanding(into, *model, thing);
    }
}

} // namespace scenery::roads
