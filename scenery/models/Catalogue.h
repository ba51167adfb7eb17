// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// What can be generated.
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
};

/// What a caller may rely on for every seed of a kind. Units: metres.
struct KindFacts
{
    Kind kind;
    std::string_view name;
    double leastHeightM, mostHeightM;
    double mostRadiusM; ///< of the circle it stands in
};

std::span<const KindFacts> kinds();
const KindFacts& factsOf(Kind kind);

/// A model of a kind. Pure: the same seed gives the same bytes, whoever asks, in whatever order; threads may generate at the
/// same time. Cost: 2 to 30 ms.
Model generate(Kind kind, std::uint64_t seed);

} // namespace scenery::models
