// SPDX-License-Identifier: Apache-2.0
#include "PartRemoval.h"

#include <algorithm>
#include <map>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/UnionFind.h>

namespace osgPMObjects::core
{

PartRemoval::PartRemoval(const LiveFaces& live, const std::vector<bool>& isSupport) : _live(live)
{
    const Mesh& mesh = live.mesh();
    const auto positions = static_cast<std::uint32_t>(mesh.positions.size());
    UnionFind groups(positions);
    for (const Face& face : mesh.faces)
        for (const int c : {1, 2})
            groups.join(mesh.positionOf(face, 0), mesh.positionOf(face, c));
    for (std::uint32_t p = 0; p < positions; ++p)
        if (live.degree(p) > 0) _positions.push_back(p);
    std::stable_sort(_positions.begin(), _positions.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return groups.root(a) < groups.root(b); });
    for (std::uint32_t i = 0; i < _positions.size();)
    {
        Part part{i};
        Extent extent;
        const std::uint32_t root = groups.root(_positions[i]);
        for (; i < _positions.size() && groups.root(_positions[i]) == root; ++i)
        {
            extent.add(mesh.positions[_positions[i]]);
            part.hasSupport = part.hasSupport || (!isSupport.empty() && isSupport[_positions[i]]);
        }
        part.diagonal = extent.diagonal();
        _parts.push_back(part);
    }
}

std::span<const std::uint32_t> PartRemoval::positionsOf(std::uint32_t part) const
{
    const std::size_t end = part + 1 < _parts.size() ? _parts[part + 1].first : _positions.size();
    return std::span(_positions).subspan(_parts[part].first, end - _parts[part].first);
}

bool PartRemoval::mayGo(std::uint32_t part) const
{
    if (_parts[part].hasSupport) return false;
    std::map<std::uint32_t, std::size_t> corners; // by material
    for (const std::uint32_t p : positionsOf(part))
        _live.visit(p, [&](std::uint32_t slot, int) { ++corners[_live.face(slot).material]; });
    return std::all_of(corners.begin(), corners.end(),
                       [&](const auto& ofMaterial)
                       { return 3 * _live.facesOf(ofMaterial.first) > ofMaterial.second; });
}

} // namespace osgPMObjects::core
