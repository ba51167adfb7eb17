// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM::core
{

/// What is painted at a place: shares 0…1 of a square filter. The same arithmetic as the fragment shader's
/// (src/material/FeatureShader.h), for maps of the far ground, tests, and whoever has to know what a wheel stands on.
struct FeatureCover
{
    std::array<float, 4> crops{}; ///< by Crop
    float river = 0.0f;
    float asphalt = 0.0f; ///< roads' alone
    float gravel = 0.0f;  ///< and earth
    float runway = 0.0f;

    /// Beyond the nearest road's or river's edge (negative: within), metres; at most kReachM is known.
    float roadEdgeM = FeatureCells::kReachM;
    float riverEdgeM = FeatureCells::kReachM;
};

/// Frame: the tile's local east and north. `filterM`: the filter's side, above 0; no wider than 2·kReachM counts.
/// Cost: some 10 ns a record of the cell. Threads: any.
FeatureCover featureCover(const FeatureCells& cells, const glm::dvec2& place, double filterM);

} // namespace osgTerrainROAM::core
