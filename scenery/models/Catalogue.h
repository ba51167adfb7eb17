// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// The kinds of objects that can be generated.
enum class Kind
{
    oak,
    birch,
    poplar,
    spruce,
    bush,
    familyHouse,
    townHouses,
    barn,
    hall,
    saloon,
    van,
    bus,
    lightAircraft,
    airliner,
    helicopter,
};

/// The limits that hold for every seed of a kind. Units: metres.
struct KindFacts
{
    Kind kind;
    std::string_view name;
    double leastHeightM, mostHeightM;
    double mostRadiusM; ///< of the circle around the object
};

std::span<const KindFacts> kinds();
const KindFacts& factsOf(Kind kind);

/// Generates an object. Pure: the same kind and seed give the same bytes; threads may generate at the same
/// time.
/// Cost: 2 to 30 ms.
Model generate(Kind kind, std::uint64_t seed);

} // namespace scenery::models
