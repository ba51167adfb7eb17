// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/bisection/Bisector.h>

namespace osgTerrainROAM::core
{

/// The triangle bintrees over all sides of a coarse mesh, and ROAM's operations on them. No grid is needed:
/// the neighbour across the base of a root is the root of the twin, and all others follow.
/// Invariant: isConforming(). Memory: one bit a triangle of the complete bintrees.
/// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 4; *Methods of continuous level of detail for
/// terrain* (Graphicon 2002), section 5.2 (enhMerge). Roots as in Bisector.h.
class BisectionTree
{
public:
    /// `levels`: of the finest triangles, 1 … 24. `mesh` must stay.
    BisectionTree(const CoarseMesh& mesh, int levels);

    int levels() const { return _levels; }
    const CoarseMesh& mesh() const { return _mesh; }

    bool isSplit(Bisector t) const { return t.level() < _levels && _isSplit[placeOf(t)]; }
    bool isThere(Bisector t) const { return t.exists() && (t.node == 1 || isSplit(t.parent())); }

    /// Splits a leaf and its base neighbour; splits first the coarser leaves that this needs. Returns the
    /// number of triangles split.
    /// Precondition: a leaf above the last level.
    std::uint32_t forceSplit(Bisector t);

    /// Makes a split triangle and its base neighbour leaves: removes the vertex between them after all that
    /// hang on it, inside and, across legs, outside. Returns the number of triangles merged. Cost: one visit
    /// a vertex that goes, and the way to it.
    std::uint32_t enhMerge(Bisector t);

    std::uint32_t leafCount() const { return _leaves; }

    /// Calls visit(leaf) for all leaves.
    template<class Visit>
    void forEachLeaf(const Visit& visit) const
    {
        for (std::uint32_t side = 0; side < _mesh.sides(); ++side)
            visitLeaves({side, 1}, visit);
    }

    /// Checks exhaustively that both triangles at a base are split or neither, that only triangles that are
    /// there are split, and the number of leaves. For tests.
    bool isConforming() const;

private:
    friend struct BisectionTreeMutator; ///< tests damage the tree through it

    std::size_t placeOf(Bisector t) const { return std::size_t{t.side} << _levels | t.node; }
    void set(Bisector t, bool isSplit);
    std::uint32_t removeVertex(const BisectorNeighbours& at);

    template<class Visit>
    void visitLeaves(Bisector t, const Visit& visit) const
    {
        if (!isSplit(t)) return visit(t);
        visitLeaves(t.half(0), visit);
        visitLeaves(t.half(1), visit);
    }

    const CoarseMesh& _mesh;
    int _levels;
    std::uint32_t _leaves;
    std::vector<bool> _isSplit; ///< by side and node
};

} // namespace osgTerrainROAM::core
