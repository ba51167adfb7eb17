// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/FacetNodes.h"

#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osgSky/SunShadows>
#include <osgUtil/GLObjectsVisitor>

#include "scenery/nodes/RangedGroup.h"

namespace scenery
{

namespace
{

osg::Vec3f vectorOf(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

/// Lets shadow maps alone draw what has it: their cameras leave out what casts no shadow.
struct DrawnInMapsAlone : osg::Drawable::CullCallback
{
    bool cull(osg::NodeVisitor* visitor, osg::Drawable*, osg::State*) const override
    {
        return (visitor->getTraversalMask() & osgSky::SunShadows::kCastsNone) != 0;
    }
};

osg::ref_ptr<osg::Geometry> geometryAt(const osg::ref_ptr<osg::Vec3Array>& positions)
{
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setUseDisplayList(false);
    geometry->setVertexArray(positions);
    return geometry;
}

/// A place whose content the driver is given where it is drawn first: of a large world the first picture
/// shows little, and all of it would be copied before.
struct LatePlace : osg::MatrixTransform
{
    explicit LatePlace(const glm::dvec3& origin)
        : osg::MatrixTransform(osg::Matrixd::translate(origin.x, origin.y, origin.z))
    {
    }

    void traverse(osg::NodeVisitor& visitor) override
    {
        if (!dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor)) osg::MatrixTransform::traverse(visitor);
    }
};

osg::Group& placeAt(osg::Group& parent, const glm::dvec3& origin)
{
    const osg::ref_ptr<osg::MatrixTransform> place = new LatePlace(origin);
    parent.addChild(place);
    return *place;
}

} // namespace

osg::ref_ptr<osg::Geometry> geometryOf(const Facets& facets)
{
    const std::size_t count = facets.positions.size();
    const auto corners = static_cast<unsigned>(count);
    const osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array(corners),
                                       normals = new osg::Vec3Array(corners);
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(corners);
    const osg::ref_ptr<osg::Vec2Array> uvs = new osg::Vec2Array(corners);
    for (std::size_t i = 0; i < count; ++i)
    {
        (*positions)[i] = vectorOf(facets.positions[i]);
        (*normals)[i] = vectorOf(facets.normals[i]);
        (*colours)[i] = osg::Vec4f(vectorOf(facets.colours[i]), facets.skies[i]);
        (*uvs)[i].set(facets.uvs[i].x, facets.uvs[i].y);
    }
    const osg::ref_ptr<osg::Geometry> geometry = geometryAt(positions);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, uvs, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, facets.indices.begin(), facets.indices.end()));
    return geometry;
}

osg::ref_ptr<osg::Geometry> casterOf(const std::map<models::Painting, Facets>& facets)
{
    const osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
    const osg::ref_ptr<osg::DrawElementsUInt> indices = new osg::DrawElementsUInt(GL_TRIANGLES);
    std::size_t corners = 0, all = 0;
    for (const auto& [painting, some] : facets)
    {
        corners += some.positions.size();
        all += some.indices.size();
    }
    positions->reserve(corners);
    indices->reserve(all);
    for (const auto& [painting, some] : facets)
    {
        const auto first = static_cast<std::uint32_t>(positions->size());
        for (const glm::vec3& position : some.positions)
            positions->push_back(vectorOf(position));
        for (const std::uint32_t index : some.indices)
            indices->push_back(first + index);
    }
    const osg::ref_ptr<osg::Geometry> geometry = geometryAt(positions);
    geometry->addPrimitiveSet(indices);
    geometry->setCullCallback(new DrawnInMapsAlone);
    return geometry;
}

osg::Group& addOverlapping(osg::Group& parent, const glm::dvec3& origin, double farM)
{
    const osg::ref_ptr<RangedGroup> content = new RangedGroup(farM);
    placeAt(parent, origin).addChild(content);
    return *content;
}

osg::Group& addRange(osg::Group& parent, const glm::dvec3& origin, double nearM, double farM)
{
    const osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    const osg::ref_ptr<osg::Group> content = new osg::Group;
    lod->addChild(content, static_cast<float>(nearM), static_cast<float>(farM));
    placeAt(parent, origin).addChild(lod);
    return *content;
}

} // namespace scenery
