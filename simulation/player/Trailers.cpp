// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/Trailers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace simulation
{
namespace
{

/// The hitch of a vehicle, in the plane of its axles.
glm::dvec3 hitchOf(const EntityState& state, double hitchM)
{
    return state.position + state.bodyToLocal()[0] * hitchM;
}

} // namespace

Trailers::Trailers(const Scenario& scenario) : _scenario(&scenario)
{
    const auto vehicleAt = [&](std::size_t index)
    { return std::get_if<Vehicle>(&scenario.entities[index].object); };
    std::vector<bool> isTrailer(scenario.entities.size(), false);
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
        if (const Vehicle* const vehicle = vehicleAt(i); vehicle && !vehicle->trailerEntity.empty())
            if (const int trailer = scenario.entityIndex(vehicle->trailerEntity); trailer >= 0)
                isTrailer[static_cast<std::size_t>(trailer)] = true;
    for (std::size_t first = 0; first < scenario.entities.size(); ++first)
    {
        std::size_t tow = first;
        // No train is longer than there are entities: one that bites its tail ends there.
        for (std::size_t length = 0; !isTrailer[first] && length < scenario.entities.size(); ++length)
        {
            const Vehicle* const vehicle = vehicleAt(tow);
            const int trailer = vehicle ? scenario.entityIndex(vehicle->trailerEntity) : -1;
            const Vehicle* const towed =
                trailer >= 0 ? vehicleAt(static_cast<std::size_t>(trailer)) : nullptr;
            if (!towed) break;
            _links.push_back({tow, static_cast<std::size_t>(trailer), vehicle->trailerHitchDxM.value_or(0.0),
                              towed->trailerCouplerDxM.value_or(0.0)});
            tow = static_cast<std::size_t>(trailer);
        }
    }
}

void Trailers::couple(int tow, int trailer)
{
    const auto from = static_cast<std::size_t>(tow);
    std::erase_if(
        _links, [&](const Link& link)
        { return link.tow == from || (trailer >= 0 && link.trailer == static_cast<std::size_t>(trailer)); });
    if (trailer < 0 || trailer == tow) return;
    const auto to = static_cast<std::size_t>(trailer);
    const auto* const drawing = std::get_if<Vehicle>(&_scenario->entities[from].object);
    const auto* const drawn = std::get_if<Vehicle>(&_scenario->entities[to].object);
    if (!drawing || !drawn) return;
    // Before what the trailer itself draws.
    const auto behind =
        std::find_if(_links.begin(), _links.end(), [&](const Link& link) { return link.tow == to; });
    _links.insert(behind,
                  {from, to, drawing->trailerHitchDxM.value_or(0.0), drawn->trailerCouplerDxM.value_or(0.0)});
}

void Trailers::align(std::vector<Actor>& actors) const
{
    for (const Link& link : _links)
    {
        const EntityState& tow = actors[link.tow].motion.state();
        const double heading = glm::radians(tow.headingDeg);
        const glm::dvec3 ahead(std::cos(heading), std::sin(heading), 0.0);
        actors[link.trailer].motion.towTo(hitchOf(tow, link.hitchM) - ahead * link.couplerM, heading,
                                          tow.speedMps);
    }
}

void Trailers::follow(std::vector<Actor>& actors) const
{
    for (const Link& link : _links)
    {
        const EntityState& tow = actors[link.tow].motion.state();
        const glm::dvec3 hitch = hitchOf(tow, link.hitchM);
        const glm::dvec3 axle = actors[link.trailer].motion.state().position;
        const double heading = std::atan2(hitch.y - axle.y, hitch.x - axle.x);
        const glm::dvec3 ahead(std::cos(heading), std::sin(heading), 0.0);
        actors[link.trailer].motion.towTo(hitch - ahead * link.couplerM, heading, tow.speedMps);
    }
}

} // namespace simulation
