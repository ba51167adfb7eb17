// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/RoadLine.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::ObjectInstance;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;

/// The beam of a steel guard rail: profile A of the German RAL-RG 620, 310 mm high and 81 mm deep, of 3 mm
/// sheet (here 5 mm). Its posts stand every 4 m; its top is 0.75 m above the road.
constexpr double kBeamM = 0.31, kDeepM = 0.081, kSheetM = 0.005, kTopM = 0.75, kPostEveryM = 4.0;
constexpr double kPostHalfM = 0.04;
constexpr double kLoweredM = 8.0; ///< from an end that stands free down into the ground
constexpr double kFreeEndM = 5.0; ///< an end nearer to that of its road goes on there
constexpr double kLowestPostM = 0.4;
constexpr double kOwnPostM = 1.0; ///< posts of the file stand nearer than this

/// Two waves that swell towards the traffic: `side` 1: to the left.
Profile beam(int side, double low, double high)
{
    const double waves[] = {0.2, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.2},
                 heights[] = {0.0, 0.13, 0.32, 0.42, 0.58, 0.68, 0.87, 1.0};
    Profile front, back;
    for (int i = 0; i < 8; ++i)
    {
        const double depth = kPostHalfM + kSheetM + kDeepM * waves[i], z = low + (high - low) * heights[i];
        front.emplace_back(side * depth, z);
        back.emplace_back(side * (depth - kSheetM), z);
    }
    // Counter-clockwise with left to the right and up.
    Profile profile = side > 0 ? front : back;
    const Profile& other = side > 0 ? back : front;
    profile.insert(profile.end(), other.rbegin(), other.rend());
    return profile;
}

/// The side on which the nearest lane for cars lies: 1 for the left.
int sideOfTraffic(const Road& road, double s, double t)
{
    for (double away = 0.5; away <= 20.0; away += 0.5)
        for (const int side : {1, -1})
            if (const auto lane = laneAt(road, s, t + side * away); lane && isForCars(lane->lane->type))
                return side;
    return t > 0.0 ? -1 : 1;
}

bool hasOwnPosts(const Road& road, const ObjectInstance& stretch)
{
    const double s = 0.5 * (stretch.s + stretch.sEnd), t = 0.5 * (stretch.t + stretch.tEnd);
    for (const auto& object : road.objects)
    {
        const auto model = objectModel(ObjectWords(object), {});
        const bool isPost = model && (model->kind == models::RoadModel::Kind::railPost ||
                                      model->kind == models::RoadModel::Kind::pole);
        if (!isPost) continue;
        for (const auto& repeat : object.repeats)
            if (repeat.distance > 0.0 && repeat.s <= s && s <= repeat.s + repeat.length &&
                std::fabs(0.5 * (repeat.tStart + repeat.tEnd) - t) < kOwnPostM)
                return true;
    }
    return false;
}

} // namespace

void placeGuardRail(const PlacedNetwork& placed, int road, const ObjectInstance& stretch, RoadThings& into)
{
    const Road& plain = placed.road(road);
    const auto share = [stretch](double s)
    { return std::clamp((s - stretch.s) / std::max(stretch.sEnd - stretch.s, 1e-9), 0.0, 1.0); };
    const auto tAt = [=](double s) { return stretch.t + (stretch.tEnd - stretch.t) * share(s); };
    // A height of no more than a beam's is that of the beam itself; else the beam is at the top of it.
    const double told = std::max(stretch.height, stretch.heightEnd);
    const double thick = told > 0.0 && told <= 1.3 * kBeamM ? told : kBeamM;
    const auto loweredAt = [from = stretch.s, to = stretch.sEnd, length = plain.length](double s)
    {
        const double start = from > kFreeEndM ? (s - from) / kLoweredM : 1.0,
                     end = to < length - kFreeEndM ? (to - s) / kLoweredM : 1.0;
        return std::clamp(std::min(start, end), 0.0, 1.0);
    };
    const auto topAt = [=](double s)
    {
        const double high = stretch.height + (stretch.heightEnd - stretch.height) * share(s);
        return loweredAt(s) * (stretch.z + (stretch.zEnd - stretch.z) * share(s) +
                               (told > 0.0 ? std::max(high, 0.05) : kTopM));
    };
    const double middle = 0.5 * (stretch.s + stretch.sEnd);
    const int side = sideOfTraffic(plain, middle, tAt(middle));
    RoadLine line;
    line.s = stretch.s;
    line.sEnd = stretch.sEnd;
    line.tint = {0.62F, 0.64F, 0.65F};
    line.body = simulation::ObstacleKind::guardRail;
    line.lineT = tAt;
    line.profileAt = [=](double s) { return beam(side, topAt(s) - thick, topAt(s)); };
    addRoadLine(placed, road, line, into);
    if (hasOwnPosts(plain, stretch)) return;
    models::RoadModel post;
    post.kind = models::RoadModel::Kind::railPost;
    const double from = std::max(stretch.s, 0.0), to = std::min(stretch.sEnd, plain.length);
    for (double s = from + 0.5; s < to; s += kPostEveryM)
    {
        // In steps of 2 cm, so that posts share models.
        post.heightM = 0.02 * std::floor((topAt(s) - 0.03) / 0.02);
        if (post.heightM < kLowestPostM) continue;
        StandingThing thing;
        thing.position = placed.surfacePoint(road, s, tAt(s));
        thing.axes = uprightAxes(placed, road, s, tAt(s), 0.0);
        addStanding(into, post, thing);
    }
}

} // namespace scenery::roads
