// SPDX-License-Identifier: Apache-2.0
#include "LadderTargets.h"

#include <algorithm>

#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/progressive/MorphTargets.h>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

/// By wedge: where it is on the first rung without it. Those of the coarsest rung stay.
std::vector<core::MorphTargets::Target> targetsOf(const core::ProgressiveMesh& progressive,
                                                  const core::LevelLadder& ladder)
{
    std::vector<core::MorphTargets::Target> targets(progressive.mesh.wedgeCount());
    for (std::uint32_t wedge = 0; wedge < targets.size(); ++wedge)
        targets[wedge] = {wedge, wedge};
    for (std::size_t rung = 0; rung + 1 < ladder.rungs.size(); ++rung)
    {
        const auto ofRung = core::morphTargets(progressive, ladder.steps[rung], ladder.steps[rung + 1]);
        std::copy(ofRung.targets.begin(), ofRung.targets.end(), targets.begin() + ofRung.firstWedge);
    }
    return targets;
}

template<class Array>
osg::ref_ptr<Array> arrayOf(std::size_t size, osg::VertexBufferObject* buffer)
{
    osg::ref_ptr<Array> array = new Array(osg::Array::BIND_PER_VERTEX, static_cast<unsigned>(size));
    array->setVertexBufferObject(buffer);
    return array;
}

} // namespace

LadderTargets::LadderTargets(const ProgressiveShape& shape, const core::LevelLadder& ladder)
{
    const core::Mesh& mesh = shape.progressive().mesh;
    const auto targets = targetsOf(shape.progressive(), ladder);
    const osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    _positions = arrayOf<osg::Vec3Array>(targets.size(), buffer);
    if (!mesh.normals.empty()) _normals = arrayOf<osg::Vec3Array>(targets.size(), buffer);
    if (!mesh.colours.empty()) _colours = arrayOf<osg::Vec4Array>(targets.size(), buffer);
    _texCoords = arrayOf<osg::Vec4Array>(targets.size(), buffer);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
        const core::Wedge wedge = core::wedgeOf(mesh, targets[i].attributeWedge);
        (*_positions)[i] = shape.vertices()[targets[i].positionWedge];
        if (_normals) (*_normals)[i] = {wedge.normal.x, wedge.normal.y, wedge.normal.z};
        if (_colours) (*_colours)[i] = {wedge.colour.r, wedge.colour.g, wedge.colour.b, wedge.colour.a};
        (*_texCoords)[i] = {wedge.texCoords[0].x, wedge.texCoords[0].y, wedge.texCoords[1].x,
                            wedge.texCoords[1].y};
    }
}

osg::ref_ptr<osg::Geometry> LadderTargets::geometryOf(const osg::Geometry& arrays) const
{
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(arrays, osg::CopyOp::SHALLOW_COPY);
    geometry->setVertexAttribArray(kTargetPositionAttribute, _positions);
    // What all vertices have, or the state, or nobody, moves nowhere: the shader's functions know it by a
    // normal of 0 and a red below 0.
    const auto isByVertex = [](const osg::Array* array)
    { return array && array->getBinding() == osg::Array::BIND_PER_VERTEX; };
    const osg::Vec3 noNormal;
    const osg::Vec4 noColour(-1.0F, 0.0F, 0.0F, 0.0F);
    geometry->setVertexAttribArray(kTargetNormalAttribute,
                                   _normals && isByVertex(arrays.getNormalArray())
                                       ? _normals.get()
                                       : new osg::Vec3Array(osg::Array::BIND_OVERALL, 1, &noNormal));
    geometry->setVertexAttribArray(kTargetColourAttribute,
                                   _colours && isByVertex(arrays.getColorArray())
                                       ? _colours.get()
                                       : new osg::Vec4Array(osg::Array::BIND_OVERALL, 1, &noColour));
    geometry->setVertexAttribArray(kTargetTexCoordsAttribute, _texCoords);
    return geometry;
}

} // namespace osgPMObjects
