// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
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

/// Chooses where people settle: on gentle ground with a stream or the shore near by, lower rather than higher, each kind a distance from
/// the others. One town, and villages and hamlets by the area of the land: four and five on 250 km².
/// `isFree`: whether a place may be built on. Fewer are found where there is too little gentle ground.
std::vector<Settlement> settlementsOn(const GroundGrid& ground, const Drainage& drainage, std::uint64_t seed,
                                      const std::function<bool(const glm::dvec2&)>& isFree);

} // namespace worldmaking
