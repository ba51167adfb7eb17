// SPDX-License-Identifier: Apache-2.0
#include "BisectionViewTable.h"

#include <unordered_map>

namespace osgTerrainROAM
{

namespace
{

const osg::Vec4 kGroundColour(0.55F, 0.53F, 0.45F, 1.0F), kTinColour(0.62F, 0.47F, 0.30F, 1.0F);

osg::Vec3 vectorOf(const glm::dvec3& v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Gathers vertices by their numbers. Those of a TIN are its own, so that its colour ends at its border.
struct GatheredVertices
{
    const core::BisectionMesh& mesh;
    osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers{};

    std::uint32_t numberOf(std::uint32_t vertex, std::uint32_t patch)
    {
        const bool isTin = patch != core::kNoSide;
        const auto [found, isNew] = numbers.try_emplace(std::uint64_t{isTin} << 32 | vertex,
                                                        static_cast<std::uint32_t>(places->size()));
        if (isNew)
        {
            places->push_back(vectorOf(mesh.point(vertex)));
            colours->push_back(isTin ? kTinColour : kGroundColour);
        }
        return found->second;
    }
};

} // namespace

osg::ref_ptr<osg::Geometry> geometryOf(const core::BisectionMesh& mesh)
{
    GatheredVertices vertices{mesh};
    const osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    std::unordered_map<std::uint32_t, osg::Vec3>
        normals; // by vertex of the mesh, so that a TIN has those of its neighbours
    const std::vector<core::DrawnBisector> drawn = mesh.drawn();
    for (const core::DrawnBisector& t : drawn)
    {
        const glm::dvec3 &a = mesh.point(t.vertices[0]), &b = mesh.point(t.vertices[1]),
                         &c = mesh.point(t.vertices[2]);
        const osg::Vec3 normal = vectorOf(glm::cross(b - a, c - a));
        for (const std::uint32_t vertex : t.vertices)
        {
            triangles->push_back(vertices.numberOf(vertex, t.patch));
            normals[vertex] += normal;
        }
    }
    const osg::ref_ptr<osg::Vec3Array> directions = new osg::Vec3Array(vertices.places->size());
    for (const auto& [key, number] : vertices.numbers)
    {
        osg::Vec3 normal = normals[static_cast<std::uint32_t>(key)];
        normal.normalize();
        (*directions)[number] = normal;
    }
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices.places);
    geometry->setNormalArray(directions, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(vertices.colours, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(triangles);
    return geometry;
}

osg::ref_ptr<osg::Geometry> BisectionViewTable::answer(const osgTraversal::EyeRequest& request)
{
    const std::lock_guard lock(_mutex);
    const auto newDetail = [this]
    {
        const std::shared_ptr<const core::BisectionBounds> bounds(std::shared_ptr<void>(), &_model.bounds);
        return Detail{std::make_unique<core::BisectionMesh>(_model.surface, _model.patches, bounds), nullptr};
    };
    const auto asked = _groups.ask(
        request, newDetail, [](const Detail&) {}, [](const Detail& given) { return given.geometry.valid(); });
    if (asked.isOfMain) return asked.group.detail.geometry;
    if (asked.isChanged) refine(asked.group);
    return _latest = asked.group.detail.geometry;
}

void BisectionViewTable::refine(osgTraversal::EyeGroups<Detail>::Group& group)
{
    const osgTraversal::AllowedError allowed = group.strictest();
    Detail& detail = group.detail;
    detail.changes = detail.mesh->refine({group.eye, allowed.perDistance, allowed.nearest});
    if (detail.geometry && detail.changes.split == 0 && detail.changes.merged == 0) return;
    detail.geometry = geometryOf(*detail.mesh);
}

osg::ref_ptr<osg::Geometry> BisectionViewTable::latest() const
{
    const std::lock_guard lock(_mutex);
    return _latest;
}

std::vector<BisectionViewStatistics> BisectionViewTable::statistics() const
{
    const std::lock_guard lock(_mutex);
    std::vector<BisectionViewStatistics> all;
    for (const auto& group : _groups.all())
    {
        const Detail& detail = group->detail;
        const auto triangles = detail.geometry ? detail.geometry->getPrimitiveSet(0)->getNumIndices() / 3 : 0;
        all.push_back({group->frame, static_cast<std::uint32_t>(group->members.size()), triangles,
                       detail.changes.split + detail.changes.merged});
    }
    return all;
}

void BisectionViewTable::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (const auto& group : _groups.all())
        if (group->detail.geometry) group->detail.geometry->releaseGLObjects(state);
}

} // namespace osgTerrainROAM
