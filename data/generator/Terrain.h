// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include <foundation/Result.h>

#include "Grid.h"
#include "IslandPlan.h"

namespace islandgen
{

inline constexpr std::uint64_t kDefaultSeed = 1;
inline constexpr int kDefaultSide = 2049;

/// Heights are whole numbers of this step: differences in the last bits of the arithmetic vanish, and the
/// hash is of integers.
inline constexpr float kHeightStepM = 1.0f / 64.0f;

/// The finished terrain. The sea is 0 and flat; land is at least 0.25 m high.
/// Invariant: every land cell has a lower neighbour, so all water reaches the sea; the border is sea.
struct Terrain
{
    Grid<float> heightM;
    float cellM;
};

/// Builds the island. `side`: 2^n+1, 129 to 8193; the place and its large forms are the same for every side.
/// Errors: another side. Cost: about 4 µs per cell. Deterministic: seed and side decide every bit.
foundation::Result<Terrain> generateTerrain(std::uint64_t seed, int side);

/// FNV-1a over the heights in steps of kHeightStepM, as little-endian 32-bit integers, row by row from the
/// south.
std::uint64_t terrainHash(const Grid<float>& heightM);

/// The committed hash of a terrain, for those seeds and sides that have one.
std::optional<std::uint64_t> expectedHash(std::uint64_t seed, int side);

} // namespace islandgen
