// SPDX-License-Identifier: Apache-2.0
#include "ShapeArrays.h"

#include <algorithm>

#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

namespace osgPMObjects
{

namespace
{

using core::Material;
using core::Mesh;

template<class Array>
osg::ref_ptr<Array> arrayFor(const Mesh& mesh, std::uint32_t attribute, osg::VertexBufferObject* buffer)
{
    const bool isWanted = std::any_of(mesh.materials.begin(), mesh.materials.end(),
                                      [&](const Material& m) { return (m.attributes & attribute) != 0; });
    if (!isWanted) return nullptr;
    const osg::ref_ptr<Array> array =
        new Array(osg::Array::BIND_PER_VERTEX, static_cast<unsigned>(mesh.wedgeCount()));
    array->setVertexBufferObject(buffer);
    return array;
}

} // namespace

ShapeArrays::ShapeArrays(const core::ProgressiveMesh& progressive, const glm::dvec3& origin)
{
    const Mesh& mesh = progressive.mesh;
    const osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    _vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX, static_cast<unsigned>(mesh.wedgeCount()));
    _vertices->setVertexBufferObject(buffer);
    _normals = arrayFor<osg::Vec3Array>(mesh, Material::normal, buffer);
    _colours = arrayFor<osg::Vec4Array>(mesh, Material::colour, buffer);
    _texCoords[0] = arrayFor<osg::Vec2Array>(mesh, Material::texCoord0, buffer);
    _texCoords[1] = arrayFor<osg::Vec2Array>(mesh, Material::texCoord1, buffer);
    for (std::uint32_t i = 0; i < mesh.wedgeCount(); ++i)
    {
        const core::Wedge wedge = core::wedgeOf(mesh, i);
        const glm::dvec3 p = mesh.positions[wedge.position] - origin;
        (*_vertices)[i] = osg::Vec3d(p.x, p.y, p.z);
        if (_normals) (*_normals)[i] = {wedge.normal.x, wedge.normal.y, wedge.normal.z};
        if (_colours) (*_colours)[i] = {wedge.colour.r, wedge.colour.g, wedge.colour.b, wedge.colour.a};
        for (unsigned set = 0; set < Mesh::kTexCoordSets; ++set)
            if (_texCoords[set]) (*_texCoords[set])[i] = {wedge.texCoords[set].x, wedge.texCoords[set].y};
    }
}

osg::ref_ptr<osg::Geometry> ShapeArrays::geometryOf(const Material& material,
                                                    const std::vector<bool>& isUsed) const
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(_vertices);
    if (material.has(Material::normal)) geometry->setNormalArray(_normals);
    if (material.has(Material::colour)) geometry->setColorArray(coloursOf(isUsed));
    if (material.has(Material::texCoord0)) geometry->setTexCoordArray(0, _texCoords[0]);
    if (material.has(Material::texCoord1)) geometry->setTexCoordArray(1, _texCoords[1]);
    return geometry;
}

osg::ref_ptr<osg::Array> ShapeArrays::coloursOf(const std::vector<bool>& isUsed) const
{
    const auto first = std::find(isUsed.begin(), isUsed.end(), true) - isUsed.begin();
    for (std::size_t i = 0; i < isUsed.size(); ++i)
        if (isUsed[i] && (*_colours)[i] != (*_colours)[static_cast<std::size_t>(first)]) return _colours;
    return new osg::Vec4Array(osg::Array::BIND_OVERALL, 1, &(*_colours)[static_cast<std::size_t>(first)]);
}

std::vector<std::vector<bool>> wedgesByGroup(const core::ProgressiveMesh& progressive)
{
    std::vector<std::vector<bool>> byGroup(progressive.groups.size(),
                                           std::vector<bool>(progressive.mesh.wedgeCount(), false));
    core::ProgressiveLevel level(progressive);
    level.moveTo(0);
    core::forEachDrawnFace(progressive, level,
                           [&](const core::Triangle& face, std::uint32_t group)
                           {
                               for (const std::uint32_t wedge : face)
                                   byGroup[group][wedge] = true;
                           });
    // What wedges become has a lower number.
    for (std::vector<bool>& isUsed : byGroup)
        for (std::size_t wedge = isUsed.size(); wedge-- > 0;)
            if (isUsed[wedge]) isUsed[progressive.parents[wedge]] = true;
    return byGroup;
}

} // namespace osgPMObjects
