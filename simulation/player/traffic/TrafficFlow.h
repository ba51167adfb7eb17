// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulation/parser/RandomDraw.h"
#include "simulation/player/actions/RunningAction.h"
#include "simulation/road/LaneSites.h"

namespace simulation
{

/// What traffic may ask of a scene, and change in it.
class TrafficScene : public ActionScene
{
public:
    /// Puts a vehicle of the traffic on the road, with a speed, and lets its controller drive it.
    virtual void appear(int vehicle, const RoadPlace& place, double speedMps) = 0;
    virtual void vanish(int vehicle) = 0;
    virtual bool isTraffic(int entity) const = 0;

    /// Where traffic may appear.
    virtual const std::vector<LaneSite>& laneSites() = 0;
};

/// A traffic action that goes on from step to step.
class TrafficFlow
{
public:
    virtual ~TrafficFlow() = default;

    /// Lets vehicles appear and vanish, after all have moved.
    virtual void step(TrafficScene& scene) = 0;
};

/// `vehicles`: the entities that it may use.
std::unique_ptr<TrafficFlow> makeFlow(const TrafficSource& source, const std::vector<int>& vehicles,
                                      RandomDraw draw);
std::unique_ptr<TrafficFlow> makeFlow(const TrafficSink& sink, const std::vector<int>& vehicles,
                                      RandomDraw draw);
std::unique_ptr<TrafficFlow> makeFlow(const TrafficSwarm& swarm, const std::vector<int>& vehicles,
                                      RandomDraw draw);
std::unique_ptr<TrafficFlow> makeFlow(const TrafficArea& area, const std::vector<int>& vehicles,
                                      RandomDraw draw);

/// The speed with which a vehicle appears where the action says nothing: the limit there, else 50 km/h, never
/// above its own greatest.
double defaultSpeed(TrafficScene& scene, int vehicle, const RoadPlace& place);

/// Whether a vehicle has room at a site: at least 8 m on its lane to every entity that is there.
bool hasRoom(TrafficScene& scene, int vehicle, const LaneSite& site);

/// Returns the first of the vehicles that is not there, or -1.
int absentOf(TrafficScene& scene, const std::vector<int>& vehicles);

/// Picks one of the sites on which a vehicle has room, at random; null: after 30 attempts none was found.
const LaneSite* pickSite(TrafficScene& scene, int vehicle, const std::vector<const LaneSite*>& sites,
                         RandomDraw& draw);

} // namespace simulation
