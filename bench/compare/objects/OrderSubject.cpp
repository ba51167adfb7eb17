// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/OrderSubject.h"

#include <numeric>
#include <unordered_map>
#include <utility>

#include <osgPMObjects/core/consolidate/MergeWedges.h>

namespace pmtool
{

namespace
{

using osgPMObjects::core::Face;
using osgPMObjects::core::Mesh;

/// Numbers the vertices of a draw call as they are first used.
class CallBuilder
{
public:
    explicit CallBuilder(const Mesh& mesh) : _mesh(mesh) {}

    /// `vertices`: of the face's corners, `face`: for where they are.
    void add(const osgPMObjects::core::Triangle& vertices, const Face& face)
    {
        osgPMObjects::core::Triangle& t = call.triangles.emplace_back();
        for (int corner = 0; corner < 3; ++corner)
        {
            const auto next = static_cast<std::uint32_t>(call.positions.size());
            const auto [at, isNew] = _numbers.try_emplace(vertices[corner], next);
            if (isNew) call.positions.push_back(_mesh.at(face, corner));
            t[corner] = at->second;
        }
    }

    DrawCall call;

private:
    const Mesh& _mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> _numbers;
};

OrderSubject byPositions(const Mesh& mesh)
{
    CallBuilder all(mesh);
    for (const Face& face : mesh.faces)
        all.add({mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)}, face);
    OrderSubject subject{"positions", {}};
    subject.calls.push_back(std::move(all.call));
    return subject;
}

OrderSubject byWedges(const Mesh& mesh)
{
    std::vector<CallBuilder> builders(mesh.materials.size(), CallBuilder(mesh));
    for (const Face& face : mesh.faces)
        builders[face.material].add(face.wedges, face);
    OrderSubject subject{"wedges", {}};
    for (CallBuilder& builder : builders)
        if (!builder.call.triangles.empty()) subject.calls.push_back(std::move(builder.call));
    return subject;
}

} // namespace

std::size_t OrderSubject::triangleCount() const
{
    return std::accumulate(calls.begin(), calls.end(), std::size_t(0),
                           [](std::size_t sum, const DrawCall& call) { return sum + call.triangles.size(); });
}

std::size_t OrderSubject::vertexCount() const
{
    return std::accumulate(calls.begin(), calls.end(), std::size_t(0),
                           [](std::size_t sum, const DrawCall& call) { return sum + call.positions.size(); });
}

std::array<OrderSubject, 2> orderSubjects(Mesh mesh)
{
    OrderSubject positions = byPositions(mesh);
    osgPMObjects::core::mergeWedges(mesh);
    return {std::move(positions), byWedges(mesh)};
}

} // namespace pmtool
