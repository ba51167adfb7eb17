// SPDX-License-Identifier: Apache-2.0
#include "MorphTargets.h"

#include <osgPMObjects/core/mesh/Wedge.h>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

/// By wedge: what it is on the first rung without it.
std::vector<std::uint32_t> targetWedges(const core::ProgressiveMesh& progressive,
                                        const core::LevelLadder& ladder)
{
    std::vector<std::uint32_t> target(progressive.mesh.wedgeCount());
    std::size_t rung = ladder.rungs.size() - 1;
    for (std::uint32_t wedge = 0; wedge < target.size(); ++wedge)
    {
        // From the coarsest rung on, finer ones have more of them.
        while (rung > 0 && wedge >= ladder.rungs[rung].wedges)
            --rung;
        const std::uint32_t left = rung + 1 < ladder.rungs.size() ? ladder.rungs[rung + 1].wedges : wedge + 1;
        target[wedge] = wedge;
        while (target[wedge] >= left && progressive.parents[target[wedge]] < target[wedge])
            target[wedge] = progressive.parents[target[wedge]];
    }
    return target;
}

template<class Array>
osg::ref_ptr<Array> arrayOf(std::size_t size, osg::VertexBufferObject* buffer)
{
    osg::ref_ptr<Array> array = new Array(osg::Array::BIND_PER_VERTEX, static_cast<unsigned>(size));
    array->setVertexBufferObject(buffer);
    return array;
}

} // namespace

MorphTargets::MorphTargets(const ProgressiveShape& shape, const core::LevelLadder& ladder)
{
    const core::Mesh& mesh = shape.progressive().mesh;
    const std::vector<std::uint32_t> targets = targetWedges(shape.progressive(), ladder);
    const osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    _positions = arrayOf<osg::Vec3Array>(targets.size(), buffer);
    if (!mesh.normals.empty()) _normals = arrayOf<osg::Vec3Array>(targets.size(), buffer);
    if (!mesh.colours.empty()) _colours = arrayOf<osg::Vec4Array>(targets.size(), buffer);
    _texCoords = arrayOf<osg::Vec4Array>(targets.size(), buffer);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
        const core::Wedge wedge = core::wedgeOf(mesh, targets[i]);
        (*_positions)[i] = shape.vertices()[targets[i]];
        if (_normals) (*_normals)[i] = {wedge.normal.x, wedge.normal.y, wedge.normal.z};
        if (_colours) (*_colours)[i] = {wedge.colour.r, wedge.colour.g, wedge.colour.b, wedge.colour.a};
        (*_texCoords)[i] = {wedge.texCoords[0].x, wedge.texCoords[0].y, wedge.texCoords[1].x,
                            wedge.texCoords[1].y};
    }
}

osg::ref_ptr<osg::Geometry> MorphTargets::geometryOf(const osg::Geometry& arrays) const
{
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(arrays, osg::CopyOp::SHALLOW_COPY);
    geometry->setVertexAttribArray(kTargetPositionAttribute, _positions);
    if (_normals && arrays.getNormalArray()) geometry->setVertexAttribArray(kTargetNormalAttribute, _normals);
    const osg::Array* const colours = arrays.getColorArray();
    const bool isByVertex = colours && colours->getBinding() == osg::Array::BIND_PER_VERTEX;
    const osg::Vec4 none(-1.0F, 0.0F, 0.0F, 0.0F); // what all vertices have, or the state, moves nowhere
    geometry->setVertexAttribArray(kTargetColourAttribute,
                                   isByVertex ? _colours.get()
                                              : new osg::Vec4Array(osg::Array::BIND_OVERALL, 1, &none));
    geometry->setVertexAttribArray(kTargetTexCoordsAttribute, _texCoords);
    return geometry;
}

} // namespace osgPMObjects
