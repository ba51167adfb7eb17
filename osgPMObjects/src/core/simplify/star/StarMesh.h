// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// The faces of a mesh during collapses, with lists of those around each position. Any set of faces is
/// allowed, with any number at an edge; faces that use a position twice are left out.
/// Invariant: a position's list has the corners at that position of existing faces.
/// Memory: 36 B a face, 4 B a position.
class StarMesh
{
public:
    explicit StarMesh(const Mesh& mesh);

    /// Number of faces at the start.
    std::uint32_t faceCount() const { return _faceCount; }
    const Triangle& positions(std::uint32_t face) const { return _positions[face]; }
    const Triangle& wedges(std::uint32_t face) const { return _wedges[face]; }
    bool hasFaces(std::uint32_t position) const { return _first[position] != kNone; }

    /// Calls `visit(face, corner)` for all faces around a position.
    template<class Visit>
    void visitStar(std::uint32_t position, const Visit& visit) const
    {
        for (std::uint32_t c = _first[position]; c != kNone; c = _next[c])
            visit(faceOf(c), cornerOf(c));
    }

    /// Removes the faces with both positions, and moves the others around `from` to `to`, with their wedges
    /// replaced as given; other wedges stay. Returns the number of removed faces. Cost: linear in the two
    /// stars.
    /// Threads: any number at once, each in connected parts of its own.
    std::uint32_t collapse(std::uint32_t from, std::uint32_t to, std::span<const WedgeCollapse> wedges);

private:
    static constexpr std::uint32_t kNone = ~0u;

    void link(std::uint32_t position, HalfEdge corner);
    void unlink(std::uint32_t position, HalfEdge corner);

    std::vector<Triangle> _positions, _wedges; ///< by face
    std::vector<HalfEdge> _first;              ///< by position: its first corner
    std::vector<HalfEdge> _next;               ///< by corner: the next at the same position
    std::uint32_t _faceCount = 0;
};

} // namespace osgPMObjects::core
