// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/parser/RandomDraw.h"
#include "simulation/road/JunctionLane.h"
#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Position.h"

namespace simulation
{

/// The roads of a route in the order in which they are driven; empty: no route.
using RoadWay = std::vector<int>;

/// A road that follows at one end of another.
struct RoadStep
{
    int road = -1;
    bool entersAtStart = true; ///< and runs towards greater s from there
    int lane = 0;              ///< that the lane left leads to
};

/// Returns the roads, with their lanes, that follow a lane at one end of its road; the whole road's for lane
/// 0.
std::vector<RoadStep> stepsFrom(const osgRoads::core::RoadNetwork& network, int road, bool atEnd, int lane);

/// Moves a place along its lane, on the side on which it looks (backwards where the distance is negative):
/// over lane sections, links and junctions, with its offset and heading to the lane kept. In a junction it
/// takes the road of `way`, else the road that turns least. What is beyond the middle of the lane counts as
/// far as it moves itself, not the reference line.
/// `turns`: where the way does not say, it chooses instead, each road as often as the others.
/// Returns false at the end of the last road, where the place then is.
/// Differs: esmini leaves the choice in a junction without route to chance.
bool walk(const RoadScene& roads, RoadPlace& place, double distanceM, const RoadWay& way,
          RandomDraw* turns = nullptr);

/// Returns places along a lane, so far apart, from where it is entered to the end of its road; none: the road
/// has no such lane there.
std::vector<RoadPlace> placesAlong(const RoadScene& roads, const JunctionLane& lane, double stepM);

/// Returns the distance along the reference lines between two places, by the shortest way: positive where
/// `to` is ahead of where `from` looks. Nothing: no way within `mostM`.
std::optional<double> distanceAlong(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
                                    double mostM = 1e4);

/// Returns the roads of a way from where a place looks to another, whatever the lanes; nothing: there is
/// none. `random`: the way is drawn among those that pass no road twice.
std::optional<RoadWay> wayBetween(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
                                  RouteStrategy strategy = RouteStrategy::shortest,
                                  RandomDraw* draw = nullptr);

} // namespace simulation
