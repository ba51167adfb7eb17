// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

/// Moves the vertices of a mesh so that none of them comes or goes visibly, and the error bound holds.
/// A vertex that is active above τ0 has weight w = clamp((p_v − τ0) / (τ1 − τ0), 0, 1) and is drawn at
/// (D(a) + D(b)) / 2 + w·δ_v, a and b the ends of the base that it split as *they* are drawn, δ_v how far it lies from their
/// middle. The weights nest, so the surface is the average of the meshes at all tolerances from τ0 to τ1, and no sample is
/// off by more than (τ0 + τ1) / 2. A function of the eye alone, like the mesh.
/// Cost: one look at each vertex of the mesh, and some more for those whose weight is less than one.
/// Source: spec 1 D, "Morphing that keeps the bound".
class Morph
{
public:
    /// τ1 / τ0, and the share of a target τ = (τ0 + τ1) / 2 that the mesh has to be refined to.
    static constexpr double kSpan = 2.0, kRefineShare = 2.0 / (1.0 + kSpan);

    /// Displaces the vertices of a tree that has been refined for `view` to `tolerance0Px`. Those that have moved are in
    /// the tree's changes.
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
