// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

using osgPMObjects::core::Triangle;

/// vsplit(v0, v1, fL, fR, f0, f1, f2, f3): vertex v1 splits into itself and the new vertex v0. fL and fR are
/// the new faces on the edge v1–v0, to the left and to the right of it. The faces around v1 from f0 to f3 go
/// over to v0. On a border some are kNone.
///
/// ```
///        f0  v0  f3                      f0   f3
///   vl -----/  \----- vr            vl ---- v1 ---- vr
///      \ fL | fR /          ecol       f1   f2
///   f1  \   |   /  f2       ---->
///          v1                        <----  vsplit
/// ```
struct VertexSplit
{
    std::uint32_t v1 = kNone;
    std::array<std::uint32_t, 4> f{kNone, kNone, kNone, kNone};

    bool hasLeft() const { return f[0] != kNone || f[1] != kNone; }
    bool hasRight() const { return f[2] != kNone || f[3] != kNone; }
};

/// A view-dependent progressive mesh (VDPM) at rest: the base mesh M0 and the splits that refine it, as a
/// forest of binary trees. The roots are the vertices of the base mesh. A split is an inner node: its
/// children are v1 as it goes on, and v0. So the splits of one vertex have an order (`nextSplit`), and the
/// vertices are fewer than the nodes. Splits are numbered in an order in which all can be done. Split w makes
/// vertex v0(w) and the faces fL(w), fR(w); the numbers of faces that a border split does not make are left
/// out.
/// `dependencies`: the splits that have to be done before w, all of smaller numbers. They make it legal
/// (ActiveFront), and they make the faces that w changes exactly those that they were when the mesh was
/// prepared, whose errors are known: Hoppe's legality alone lets triangles appear that were never measured.
/// Invariant: forestDefect() is empty. Memory: memoryBytes(), about 60 B a split.
/// Source: Hoppe, *View-dependent refinement of progressive meshes*, 1997, sections 3.1 and 4.1; *Methods of
/// continuous level of detail for terrain* (Graphicon 2002), section 4.4. Differs: v1 keeps its number when
/// it splits.
struct VertexForest
{
    std::uint32_t rootVertices = 0;
    std::vector<Triangle> rootFaces; ///< the faces of M0, by vertices below rootVertices
    std::vector<VertexSplit> splits;
    std::vector<std::uint32_t> original;   ///< by vertex: its number in the mesh that was prepared
    std::vector<std::uint32_t> firstSplit; ///< by vertex: the first split of it, or kNone
    std::vector<std::uint32_t> nextSplit;  ///< by split: the next of the same v1, or kNone
    std::vector<std::uint32_t> parent;     ///< by split: the one that made the node which it splits, or kNone
    std::vector<std::uint32_t> firstDependency; ///< by split, and one more
    std::vector<std::uint32_t> dependencies;    ///< ascending for each split

    std::uint32_t splitCount() const { return static_cast<std::uint32_t>(splits.size()); }
    std::uint32_t vertexCount() const { return rootVertices + splitCount(); }
    std::uint32_t faceNumbers() const
    {
        return static_cast<std::uint32_t>(rootFaces.size()) + 2 * splitCount();
    }

    std::uint32_t v0(std::uint32_t split) const { return rootVertices + split; }
    std::uint32_t fL(std::uint32_t split) const
    {
        return static_cast<std::uint32_t>(rootFaces.size()) + 2 * split;
    }
    std::uint32_t fR(std::uint32_t split) const { return fL(split) + 1; }

    /// The split that makes a vertex or a face; kNone: it is in M0.
    std::uint32_t makerOfVertex(std::uint32_t v) const { return v < rootVertices ? kNone : v - rootVertices; }
    std::uint32_t makerOfFace(std::uint32_t face) const
    {
        const auto roots = static_cast<std::uint32_t>(rootFaces.size());
        return face < roots ? kNone : (face - roots) / 2;
    }

    std::span<const std::uint32_t> dependenciesOf(std::uint32_t split) const
    {
        return std::span(dependencies)
            .subspan(firstDependency[split], firstDependency[split + 1] - firstDependency[split]);
    }

    std::size_t memoryBytes() const
    {
        return rootFaces.size() * sizeof(Triangle) + splits.size() * sizeof(VertexSplit) +
               sizeof(std::uint32_t) * (original.size() + firstSplit.size() + nextSplit.size() +
                                        parent.size() + firstDependency.size() + dependencies.size());
    }
};

} // namespace osgTerrainROAM::core
