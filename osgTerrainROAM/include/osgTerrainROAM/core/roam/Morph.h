// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

/// Moves the vertices of a mesh so that none appears or disappears with a jump, and the error bound holds.
/// A vertex that is active above τ0 has weight w = clamp((p_v − τ0) / (τ1 − τ0), 0, 1). It is drawn at
/// (D(a) + D(b)) / 2 + w·δ_v, where D(a) and D(b) are the drawn positions of the ends of the base that it
/// split, and δ_v is the vector from their middle to the vertex. Weights nest, so the surface is the average
/// of the meshes at all tolerances from τ0 to τ1, and no sample is off by more than (τ0 + τ1) / 2. Like the
/// mesh, it depends on the eye alone.
/// Cost: one check of each vertex of the mesh, and a displacement for those whose weight is less than one.
/// Source: Hoppe, *Smooth view-dependent level-of-detail control*, 1998 (geomorphs). Differs: the weight is a
/// function of the priority, not of time, so that the bound holds during the transition.
class Morph
{
public:
    /// τ1 / τ0, and the share of a target τ = (τ0 + τ1) / 2 to which the mesh has to be refined.
    static constexpr double kSpan = 2.0, kRefineShare = 2.0 / (1.0 + kSpan);

    /// Displaces the vertices of a tree that has been refined for `view` to `tolerance0Px`. The changes of
    /// the tree record those that have moved.
    void update(DiamondTree& tree, const viewlod::ViewState& view, double tolerance0Px);

private:
    struct Moving
    {
        VertexSlot vertex;
        float weight;
    };

    std::array<std::vector<Moving>, TileGrid::kMostLevels>
        _moving; ///< by level; the ends of a base are coarser than its middle
};

} // namespace osgTerrainROAM::core
