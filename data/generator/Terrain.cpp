// SPDX-License-Identifier: Apache-2.0
#include "Terrain.h"

#include <cmath>
#include <string>

#include <foundation/Fnv1a.h>

#include "DrainageNetwork.h"
#include "LandEvolution.h"

namespace islandgen
{

namespace
{

constexpr int kPlanSide = 513;
constexpr float kLowestLandM = 0.25f;

struct KnownHash
{
    std::uint64_t seed;
    int side;
    std::uint64_t hash;
};

// Written anew when the model changes on purpose: run generate_terrain and copy what it prints.
constexpr KnownHash kKnownHashes[] = {{kDefaultSeed, 257, 0x90cc973b4c8b1c63ull},
                                      {kDefaultSeed, kDefaultSide, 0x61e6178f1fa0237eull}};

bool isPossibleSide(int side)
{
    const int cells = side - 1;
    return side >= 129 && side <= 8193 && (cells & (cells - 1)) == 0;
}

/// Rounds to whole steps and fills what depressions the rounding and the last creep left.
void finish(Land& land)
{
    for (int cell = 0; cell < land.heightM.count(); ++cell)
    {
        const float heightM = land.isSea[cell] ? 0.0f : std::max(land.heightM[cell], kLowestLandM);
        land.heightM[cell] = static_cast<float>(std::lround(heightM / kHeightStepM)) * kHeightStepM;
    }
    fillDepressions(land.heightM, land.isSea, kHeightStepM);
}

} // namespace

foundation::Result<Terrain> generateTerrain(std::uint64_t seed, int side)
{
    if (!isPossibleSide(side))
    {
        return foundation::Error{"--size " + std::to_string(side), "the side must be a power of two plus one",
                                 "use 129, 257, 513, 1025, 2049, 4097 or 8193"};
    }
    const Noise noise(seed);
    Land land = evolveLand(makeIslandPlan(kPlanSide, noise.channel(1)), side, noise.channel(2));
    finish(land);
    return Terrain{std::move(land.heightM), kExtentKm * 1000.0f / static_cast<float>(side - 1)};
}

std::uint64_t terrainHash(const Grid<float>& heightM)
{
    foundation::Fnv1a hash;
    for (const float height : heightM.cells)
    {
        const auto steps = static_cast<std::uint32_t>(static_cast<std::int32_t>(height / kHeightStepM));
        hash.addNumber(steps, sizeof steps);
    }
    return hash.value();
}

std::optional<std::uint64_t> expectedHash(std::uint64_t seed, int side)
{
    for (const KnownHash& known : kKnownHashes)
    {
        if (known.seed == seed && known.side == side) return known.hash;
    }
    return std::nullopt;
}

} // namespace islandgen
