// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "worldmaking/madeup/Settlements.h"
#include "worldmaking/madeup/WayWeb.h"

namespace worldmaking
{

/// What streets of settlements have to keep to.
struct StreetRules
{
    const GroundGrid& ground;
    std::function<bool(const glm::dvec2&)> isFree; ///< whether a place may be built on
    std::uint64_t seed = 1;
};

/// Grows the streets of a settlement from the roads that lead through it: each street lets others branch off
/// at right angles, which end where the settlement does, or on the next street. None comes near another but
/// where they meet, or climbs more than kSteepestStreet.
/// Source: Parish & Müller, *Procedural modeling of cities*, 2001, §3 (a queue of proposals that local
/// constraints change or refuse).
void growStreets(const Settlement& settlement, int number, const StreetRules& rules, WayWeb& web);

inline constexpr double kSteepestStreet = 0.11;

} // namespace worldmaking
