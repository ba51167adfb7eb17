// SPDX-License-Identifier: Apache-2.0
#include "MeshSnapshot.h"

#include <algorithm>

namespace osgPMObjects::core
{

namespace
{

Triangle cornersOf(const Mesh& mesh, const Face& face)
{
    return {mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)};
}

} // namespace

MeshSnapshot::MeshSnapshot(const Mesh& mesh) : _positions(mesh.positions), _triangles(positionTriangles(mesh))
{
}

std::vector<std::uint32_t> MeshSnapshot::changedSince(const Mesh& mesh,
                                                      std::span<const std::uint32_t> origins) const
{
    std::vector<std::uint8_t> isChanged = marksOfOtherFaces(mesh, origins);
    for (std::size_t p = 0; p < _positions.size(); ++p)
        if (_positions[p] != mesh.positions[p]) isChanged[p] = 1;
    std::vector<std::uint32_t> changed;
    for (const Face& face : mesh.faces)
    {
        const Triangle t = cornersOf(mesh, face);
        if (isChanged[t[0]] || isChanged[t[1]] || isChanged[t[2]])
            changed.insert(changed.end(), t.begin(), t.end());
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

/// Returns by position whether it is a corner of a face that was removed, added, or has other corners.
std::vector<std::uint8_t> MeshSnapshot::marksOfOtherFaces(const Mesh& mesh,
                                                          std::span<const std::uint32_t> origins) const
{
    std::vector<std::uint8_t> marks(mesh.positions.size(), 0);
    const auto mark = [&](const Triangle& t)
    {
        for (const std::uint32_t p : t)
            marks[p] = 1;
    };
    const auto originOf = [&](std::size_t f) { return origins.empty() ? f : origins[f]; };
    std::size_t next = 0;
    for (std::size_t f = 0; f < _triangles.size(); ++f)
    {
        const std::size_t first = next;
        while (next < mesh.faces.size() && originOf(next) == f)
            ++next;
        if (next == first + 1 && cornersOf(mesh, mesh.faces[first]) == _triangles[f]) continue;
        mark(_triangles[f]);
        for (std::size_t piece = first; piece < next; ++piece)
            mark(cornersOf(mesh, mesh.faces[piece]));
    }
    return marks;
}

FaceOrigins::FaceOrigins(Mesh& mesh)
{
    _parts.reserve(mesh.faces.size());
    for (Face& face : mesh.faces)
    {
        const auto number = static_cast<std::uint32_t>(_parts.size());
        _parts.push_back(face.part);
        face.part = number;
    }
}

std::vector<std::uint32_t> FaceOrigins::giveBack(Mesh& mesh) const
{
    std::vector<std::uint32_t> origins;
    origins.reserve(mesh.faces.size());
    for (Face& face : mesh.faces)
    {
        origins.push_back(face.part);
        face.part = _parts[face.part];
    }
    return origins;
}

} // namespace osgPMObjects::core
