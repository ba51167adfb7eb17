// SPDX-License-Identifier: Apache-2.0
#include "pmtool/OrderSubject.h"

#include <numeric>
#include <system_error>
#include <unordered_map>
#include <utility>

#include <osgDB/ReadFile>

#include <osgPMObjects/core/consolidate/MergeWedges.h>

#include <osgPMObjects/ImportNode>

namespace pmtool
{

namespace
{

using osgPMObjects::core::Face;
using osgPMObjects::core::Mesh;

/// Numbers the vertices of a draw call as they come.
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

viewlod::Result<Mesh> readMesh(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return viewlod::Error{file.string(), "there is no such file", "check its path"};
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(file.string());
    if (!node)
        return viewlod::Error{file.string(), "cannot be read by OpenSceneGraph",
                              "give a model in a format that osgconv knows"};
    auto imported = osgPMObjects::importNode(*node, file.string());
    if (!imported) return imported.error();
    if (imported->mesh.faces.empty())
        return viewlod::Error{file.string(), "has no triangles", "give a model with surfaces"};
    return std::move(imported->mesh);
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

viewlod::Result<std::array<OrderSubject, 2>> readOrderSubjects(const std::filesystem::path& file)
{
    auto mesh = readMesh(file);
    if (!mesh) return mesh.error();
    OrderSubject positions = byPositions(*mesh);
    osgPMObjects::core::mergeWedges(*mesh);
    return std::array<OrderSubject, 2>{std::move(positions), byWedges(*mesh)};
}

} // namespace pmtool
