// SPDX-License-Identifier: Apache-2.0
#include "StarMesh.h"

#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

StarMesh::StarMesh(const Mesh& mesh)
    : _positions(positionTriangles(mesh)),
      _first(mesh.positions.size(), kNone),
      _next(3 * mesh.faces.size(), kNone)
{
    _wedges.reserve(mesh.faces.size());
    for (const Face& face : mesh.faces)
        _wedges.push_back(face.wedges);
    for (auto face = static_cast<std::uint32_t>(_positions.size());
         face-- > 0;) // backwards: lists begin with the first
    {
        if (repeatsCorner(_positions[face])) continue;
        ++_faceCount;
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            link(_positions[face][corner], 3 * face + corner);
    }
}

void StarMesh::link(std::uint32_t position, HalfEdge corner)
{
    _next[corner] = _first[position];
    _first[position] = corner;
}

void StarMesh::unlink(std::uint32_t position, HalfEdge corner)
{
    HalfEdge* at = &_first[position];
    while (*at != corner)
        at = &_next[*at];
    *at = _next[corner];
}

std::uint32_t StarMesh::collapse(std::uint32_t from, std::uint32_t to, std::span<const WedgeCollapse> wedges)
{
    std::uint32_t gone = 0;
    for (HalfEdge c = _first[from]; c != kNone;)
    {
        const HalfEdge next = _next[c];
        Triangle& corners = _positions[faceOf(c)];
        const bool vanishes = corners[0] == to || corners[1] == to || corners[2] == to;
        if (vanishes)
        {
            for (std::uint32_t other = 0; other < 3; ++other)
                if (corners[other] != from) unlink(corners[other], 3 * faceOf(c) + other);
            ++gone;
        }
        else
        {
            std::uint32_t& wedge = _wedges[faceOf(c)][cornerOf(c)];
            for (const WedgeCollapse& becomes : wedges)
                if (becomes.from == wedge)
                {
                    wedge = becomes.to;
                    break;
                }
            corners[cornerOf(c)] = to;
            link(to, c);
        }
        c = next;
    }
    _first[from] = kNone;
    return gone;
}

} // namespace osgPMObjects::core
