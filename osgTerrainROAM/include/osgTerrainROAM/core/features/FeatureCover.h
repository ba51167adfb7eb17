// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM::core
{

/// Cover of a square filter by each kind of paint: shares 0…1. The arithmetic is that of the fragment shader
/// (src/shaders/FeaturePaint.glsl); maps of the far ground, tests and vehicle models use it.
struct FeatureCover
{
    std::array<float, 4> crops{}; ///< by Crop
    float shade = 0.0f;           ///< of the fields, 0…1, each times its share
    float river = 0.0f;
    float asphalt = 0.0f; ///< of roads alone
    float gravel = 0.0f;  ///< gravel and earth
    float runway = 0.0f;

    /// Distance to the edge of the nearest road or river, metres (negative: inside); clamped to kReachM.
    float roadEdgeM = FeatureCells::kReachM;
    float riverEdgeM = FeatureCells::kReachM;
};

/// Evaluates the cover at a position. Frame: the tile's local east and north. `filterM`: side of the filter,
/// above 0, clamped to 2·kReachM.
/// Cost: some 10 ns a record of the cell. Threads: any.
FeatureCover featureCover(const FeatureCells& cells, const glm::dvec2& place, double filterM);

} // namespace osgTerrainROAM::core
