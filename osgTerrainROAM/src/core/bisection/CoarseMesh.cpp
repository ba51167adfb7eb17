// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <unordered_map>

#include <osgTerrainROAM/core/bisection/CoarseMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

bool isFace(const std::vector<std::uint32_t>& corners, std::size_t points)
{
    std::vector<std::uint32_t> sorted = corners;
    std::ranges::sort(sorted);
    return sorted.size() >= 3 && sorted.back() < points && std::ranges::adjacent_find(sorted) == sorted.end();
}

} // namespace

foundation::Result<CoarseMesh> CoarseMesh::make(std::vector<glm::dvec3> points,
                                                const std::vector<std::vector<std::uint32_t>>& faces,
                                                const std::string& place)
{
    CoarseMesh mesh;
    mesh._points = std::move(points);
    mesh._firstSide.push_back(0);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
    {
        if (!isFace(faces[f], mesh._points.size()))
            return foundation::Error{place,
                                     "face " + std::to_string(f) + " has no three corners, or one twice",
                                     "give each face different corners that are there"};
        glm::dvec3 sum(0.0);
        for (const std::uint32_t corner : faces[f])
        {
            mesh._origin.push_back(corner);
            mesh._face.push_back(f);
            sum += mesh._points[corner];
        }
        mesh._centres.push_back(sum / static_cast<double>(faces[f].size()));
        mesh._firstSide.push_back(mesh.sides());
    }
    if (const auto paired = mesh.pair(place); !paired) return paired.error();
    return mesh;
}

std::uint32_t CoarseMesh::next(std::uint32_t side) const
{
    const std::uint32_t f = _face[side];
    return side + 1 == _firstSide[f + 1] ? _firstSide[f] : side + 1;
}

std::uint32_t CoarseMesh::previous(std::uint32_t side) const
{
    const std::uint32_t f = _face[side];
    return side == _firstSide[f] ? _firstSide[f + 1] - 1 : side - 1;
}

foundation::Outcome CoarseMesh::pair(const std::string& place)
{
    _twin.assign(_origin.size(), kNoSide);
    std::unordered_map<std::uint64_t, std::uint32_t> byEnds;
    const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
    for (std::uint32_t s = 0; s < sides(); ++s)
        if (!byEnds.emplace(key(_origin[s], _origin[next(s)]), s).second)
            return foundation::Error{place,
                                     "faces share the edge from point " + std::to_string(_origin[s]) +
                                         " to point " + std::to_string(_origin[next(s)]) +
                                         " in the same direction",
                                     "turn faces so that all look outwards; an edge may have two of them"};
    for (std::uint32_t s = 0; s < sides(); ++s)
        if (const auto found = byEnds.find(key(_origin[next(s)], _origin[s])); found != byEnds.end())
            _twin[s] = found->second;
    return foundation::success();
}

CoarseMesh cubeMesh()
{
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    return *CoarseMesh::make(
        std::move(points),
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, "the cube");
}

} // namespace osgTerrainROAM::core
