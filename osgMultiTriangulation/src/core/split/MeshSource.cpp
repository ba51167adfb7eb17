// SPDX-License-Identifier: Apache-2.0
#include "MeshSource.h"

#include <algorithm>

namespace osgMultiTriangulation::core
{

namespace
{

class MeshPoints : public PartSource::Points
{
public:
    MeshPoints(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& joinedAt)
        : _mesh(mesh), _joinedAt(joinedAt)
    {
    }

    SourcePoint at(std::uint32_t number) override { return {_mesh.points[number], _joinedAt[number]}; }

private:
    const SurfaceMesh& _mesh;
    const std::vector<std::uint8_t>& _joinedAt;
};

} // namespace

MeshSource::MeshSource(const SurfaceMesh& mesh, const Partition& partition)
    : _mesh(mesh),
      _trianglesOf(mesh.triangles.size()),
      _firstOf(partition.parts.size() + 1, 0),
      _joinedAt(mesh.points.size(), 255)
{
    std::vector<std::uint32_t> partOf, holders;
    partOf.reserve(mesh.points.size());
    for (const SurfacePoint& point : mesh.points)
        partOf.push_back(partition.partAt(point));
    holders.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
    {
        const std::uint32_t holder =
            partition.common(partition.common(partOf[t[0]], partOf[t[1]]), partOf[t[2]]);
        const std::uint8_t depth = partition.joinDepth(holder);
        for (const std::uint32_t corner : t)
            _joinedAt[corner] = std::min(_joinedAt[corner], depth);
        holders.push_back(holder);
        ++_firstOf[holder + 1];
    }
    for (std::size_t part = 1; part < _firstOf.size(); ++part)
        _firstOf[part] += _firstOf[part - 1];
    std::vector<std::uint32_t> next(_firstOf.begin(), _firstOf.end() - 1);
    for (std::uint32_t t = 0; t < holders.size(); ++t)
        _trianglesOf[next[holders[t]]++] = t;
}

std::unique_ptr<PartSource::Points> MeshSource::points() const
{
    return std::make_unique<MeshPoints>(_mesh, _joinedAt);
}

std::vector<Triangle> MeshSource::trianglesOf(std::uint32_t part) const
{
    std::vector<Triangle> triangles;
    triangles.reserve(_firstOf[part + 1] - _firstOf[part]);
    for (std::uint32_t i = _firstOf[part]; i < _firstOf[part + 1]; ++i)
        triangles.push_back(_mesh.triangles[_trianglesOf[i]]);
    return triangles;
}

} // namespace osgMultiTriangulation::core
