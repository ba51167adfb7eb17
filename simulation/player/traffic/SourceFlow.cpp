// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.3, TrafficSourceAction and TrafficSinkAction.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/traffic/TrafficFlow.h"

namespace simulation
{
namespace
{

constexpr double kAtOnceS = 1e-9;

/// One vehicle at once, the others evenly after it. Where there is no room, or none is left, the next one
/// waits; what it has missed is not made up for.
class SourceFlow final : public TrafficFlow
{
public:
    SourceFlow(const TrafficSource& source, const std::vector<int>& vehicles, RandomDraw draw)
        : _source(source), _vehicles(vehicles), _draw(std::move(draw))
    {
    }

    void step(TrafficScene& scene) override
    {
        if (!_begun) begin(scene);
        if (_sites.empty() || _source.perSecond <= 0.0 || scene.timeS() < _nextS - kAtOnceS) return;
        const int vehicle = absentOf(scene, _vehicles);
        if (vehicle < 0) return;
        std::vector<const LaneSite*> sites;
        for (const LaneSite& site : _sites)
            sites.push_back(&site);
        const LaneSite* const site = pickSite(scene, vehicle, sites, _draw);
        if (!site) return;
        scene.appear(vehicle, site->place,
                     _source.speedMps.value_or(defaultSpeed(scene, vehicle, site->place)));
        _nextS = std::max(_nextS, scene.timeS() - 1.0 / _source.perSecond) + 1.0 / _source.perSecond;
    }

private:
    /// The lanes around the place; without any the place itself.
    void begin(TrafficScene& scene)
    {
        _begun = true;
        _nextS = scene.timeS();
        const auto centre = scene.positions().place(_source.position);
        if (!centre) return;
        for (const LaneSite& site : scene.laneSites())
            if (glm::length(site.position - centre->position) <= _source.radiusM) _sites.push_back(site);
        if (_sites.empty() && centre->place)
            _sites.push_back({*centre->place, centre->position, centre->headingRad});
    }

    TrafficSource _source;
    std::vector<int> _vehicles;
    RandomDraw _draw;
    bool _begun = false;
    double _nextS = 0.0;
    std::vector<LaneSite> _sites;
};

/// Entities of the file stay: only traffic vanishes.
class SinkFlow final : public TrafficFlow
{
public:
    explicit SinkFlow(const TrafficSink& sink) : _sink(sink) {}

    void step(TrafficScene& scene) override
    {
        const auto centre = scene.positions().place(_sink.position);
        if (!centre || _sink.perSecond == 0.0) return;
        for (int i = 0; i < static_cast<int>(scene.scenario().entities.size()); ++i)
        {
            const bool isThere = scene.isTraffic(i) && scene.isPresent(i) && takes(scene, i);
            if (!isThere || scene.timeS() < _nextS - kAtOnceS) continue;
            if (glm::length(scene.motion(i).state().position - centre->position) > _sink.radiusM) continue;
            scene.vanish(i);
            if (_sink.perSecond) _nextS = scene.timeS() + 1.0 / *_sink.perSecond;
        }
    }

private:
    bool takes(TrafficScene& scene, int entity) const
    {
        const auto* vehicle =
            std::get_if<Vehicle>(&scene.scenario().entities[static_cast<std::size_t>(entity)].object);
        return _sink.categories.empty() ||
               (vehicle && std::find(_sink.categories.begin(), _sink.categories.end(), vehicle->category) !=
                               _sink.categories.end());
    }

    TrafficSink _sink;
    double _nextS = 0.0;
};

} // namespace

std::unique_ptr<TrafficFlow> makeFlow(const TrafficSource& source, const std::vector<int>& vehicles,
                                      RandomDraw draw)
{
    return std::make_unique<SourceFlow>(source, vehicles, std::move(draw));
}

std::unique_ptr<TrafficFlow> makeFlow(const TrafficSink& sink, const std::vector<int>&, RandomDraw)
{
    return std::make_unique<SinkFlow>(sink);
}

} // namespace simulation
