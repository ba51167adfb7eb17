// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/StopAhead.h"

#include <cmath>
#include <numbers>

#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

/// A line that holds, by the way from the reference point.
struct StopOnWay
{
    double wayM = 0.0;
    bool isSign = false;
};

/// Walks along the lanes that an entity will take and looks for the first line that holds.
class StopFinder
{
public:
    /// `signs`: where it has stopped; those do not count any more. `frontM`: of its box, before its place.
    StopFinder(const ActionScene& scene, const EntityMotion& motion, const StopAtSign* signs, double frontM)
        : _scene(scene),
          _roads(*scene.roads()),
          _motion(motion),
          _signs(signs),
          _originM(motion.state().odometerM - frontM)
    {
    }

    std::optional<StopOnWay> find(double lookAheadM) const
    {
        constexpr double kStepM = 5.0;
        RoadPlace place = *_motion.state().place;
        place.relativeHeadingRad = looksForward(place) ? 0.0 : std::numbers::pi;
        std::optional<RandomDraw> turns = _motion.turns();
        bool goesOn = true;
        for (double wayM = 0.0; goesOn && wayM < lookAheadM; wayM += kStepM)
        {
            const RoadPlace before = place;
            goesOn = walk(_roads, place, kStepM, _motion.way(), turns ? &*turns : nullptr);
            if (before.road == place.road)
            {
                if (const auto stop = on(before, before.s, place.s, wayM)) return stop;
                continue;
            }
            const double endM = looksForward(before) ? _roads.roadAt(before).length : 0.0;
            if (const auto stop = on(before, before.s, endM, wayM)) return stop;
            const double startM = looksForward(place) ? 0.0 : _roads.roadAt(place).length;
            if (const auto stop = on(place, startM, place.s, wayM + std::fabs(endM - before.s))) return stop;
        }
        return std::nullopt;
    }

private:
    /// The first line on a piece of a road, which begins after `wayM`.
    std::optional<StopOnWay> on(const RoadPlace& place, double fromM, double toM, double wayM) const
    {
        for (const RoadStop& stop : stopsBetween(_roads.network(), place.road, place.lane, fromM, toM))
        {
            const StopOnWay found{wayM + std::fabs(stop.sM - fromM), stop.signal.empty()};
            if (holds(stop, found)) return found;
        }
        return std::nullopt;
    }

    bool holds(const RoadStop& stop, const StopOnWay& found) const
    {
        if (found.isSign) return !_signs || !_signs->hasServed(_originM + found.wayM);
        return holdsBack(_scene.signalStates(), stop.signal);
    }

    const ActionScene& _scene;
    const RoadScene& _roads;
    const EntityMotion& _motion;
    const StopAtSign* _signs;
    double _originM; ///< of ways, by the odometer of its front
};

} // namespace

std::optional<StopAhead> stopAhead(ActionScene& scene, int actor, const StopSearch& search)
{
    const EntityMotion& motion = scene.motion(actor);
    if (!scene.roads() || !motion.state().place) return std::nullopt;
    const BoundingBox& box = scene.scenario().entities[static_cast<std::size_t>(actor)].box();
    const double frontM = box.centre.x + 0.5 * box.lengthM;
    const auto stop = StopFinder(scene, motion, search.signs, frontM).find(search.lookAheadM + frontM);
    if (!stop || stop->wayM < frontM) return std::nullopt;
    const double gapM = stop->wayM - frontM;
    if (comesTooLate(gapM, motion.state().speedMps, search.brakesMps2)) return std::nullopt;
    return StopAhead{gapM, stop->isSign};
}

} // namespace simulation
