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

/// Faces that collapse, with the star of every position: the faces around it. Any set of faces will do, however many meet at an
/// edge; those that use a position twice are left out.
/// Invariant: the corners in a position's list are those of faces that are there, and have that position.
/// Memory: 36 B a face, 4 B a position.
class StarMesh
{
public:
    explicit StarMesh(const Mesh& mesh);

    /// How many faces there were at first.
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

    /// Takes the faces with both positions away, and gives the others around `from` to `to`, with wedges as told; a wedge that
    /// is not told of stays. Returns how many faces went. Cost: linear in the two stars.
    /// Threads: any number at once, each in connected parts of its own.
    std::uint32_t collapse(std::uint32_t from, std::uint32_t to, std::span<const WedgeCollapse> wedges);

private:
    static constexpr std::uint32_t kNone = ~0u;

    void link(std::uint32_t position, HalfEdge corner);
    void unlink(std::uint32_t position, HalfEdge corner);

    std::vector<Triangle> _positions, _wedges; ///< by face
    std::vector<HalfEdge> _first;              ///< by position: a corner there
    std::vector<HalfEdge> _next;               ///< by corner: another one at the same position
    std::uint32_t _faceCount = 0;
};

} // namespace osgPMObjects::core
