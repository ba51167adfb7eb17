// SPDX-License-Identifier: Apache-2.0
#include "GeometryReader.h"

#include <cmath>
#include <map>

#include "ArrayValues.h"
#include "Triangles.h"

namespace osgPMObjects
{

namespace
{

using core::Material;
using core::Mesh;

/// An attribute array, read by its binding.
struct BoundValues
{
    std::vector<glm::dvec4> values;
    osg::Array::Binding binding = osg::Array::BIND_OFF;

    BoundValues() = default;
    BoundValues(const osg::Array* array, bool isNormalised)
    {
        if (!array) return;
        binding = array->getBinding();
        values = valuesOf(*array, isNormalised || array->getNormalize());
    }

    /// Returns no value if the array is too short or off; the attribute is 0 then.
    const glm::dvec4* at(unsigned vertex, unsigned primitiveSet) const
    {
        const unsigned i = binding == osg::Array::BIND_PER_VERTEX          ? vertex
                           : binding == osg::Array::BIND_PER_PRIMITIVE_SET ? primitiveSet
                                                                           : 0;
        return binding > osg::Array::BIND_OFF && i < values.size() ? &values[i] : nullptr;
    }

    bool isPerPrimitiveSet() const { return binding == osg::Array::BIND_PER_PRIMITIVE_SET; }
};

bool isFinite(const glm::dvec4& v)
{
    // A value beyond the range of floats is infinite on the card.
    const auto fits = [](double x) { return std::isfinite(static_cast<float>(x)); };
    return fits(v.x) && fits(v.y) && fits(v.z) && fits(v.w);
}

/// Reads one geometry into the mesh.
class Reading
{
public:
    Reading(const osg::Geometry& geometry, const GeometryPlace& place, core::MeshBuilder& mesh,
            ImportReport& report)
        : _place(place),
          _mesh(mesh),
          _report(report),
          _normalMatrix(osg::Matrixd::inverse(place.localToRoot)),
          _isMirrored(determinant(place.localToRoot) < 0.0),
          _normals(geometry.getNormalArray(), true),
          _colours(geometry.getColorArray(), true)
    {
        if (geometry.getVertexArray()) _vertices = valuesOf(*geometry.getVertexArray(), false);
        for (unsigned set = 0; set < Mesh::kTexCoordSets; ++set)
            _texCoords[set] = BoundValues(geometry.getTexCoordArray(set), false);
        _isPerSet = _normals.isPerPrimitiveSet() || _colours.isPerPrimitiveSet();
    }

    void read(const osg::PrimitiveSet& set, unsigned number)
    {
        _set = number;
        if (_isPerSet || _wedges.empty()) _wedges.assign(_vertices.size(), core::HashIndex::kNone);
        const auto take = [this](const std::array<unsigned, 3>& vertices) { this->take(vertices); };
        if (!forEachTriangle(set, static_cast<unsigned>(_vertices.size()), take)) ++_report.refusedPrimitives;
    }

private:
    static double determinant(const osg::Matrixd& m)
    {
        return (osg::Vec3d(m(0, 0), m(0, 1), m(0, 2)) ^ osg::Vec3d(m(1, 0), m(1, 1), m(1, 2))) *
               osg::Vec3d(m(2, 0), m(2, 1), m(2, 2));
    }

    void take(std::array<unsigned, 3> vertices)
    {
        if (_isMirrored) std::swap(vertices[1], vertices[2]);
        core::Face face{{}, _place.material, _place.part};
        for (int i = 0; i < 3; ++i)
        {
            face.wedges[i] = wedgeOf(vertices[i]);
            if (face.wedges[i] != core::HashIndex::kNone) continue;
            ++_report.refusedFaces;
            return;
        }
        _mesh.face(face);
    }

    std::uint32_t wedgeOf(unsigned vertex)
    {
        if (vertex >= _vertices.size()) return core::HashIndex::kNone;
        if (_wedges[vertex] == core::HashIndex::kNone) _wedges[vertex] = makeWedge(vertex);
        return _wedges[vertex];
    }

    std::uint32_t makeWedge(unsigned vertex)
    {
        const glm::dvec4 local = _vertices[vertex];
        const osg::Vec4d root = osg::Vec4d(local.x, local.y, local.z, local.w) * _place.localToRoot;
        const glm::dvec4 where = glm::dvec4(root.x(), root.y(), root.z(), root.w()) / root.w();
        if (!isFinite(where)) return core::HashIndex::kNone;
        core::Wedge wedge;
        wedge.position = _mesh.position(glm::dvec3(where));
        if (const glm::dvec4* n = finite(_normals, vertex))
        {
            const osg::Vec3d turned = osg::Matrixd::transform3x3(_normalMatrix, osg::Vec3d(n->x, n->y, n->z));
            wedge.normal = glm::vec3(turned.x(), turned.y(), turned.z());
        }
        for (unsigned set = 0; set < Mesh::kTexCoordSets; ++set)
            if (const glm::dvec4* t = finite(_texCoords[set], vertex))
            {
                wedge.texCoords[set] = glm::vec2(glm::dvec2(*t) / (t->w == 0.0 ? 1.0 : t->w));
                if (t->z != 0.0) ++_report.droppedComponents;
            }
        if (const glm::dvec4* c = finite(_colours, vertex)) wedge.colour = glm::vec4(*c);
        return _mesh.wedge(wedge);
    }

    const glm::dvec4* finite(const BoundValues& attribute, unsigned vertex)
    {
        const glm::dvec4* value = attribute.at(vertex, _set);
        if (!value || isFinite(*value)) return value;
        ++_report.zeroedAttributes;
        return nullptr;
    }

    const GeometryPlace& _place;
    core::MeshBuilder& _mesh;
    ImportReport& _report;
    osg::Matrixd _normalMatrix; ///< its transpose transforms normals
    bool _isMirrored;
    bool _isPerSet = false;
    std::vector<glm::dvec4> _vertices;
    BoundValues _normals, _colours, _texCoords[Mesh::kTexCoordSets];
    std::vector<std::uint32_t> _wedges; ///< by vertex, as soon as it has one
    unsigned _set = 0;
};

bool isBound(const osg::Array* array)
{
    return array && array->getBinding() > osg::Array::BIND_OFF && array->getNumElements() > 0;
}

void countDropped(const osg::Geometry& geometry, ImportReport& report)
{
    for (unsigned set = Mesh::kTexCoordSets; set < geometry.getNumTexCoordArrays(); ++set)
        report.droppedArrays += isBound(geometry.getTexCoordArray(set));
    for (unsigned i = 0; i < geometry.getNumVertexAttribArrays(); ++i)
        report.droppedArrays += isBound(geometry.getVertexAttribArray(i));
    report.droppedArrays += isBound(geometry.getSecondaryColorArray()) + isBound(geometry.getFogCoordArray());
}

} // namespace

std::uint32_t attributesOf(const osg::Geometry& geometry)
{
    std::uint32_t bits = 0;
    if (isBound(geometry.getNormalArray())) bits |= Material::normal;
    if (isBound(geometry.getTexCoordArray(0))) bits |= Material::texCoord0;
    if (isBound(geometry.getTexCoordArray(1))) bits |= Material::texCoord1;
    if (isBound(geometry.getColorArray())) bits |= Material::colour;
    return bits;
}

void readGeometry(const osg::Geometry& geometry, const GeometryPlace& place, core::MeshBuilder& mesh,
                  ImportReport& report)
{
    ++report.geometries;
    countDropped(geometry, report);
    Reading reading(geometry, place, mesh, report);
    for (unsigned i = 0; i < geometry.getNumPrimitiveSets(); ++i)
        if (const osg::PrimitiveSet* set = geometry.getPrimitiveSet(i); set && isSurface(set->getMode()))
            reading.read(*set, i);
}

} // namespace osgPMObjects
