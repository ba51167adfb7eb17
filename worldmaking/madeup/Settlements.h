// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "worldmaking/madeup/Drainage.h"
#include "worldmaking/madeup/GroundGrid.h"

namespace worldmaking
{

enum class SettlementKind : std::uint8_t
{
    town,
    village,
    hamlet,
};

/// The value of `place` in OpenStreetMap.
constexpr std::string_view nameOf(SettlementKind kind)
{
    return kind == SettlementKind::town ? "town" : (kind == SettlementKind::village ? "village" : "hamlet");
}

/// A settlement of a made-up map. Frame: the plane.
struct Settlement
{
    SettlementKind kind = SettlementKind::hamlet;
    glm::dvec2 middle{0.0};

    double radiusM() const
    {
        return kind == SettlementKind::town ? 520.0 : (kind == SettlementKind::village ? 260.0 : 120.0);
    }
};

/// What places for settlements are chosen by.
struct SiteRules
{
    const GroundGrid& ground;
    const Drainage& drainage;
    std::uint64_t seed = 1;
    std::function<bool(const glm::dvec2&)> isFree;      ///< to build on
    std::function<bool(const glm::dvec2&)> isReachable; ///< by a road from most of the ground
};

/// Chooses where people settle: on gentle ground with a stream or the shore near by, lower rather than
/// higher, each kind a distance from the others. One town (on kTownKm2 of land and more), and villages and
/// hamlets by the area of the land: four and five on 250 km². Fewer are found where there is too little
/// gentle ground.
std::vector<Settlement> settlementsOn(const SiteRules& rules);

inline constexpr double kTownKm2 = 6.0;

} // namespace worldmaking
