// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>

#include <osgPMObjects/core/field/LevelLadder.h>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// Where each vertex of a shape lies, and how it looks, on the first rung that does not have it any more:
/// there it has become another vertex, by the table of parents. One target a vertex does for all rungs, as it
/// vanishes once.
/// Memory: 12 to 56 B a vertex, by the attributes that there are.
class LadderTargets
{
public:
    LadderTargets(const ProgressiveShape& shape, const core::LevelLadder& ladder);

    /// A material's arrays, with those of the targets (ObjectAttribute). Shares all arrays.
    osg::ref_ptr<osg::Geometry> geometryOf(const osg::Geometry& arrays) const;

private:
    osg::ref_ptr<osg::Vec3Array> _positions, _normals;
    osg::ref_ptr<osg::Vec4Array> _colours, _texCoords;
};

} // namespace osgPMObjects
