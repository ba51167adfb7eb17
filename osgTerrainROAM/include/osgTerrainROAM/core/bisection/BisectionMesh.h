// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <osgTerrainROAM/core/bisection/BisectionBounds.h>
#include <osgTerrainROAM/core/bisection/BisectionTree.h>

namespace osgTerrainROAM::core
{

/// A triangle that is drawn. Vertices below BisectionSurface::vertices() are those of the surface, others
/// points inside patches.
struct DrawnBisector
{
    CornerVertices vertices;
    Bisector leaf;                 ///< or the carrier of its patch
    std::uint32_t patch = kNoSide; ///< kNoSide: a plain leaf
};

/// What a refinement has changed.
struct BisectionChanges
{
    std::uint32_t split = 0, merged = 0; ///< triangles
};

/// ROAM over any coarse mesh, whose triangles may carry TINs: the coarsest mesh of its bintrees in which no
/// point of the surface is farther from where it is drawn than the tolerance allows at its distance. A vertex
/// is wanted when it is active, or when the border of a patch whose carrier would split depends on it. Wanted
/// vertices depend on wanted ones alone, so the mesh is a function of the eye: equal for equal eyes, whatever
/// came before.
/// Memory: 3 B a triangle of the complete bintrees, without the bounds.
class BisectionMesh
{
public:
    /// `surface` and `patches` must stay. Patches are sound by checkPatch(), and no carrier lies below
    /// another.
    explicit BisectionMesh(const BisectionSurface& surface, std::span<const BisectionPatch> patches = {})
        : BisectionMesh(surface, patches, std::make_shared<const BisectionBounds>(surface, patches))
    {
    }

    /// The same, with bounds that others have, too.
    BisectionMesh(const BisectionSurface& surface, std::span<const BisectionPatch> patches,
                  std::shared_ptr<const BisectionBounds> bounds);

    /// Follows an eye, from the mesh of the last one. Cost: one test a triangle of both meshes.
    BisectionChanges refine(const BisectionView& view);

    const BisectionSurface& surface() const { return _surface; }
    std::span<const BisectionPatch> patches() const { return _patches; }
    const BisectionTree& tree() const { return _tree; }
    const BisectionBounds& bounds() const { return *_bounds; }

    bool isShown(std::uint32_t patch) const { return _tree.isSplit(_patches[patch].carrier); }

    std::vector<DrawnBisector> drawn() const;
    const glm::dvec3& point(std::uint32_t vertex) const;

private:
    void findNeeds();
    void addPatch(std::uint32_t patch, std::vector<DrawnBisector>& drawn) const;
    void collect(const BisectorNeighbours& at, const CornerVertices& corners,
                 std::vector<DrawnBisector>& drawn) const;
    void follow(const BisectorNeighbours& at, const BisectionView& view, BisectionChanges& changes);

    const BisectionSurface& _surface;
    std::span<const BisectionPatch> _patches;
    CarrierTable _carriers;
    std::shared_ptr<const BisectionBounds> _bounds;
    BisectionTree _tree;
    std::vector<std::vector<std::uint32_t>> _needs; ///< by patch: vertices on which its border depends
    std::vector<bool> _isPatchActive;
    std::vector<std::uint16_t> _needed; ///< by vertex: active patches that need it
    std::vector<std::uint32_t>
        _firstInside; ///< by patch: number of its first point that is not on the border
};

} // namespace osgTerrainROAM::core
