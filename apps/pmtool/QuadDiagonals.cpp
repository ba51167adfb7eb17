// SPDX-License-Identifier: Apache-2.0
#include "pmtool/QuadDiagonals.h"

#include <array>
#include <set>
#include <vector>

#include <osg/Geometry>
#include <osg/Transform>
#include <osgDB/Registry>

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

/// Reads one element of an array as four numbers.
class ElementReader : public osg::ConstValueVisitor
{
public:
    void apply(const osg::Vec3& v) override { value = osg::Vec4d(v.x(), v.y(), v.z(), 1.0); }
    void apply(const osg::Vec3d& v) override { value = osg::Vec4d(v.x(), v.y(), v.z(), 1.0); }
    void apply(const osg::Vec4& v) override { value = osg::Vec4d(v.x(), v.y(), v.z(), v.w()); }
    void apply(const osg::Vec4d& v) override { value = v; }
    void apply(const osg::Vec4ub& v) override { value = osg::Vec4d(v.r(), v.g(), v.b(), v.a()) / 255.0; }

    osg::Vec4d value{0.0, 0.0, 0.0, 1.0};
};

/// Returns zeros where the array is missing, too short or of another type.
osg::Vec4d elementOf(const osg::Array* array, unsigned vertex, unsigned set)
{
    ElementReader reader;
    if (!array) return reader.value;
    const osg::Array::Binding binding = array->getBinding();
    const unsigned i = binding == osg::Array::BIND_PER_PRIMITIVE_SET ? set
                       : binding == osg::Array::BIND_OVERALL         ? 0
                                                                     : vertex;
    if (i < array->getNumElements()) array->accept(i, reader);
    return reader.value;
}

/// Whether sets of a mode list polygons, one after the other. A fan of four corners is a quad, too: .obj
/// files come so.
bool isOneEach(GLenum mode)
{
    return mode == GL_POLYGON || mode == GL_TRIANGLE_FAN;
}

/// The corners of each polygon in a primitive set that draws polygons, as vertices.
std::vector<std::vector<unsigned>> polygonsOf(const osg::PrimitiveSet& set)
{
    std::vector<std::vector<unsigned>> polygons;
    const unsigned count = set.getNumIndices();
    if (set.getMode() == GL_QUADS)
        for (unsigned i = 0; i + 3 < count; i += 4)
            polygons.push_back({set.index(i), set.index(i + 1), set.index(i + 2), set.index(i + 3)});
    if (set.getMode() == GL_QUAD_STRIP)
        for (unsigned i = 0; i + 3 < count; i += 2)
            polygons.push_back({set.index(i), set.index(i + 1), set.index(i + 3), set.index(i + 2)});
    if (!isOneEach(set.getMode())) return polygons;
    std::vector<unsigned> sizes = {count};
    if (set.getType() == osg::PrimitiveSet::DrawArrayLengthsPrimitiveType)
    {
        sizes.clear();
        for (const GLsizei size : static_cast<const osg::DrawArrayLengths&>(set))
            sizes.push_back(static_cast<unsigned>(size));
    }
    unsigned at = 0;
    for (const unsigned size : sizes)
    {
        auto& polygon = polygons.emplace_back();
        for (unsigned end = at + size; at < end; ++at)
            polygon.push_back(set.index(at));
    }
    return polygons;
}

/// Whether a set draws quads or polygons, and only with vertices that are there. Strips of several lengths
/// are left out.
bool canBeCut(const osg::PrimitiveSet& set, unsigned vertexCount)
{
    const GLenum mode = set.getMode();
    const auto type = set.getType();
    const bool hasLengths = type == osg::PrimitiveSet::DrawArrayLengthsPrimitiveType;
    const bool hasIndices = type == osg::PrimitiveSet::DrawElementsUBytePrimitiveType ||
                            type == osg::PrimitiveSet::DrawElementsUShortPrimitiveType ||
                            type == osg::PrimitiveSet::DrawElementsUIntPrimitiveType;
    if (mode != GL_QUADS && mode != GL_QUAD_STRIP && !isOneEach(mode)) return false;
    if (!hasLengths && !hasIndices && type != osg::PrimitiveSet::DrawArraysPrimitiveType) return false;
    if (hasLengths)
    {
        if (!isOneEach(mode)) return false;
        for (const GLsizei size : static_cast<const osg::DrawArrayLengths&>(set))
            if (size < 0 || static_cast<unsigned>(size) > vertexCount) return false;
    }
    const unsigned count = set.getNumIndices();
    if (!hasIndices && count > vertexCount) return false; // a damaged file may ask for billions
    for (unsigned i = 0; i < count; ++i)
        if (set.index(i) >= vertexCount) return false;
    return true;
}

class QuadCutter : public osg::NodeVisitor
{
public:
    explicit QuadCutter(core::DiagonalRule rule) : NodeVisitor(TRAVERSE_ALL_CHILDREN), _rule(rule)
    {
        setNodeMaskOverride(~0u);
    }

    void apply(osg::Geometry& geometry) override
    {
        if (!geometry.getVertexArray() || !_done.insert(&geometry).second) return;
        if (geometry.containsDeprecatedData()) geometry.fixDeprecatedData();
        _localToRoot = osg::computeLocalToWorld(getNodePath());
        _rootToLocal = osg::Matrixd::inverse(_localToRoot);
        const unsigned vertexCount = geometry.getVertexArray()->getNumElements();
        for (unsigned i = 0; i < geometry.getNumPrimitiveSets(); ++i)
            if (const osg::PrimitiveSet* set = geometry.getPrimitiveSet(i);
                set && canBeCut(*set, vertexCount))
                geometry.setPrimitiveSet(i, trianglesOf(geometry, *set, i));
    }

    QuadCounts counts;

private:
    osg::ref_ptr<osg::DrawElementsUInt> trianglesOf(const osg::Geometry& geometry,
                                                    const osg::PrimitiveSet& set, unsigned number)
    {
        osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
        // Quads are drawn along their corners 1 and 3, polygons as fans.
        const unsigned drawnFrom = isOneEach(set.getMode()) ? 0 : 1;
        for (const std::vector<unsigned>& corners : polygonsOf(set))
        {
            const unsigned from = corners.size() == 4 ? chosen(geometry, corners, number, drawnFrom) : 0;
            const auto size = static_cast<unsigned>(corners.size());
            for (unsigned i = 1; i + 1 < size; ++i)
                for (const unsigned corner : {from, from + i, from + i + 1})
                    triangles->push_back(corners[corner % size]);
        }
        return triangles;
    }

    /// The corner from which a quad is cut.
    unsigned chosen(const osg::Geometry& geometry, const std::vector<unsigned>& corners, unsigned set,
                    unsigned drawnFrom)
    {
        core::Quad quad;
        for (std::size_t i = 0; i < 4; ++i)
        {
            const osg::Vec4d p = elementOf(geometry.getVertexArray(), corners[i], set) * _localToRoot;
            const osg::Vec4d n = elementOf(geometry.getNormalArray(), corners[i], set);
            const osg::Vec4d c = elementOf(geometry.getColorArray(), corners[i], set);
            osg::Vec3d normal = osg::Matrixd::transform3x3(_rootToLocal, osg::Vec3d(n.x(), n.y(), n.z()));
            normal.normalize();
            quad[i] = {
                {p.x(), p.y(), p.z()}, {normal.x(), normal.y(), normal.z()}, {c.x(), c.y(), c.z(), c.w()}};
        }
        const auto corner = core::chooseDiagonal(quad, _rule);
        ++(corner ? counts.cut : counts.left);
        counts.turned += corner && *corner != drawnFrom;
        return corner.value_or(drawnFrom);
    }

    core::DiagonalRule _rule;
    osg::Matrixd _localToRoot, _rootToLocal; ///< transposed, the second one turns normals
    std::set<const osg::Geometry*> _done;
};

} // namespace

QuadCounts cutQuads(osg::Node& root, core::DiagonalRule rule)
{
    QuadCutter cutter(rule);
    root.accept(cutter);
    return cutter.counts;
}

KeptQuads::KeptQuads() : _before(osgDB::Registry::instance()->getOptions())
{
    const std::string word = "noTriStripPolygons";
    const osg::ref_ptr<osgDB::Options> options = _before ? _before->cloneOptions() : new osgDB::Options(word);
    if (_before) options->setOptionString(word + ' ' + _before->getOptionString());
    osgDB::Registry::instance()->setOptions(options);
}

KeptQuads::~KeptQuads()
{
    osgDB::Registry::instance()->setOptions(_before);
}

} // namespace pmtool
