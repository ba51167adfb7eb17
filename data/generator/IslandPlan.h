// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// The side of the square that holds the island.
inline constexpr float kExtentKm = 24.576f;

/// The input of the erosion: uplift, rock and coast by cell. Its large lines (coast, mountain range, western
/// hills, lone hills) are drawn by hand, everything smaller is random.
/// Frame: kilometres east and north of the south-west corner. Units: in the names.
struct IslandPlan
{
    Grid<float> inlandKm;      ///< distance from the planned coast, negative at sea; noise makes it inexact
    Grid<float> steepnessM;    ///< uplift over erodibility: the slope of a river that drains 1 m², times 1 m
    Grid<float> erodibility;   ///< relative to the mean rock
    Grid<float> diffuseKm;     ///< length below which soil creep beats rivers
    Grid<float> criticalSlope; ///< slopes above it slide
    Grid<float> shelfM;        ///< height of the sea bed's edge, to which rivers cut while the sea is low

    explicit IslandPlan(int side)
        : inlandKm(side),
          steepnessM(side),
          erodibility(side),
          diffuseKm(side),
          criticalSlope(side),
          shelfM(side)
    {
    }
};

IslandPlan makeIslandPlan(int side, Noise noise);

/// The same plan on a finer or coarser grid, interpolated.
IslandPlan resampled(const IslandPlan& plan, int side);

} // namespace islandgen
