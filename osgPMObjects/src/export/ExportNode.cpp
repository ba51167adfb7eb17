// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>

#include <osgPMObjects/core/mesh/EqualWedges.h>
#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/Wedge.h>

#include <osgPMObjects/ExportNode>

#include "DrawnState.h"
#include "FloatOrigin.h"

namespace osgPMObjects
{

namespace
{

using core::Material;
using core::Mesh;

template<class Array>
Array* arrayFor(bool isWanted)
{
    return isWanted ? new Array(osg::Array::BIND_PER_VERTEX) : nullptr;
}

/// Builds one geometry, with its vertices in order of first use.
class GeometryMaker
{
public:
    GeometryMaker(const Mesh& mesh, const Material& material, const glm::dvec3& origin)
        : _mesh(mesh),
          _origin(origin),
          _normals(arrayFor<osg::Vec3Array>(material.has(Material::normal))),
          _colours(arrayFor<osg::Vec4Array>(material.has(Material::colour)))
    {
        _texCoords[0] = arrayFor<osg::Vec2Array>(material.has(Material::texCoord0));
        _texCoords[1] = arrayFor<osg::Vec2Array>(material.has(Material::texCoord1));
    }

    /// `firstEqual`: by wedge, firstEqualWedges().
    void add(const core::Face& face, std::span<const std::uint32_t> firstEqual,
             std::vector<std::uint32_t>& vertexOfWedge)
    {
        for (const std::uint32_t corner : face.wedges)
        {
            const std::uint32_t wedge = firstEqual[corner];
            std::uint32_t& vertex = vertexOfWedge[wedge];
            if (vertex == core::HashIndex::kNone || !isMine(vertex, wedge)) vertex = addVertex(wedge);
            _indices.push_back(vertex);
        }
    }

    osg::ref_ptr<osg::Geometry> make(const StripMaker& strip) const
    {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(_vertices);
        if (_normals) geometry->setNormalArray(_normals);
        if (_colours) geometry->setColorArray(overallIfUniform());
        for (unsigned set = 0; set < Mesh::kTexCoordSets; ++set)
            if (_texCoords[set]) geometry->setTexCoordArray(set, _texCoords[set]);
        const GLenum mode = strip ? GL_TRIANGLE_STRIP : GL_TRIANGLES;
        const std::vector<std::uint32_t> sent =
            strip ? strip(trianglesWithArea(), static_cast<std::uint32_t>(_wedges.size())) : _indices;
        geometry->addPrimitiveSet(_vertices->size() <= 65536 ? elements<osg::DrawElementsUShort>(mode, sent)
                                                             : elements<osg::DrawElementsUInt>(mode, sent));
        return geometry;
    }

private:
    /// Returns whether a number in the table is that of a vertex of this geometry; the table keeps those of
    /// earlier ones.
    bool isMine(std::uint32_t vertex, std::uint32_t wedge) const
    {
        return vertex < _wedges.size() && _wedges[vertex] == wedge;
    }

    std::uint32_t addVertex(std::uint32_t wedge)
    {
        const core::Wedge w = core::wedgeOf(_mesh, wedge);
        const glm::dvec3 p = _mesh.positions[w.position] - _origin;
        _vertices->push_back(osg::Vec3d(p.x, p.y, p.z));
        if (_normals) _normals->push_back({w.normal.x, w.normal.y, w.normal.z});
        if (_colours) _colours->push_back({w.colour.r, w.colour.g, w.colour.b, w.colour.a});
        for (unsigned set = 0; set < Mesh::kTexCoordSets; ++set)
            if (_texCoords[set]) _texCoords[set]->push_back({w.texCoords[set].x, w.texCoords[set].y});
        _wedges.push_back(wedge);
        return static_cast<std::uint32_t>(_wedges.size() - 1);
    }

    osg::ref_ptr<osg::Vec4Array> overallIfUniform() const
    {
        const osg::Vec4 first = _colours->front();
        if (std::any_of(_colours->begin(), _colours->end(), [&](const osg::Vec4& c) { return c != first; }))
            return _colours;
        return new osg::Vec4Array(osg::Array::BIND_OVERALL, 1, &first);
    }

    std::vector<core::Triangle> trianglesWithArea() const
    {
        std::vector<core::Triangle> triangles;
        for (std::size_t i = 0; i < _indices.size(); i += 3)
            if (const core::Triangle t{_indices[i], _indices[i + 1], _indices[i + 2]};
                !core::repeatsCorner(t))
                triangles.push_back(t);
        return triangles;
    }

    template<class Elements>
    static osg::ref_ptr<osg::PrimitiveSet> elements(GLenum mode, const std::vector<std::uint32_t>& sent)
    {
        osg::ref_ptr<Elements> elements = new Elements(mode);
        elements->reserve(sent.size());
        for (const std::uint32_t index : sent)
            elements->push_back(static_cast<typename Elements::value_type>(index));
        return elements;
    }

    const Mesh& _mesh;
    glm::dvec3 _origin;
    osg::ref_ptr<osg::Vec3Array> _vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec3Array> _normals;
    osg::ref_ptr<osg::Vec4Array> _colours;
    osg::ref_ptr<osg::Vec2Array> _texCoords[Mesh::kTexCoordSets];
    std::vector<std::uint32_t> _wedges; ///< by vertex
    std::vector<std::uint32_t> _indices;
};

/// Returns the face numbers by part, then material, in order of first use, and within these in the order of
/// the mesh.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>
facesByGeometry(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> groups;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        groups[{mesh.faces[f].part, mesh.faces[f].material}].push_back(f);
    return groups;
}

} // namespace

osg::ref_ptr<osg::Group> exportNode(const Mesh& mesh, std::span<const osg::ref_ptr<osg::StateSet>> states,
                                    const StripMaker& strip)
{
    const glm::dvec3 origin = floatOrigin(mesh.positions);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    if (origin != glm::dvec3(0.0))
        root = new osg::MatrixTransform(osg::Matrixd::translate(origin.x, origin.y, origin.z));
    const std::vector<std::uint32_t> firstEqual = core::firstEqualWedges(mesh);
    std::vector<std::uint32_t> vertexOfWedge(mesh.wedgeCount(), core::HashIndex::kNone);
    for (const auto& [key, faces] : facesByGeometry(mesh))
    {
        const Material& material = mesh.materials[key.second];
        GeometryMaker maker(mesh, material, origin);
        for (const std::uint32_t f : faces)
            maker.add(mesh.faces[f], firstEqual, vertexOfWedge);
        const osg::ref_ptr<osg::Geometry> geometry = maker.make(strip);
        geometry->setName(mesh.parts[key.first].name);
        geometry->setStateSet(drawnState(material, states));
        const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(mesh.parts[key.first].name);
        geode->addDrawable(geometry);
        root->addChild(geode);
    }
    return root;
}

} // namespace osgPMObjects
