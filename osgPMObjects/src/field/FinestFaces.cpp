// SPDX-License-Identifier: Apache-2.0
#include "FinestFaces.h"

#include <osg/KdTree>
#include <osgDB/Registry>

namespace osgPMObjects
{

namespace
{

osg::ref_ptr<osg::Geometry> facesOf(const ProgressiveShape::Group& group, const core::LevelLadder& ladder,
                                    const core::SlotRange& range)
{
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(*group.arrays, osg::CopyOp::SHALLOW_COPY);
    geometry->setStateSet(group.state);
    const osg::ref_ptr<osg::DrawElementsUInt> faces = new osg::DrawElementsUInt(GL_TRIANGLES);
    faces->reserve(std::size_t{range.count} * 3);
    for (std::uint32_t face = range.first; face < range.first + range.count; ++face)
        for (const std::uint32_t wedge : ladder.faces[face])
            faces->push_back(wedge);
    geometry->addPrimitiveSet(faces);
    if (osgDB::Registry::instance()->getBuildKdTreesHint() == osgDB::Options::BUILD_KDTREES)
    {
        const osg::ref_ptr<osg::KdTree> tree = new osg::KdTree;
        osg::KdTree::BuildOptions options;
        if (tree->build(options, geometry)) geometry->setShape(tree);
    }
    geometry->getBound(); // made at first sight, which several threads may have at once
    return geometry;
}

} // namespace

std::vector<osg::ref_ptr<osg::Geometry>> finestFaces(const ProgressiveShape& shape,
                                                     const core::LevelLadder& ladder)
{
    std::vector<osg::ref_ptr<osg::Geometry>> all;
    for (std::uint32_t group = 0; group < shape.groups().size(); ++group)
        if (const core::SlotRange range = ladder.facesOf(0, group); range.count > 0)
            all.push_back(facesOf(shape.groups()[group], ladder, range));
    return all;
}

} // namespace osgPMObjects
