// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.3, TrafficSwarmAction.
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/traffic/TrafficFlow.h"

namespace simulation
{
namespace
{

constexpr double kRimShare = 0.85;   ///< of the ellipse, beyond which vehicles appear later on
constexpr double kSwarmPauseS = 0.5; ///< before the next attempt where there was no room

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

    void fill(TrafficScene& scene, const EntityState& central)
    {
        std::vector<const LaneSite*> same, opposite;
        for (const LaneSite& site : scene.laneSites())
        {
            const double share = radius(central, site.position);
            const bool isOutside =
                glm::length(glm::dvec2(site.position - central.position)) >= _swarm.innerRadiusM;
            if (share > 1.0 || !isOutside || (_isFilled && share < kRimShare)) continue;
            const bool isSame = std::cos(site.headingRad - glm::radians(central.headingDeg)) >= 0.0;
            (isSame ? same : opposite).push_back(&site);
        }
        for (int vehicle = absentOf(scene, _vehicles); vehicle >= 0; vehicle = absentOf(scene, _vehicles))
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
            scene.appear(vehicle, site->place,
                         _swarm.speed ? _draw.uniform(_swarm.speed->leastMps, _swarm.speed->mostMps)
                                      : defaultSpeed(scene, vehicle, site->place));
        }
    }

    TrafficSwarm _swarm;
    std::vector<int> _vehicles;
    RandomDraw _draw;
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
