// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.3, TrafficSwarmAction.
#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "simulation/player/traffic/TrafficFlow.h"
#include "simulation/player/way/JunctionKeeper.h"

namespace simulation
{
namespace
{

constexpr double kRimShare = 0.85;   ///< of the ellipse, beyond which vehicles appear later on
constexpr double kSwarmPauseS = 0.5; ///< before the next attempt where there was no room

/// How far it is from a site to the end of its road. Units: metres.
double roomAheadM(const RoadScene& roads, const LaneSite& site)
{
    return looksForward(site.place) ? roads.roadAt(site.place).length - site.place.s : site.place.s;
}

/// Whether somebody who keeps the rules may appear at a site: it leads to other roads, there is room to brake
/// before the next one, and there, as before it, the lane has room beside others.
bool isGoodSite(TrafficScene& scene, const LaneSite& site)
{
    constexpr double kBrakesM = 25.0, kBodyM = 6.0;
    JunctionTable& table = scene.junctions()->table();
    const auto lane = table.meetings().laneAt(site.place);
    if (!lane || roomAheadM(*scene.roads(), site) <= kBrakesM || !table.leadsOn(*lane)) return false;
    const auto& narrow = table.meetings().narrowOn(*lane);
    if (narrow.empty()) return true;
    const double atM = table.meetings().alongM(*lane, glm::dvec2(site.position));
    return std::none_of(narrow.begin(), narrow.end(),
                        [&](const LaneStretch& stretch)
                        { return atM > stretch.fromM - kBrakesM && atM < stretch.toM + kBodyM; });
}

/// The same place some way from the middle of the road, where people drive.
RoadPlace keptRight(const RoadScene& roads, RoadPlace place)
{
    constexpr double kAsideM = 0.15;
    const double relative = place.relativeHeadingRad;
    const double side = place.lane > 0 ? 1.0 : -1.0; // lanes above 0 lie to the left
    (void)roads.putOnLane(place, place.lane, side * kAsideM);
    place.relativeHeadingRad = relative;
    return place;
}

/// The speed at which it can still stop at the end of its road.
double soundSpeed(TrafficScene& scene, int vehicle, const LaneSite& site)
{
    constexpr double kBrakesMps2 = 1.5, kBeforeM = 10.0;
    const double roomM = std::max(0.0, roomAheadM(*scene.roads(), site) - kBeforeM);
    return std::min(defaultSpeed(scene, vehicle, site.place), std::sqrt(2.0 * kBrakesMps2 * roomM));
}

/// Vehicles that leave the ellipse vanish, and others appear near its rim; the first ones appear anywhere in
/// it. Along the entity lies the semi-major axis.
class SwarmFlow final : public TrafficFlow
{
public:
    SwarmFlow(const TrafficSwarm& swarm, const std::vector<int>& vehicles, RandomDraw draw)
        : _swarm(swarm), _vehicles(vehicles), _draw(std::move(draw))
    {
    }

    void step(TrafficScene& scene) override
    {
        const int central = scene.find(_swarm.central);
        if (central < 0 || !scene.isPresent(central)) return;
        const EntityState& state = scene.motion(central).state();
        for (const int vehicle : _vehicles)
            if (scene.isPresent(vehicle) && radius(state, scene.motion(vehicle).state().position) > 1.0)
                scene.vanish(vehicle);
        if (absentOf(scene, _vehicles) >= 0 && scene.timeS() >= _nextS) fill(scene, state);
        _isFilled = true;
    }

private:
    /// 1 on the ellipse, 0 in its middle.
    double radius(const EntityState& central, const glm::dvec3& point) const
    {
        const glm::dmat3 axes = central.bodyToLocal();
        const glm::dvec3 apart = point - central.position;
        const double along = glm::dot(apart, axes[0]) - _swarm.offsetM, beside = glm::dot(apart, axes[1]);
        return std::hypot(along / std::max(_swarm.semiMajorM, 1e-6),
                          beside / std::max(_swarm.semiMinorM, 1e-6));
    }

    bool isGood(TrafficScene& scene, const LaneSite& site)
    {
        _goodSites.resize(scene.laneSites().size());
        std::optional<bool>& isKnown = _goodSites[static_cast<std::size_t>(&site - scene.laneSites().data())];
        if (!isKnown) isKnown = isGoodSite(scene, site);
        return *isKnown;
    }

    /// How many more may appear. `insideM`: of streets.
    int missing(TrafficScene& scene, double insideM) const
    {
        const auto present = std::count_if(_vehicles.begin(), _vehicles.end(),
                                           [&](int vehicle) { return scene.isPresent(vehicle); });
        const auto most = static_cast<std::ptrdiff_t>(_vehicles.size());
        if (!_swarm.perKm) return static_cast<int>(most - present);
        const auto wanted = static_cast<std::ptrdiff_t>(std::lround(*_swarm.perKm * insideM / 1000.0));
        return static_cast<int>(std::min(wanted, most) - present);
    }

    void fill(TrafficScene& scene, const EntityState& central)
    {
        std::vector<const LaneSite*> same, opposite;
        const double spacingM = laneSiteSpacingM(*scene.roads());
        const double reachM =
            std::max(_swarm.semiMajorM, _swarm.semiMinorM) + std::fabs(_swarm.offsetM) + 1.0;
        double insideM = 0.0;
        const RoadPlace* counted = nullptr; ///< the last site of which the street has been counted
        for (const LaneSite& site : scene.laneSites())
        {
            if (std::fabs(site.position.x - central.position.x) > reachM) continue; // spares most of the work
            const double share = radius(central, site.position);
            const bool isCounted = counted && counted->road == site.place.road && counted->s == site.place.s;
            if (share <= 1.0 && !isCounted)
            {
                counted = &site.place;
                insideM += spacingM;
            }
            const bool isOutside =
                glm::length(glm::dvec2(site.position - central.position)) >= _swarm.innerRadiusM;
            if (share > 1.0 || !isOutside || (_isFilled && share < kRimShare)) continue;
            if (_swarm.perKm && !isGood(scene, site)) continue;
            const bool isSame = std::cos(site.headingRad - glm::radians(central.headingDeg)) >= 0.0;
            (isSame ? same : opposite).push_back(&site);
        }
        if (_swarm.perKm) _nextS = scene.timeS() + kSwarmPauseS;
        int more = missing(scene, insideM);
        for (int vehicle = absentOf(scene, _vehicles); vehicle >= 0 && more > 0;
             vehicle = absentOf(scene, _vehicles), --more)
        {
            const std::vector<double> weights{_swarm.sameDirection, _swarm.oppositeDirection};
            const bool hasWeights = weights[0] + weights[1] > 0.0;
            const auto& sites = hasWeights && _draw.index(weights) == 1 ? opposite : same;
            const LaneSite* const site = pickSite(scene, vehicle, sites, _draw);
            if (!site)
            {
                _nextS = scene.timeS() + kSwarmPauseS;
                return;
            }
            if (_swarm.perKm)
                scene.appear(vehicle, keptRight(*scene.roads(), site->place),
                             soundSpeed(scene, vehicle, *site));
            else
                scene.appear(vehicle, site->place,
                             _swarm.speed ? _draw.uniform(_swarm.speed->leastMps, _swarm.speed->mostMps)
                                          : defaultSpeed(scene, vehicle, site->place));
        }
    }

    TrafficSwarm _swarm;
    std::vector<int> _vehicles;
    RandomDraw _draw;
    std::vector<std::optional<bool>> _goodSites; ///< of the scene's; nothing: not looked at yet
    double _nextS = 0.0;
    bool _isFilled = false;
};

} // namespace

std::unique_ptr<TrafficFlow> makeFlow(const TrafficSwarm& swarm, const std::vector<int>& vehicles,
                                      RandomDraw draw)
{
    return std::make_unique<SwarmFlow>(swarm, vehicles, std::move(draw));
}

} // namespace simulation
