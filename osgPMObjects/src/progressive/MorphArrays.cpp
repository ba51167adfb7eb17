// SPDX-License-Identifier: Apache-2.0
#include "MorphArrays.h"

#include <osg/VertexArrayState>

#include <osgPMObjects/core/progressive/MorphTargets.h>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

using core::MorphTargets;

/// Makes an array with a value for each vertex of the finer level; values of vertices that do not move are
/// never read.
template<class Array>
osg::ref_ptr<Array> arrayOf(const MorphTargets& targets, osg::VertexBufferObject* buffer)
{
    const osg::ref_ptr<Array> array = new Array(
        osg::Array::BIND_PER_VERTEX, static_cast<unsigned>(targets.firstWedge + targets.targets.size()));
    array->setVertexBufferObject(buffer);
    return array;
}

/// Returns the values of the shape by vertex; null: there are none, or one for all vertices.
template<class Array>
const Array* perVertex(const osg::Array* array)
{
    return array && array->getBinding() == osg::Array::BIND_PER_VERTEX ? dynamic_cast<const Array*>(array)
                                                                       : nullptr;
}

/// Makes the values of one attribute, read from the target of each vertex.
template<class Array>
class Attribute
{
public:
    Attribute(const MorphTargets& targets, std::uint32_t MorphTargets::Target::*which,
              osg::VertexBufferObject* buffer)
        : _targets(targets), _which(which), _buffer(buffer)
    {
    }

    /// One array for all groups whose vertices share one.
    osg::ref_ptr<Array> of(const Array* source)
    {
        if (!source) return nullptr;
        if (_made) return _made;
        _made = arrayOf<Array>(_targets, _buffer);
        for (std::size_t i = 0; i < _targets.targets.size(); ++i)
            (*_made)[_targets.firstWedge + i] = (*source)[_targets.targets[i].*_which];
        return _made;
    }

private:
    const MorphTargets& _targets;
    std::uint32_t MorphTargets::Target::*_which;
    osg::VertexBufferObject* _buffer;
    osg::ref_ptr<Array> _made;
};

/// Makes one attribute of both sets.
osg::ref_ptr<osg::Vec4Array> texCoordsOf(const MorphTargets& targets, const osg::Geometry& source,
                                         osg::VertexBufferObject* buffer)
{
    const auto* const first = perVertex<osg::Vec2Array>(source.getTexCoordArray(0));
    const auto* const second = perVertex<osg::Vec2Array>(source.getTexCoordArray(1));
    if (!first && !second) return nullptr;
    osg::ref_ptr<osg::Vec4Array> both = arrayOf<osg::Vec4Array>(targets, buffer);
    for (std::size_t i = 0; i < targets.targets.size(); ++i)
    {
        const std::uint32_t wedge = targets.targets[i].attributeWedge;
        const osg::Vec2 a = first ? (*first)[wedge] : osg::Vec2(),
                        b = second ? (*second)[wedge] : osg::Vec2();
        (*both)[targets.firstWedge + i].set(a.x(), a.y(), b.x(), b.y());
    }
    return both;
}

/// Sets the value of an attribute without an array by vertex. The shader knows it by a normal of 0 or a red
/// below 0, and moves nothing.
void hold(osg::State& state, unsigned int attribute, GLfloat first)
{
    const GLfloat value[4] = {first, 0.0F, 0.0F, 0.0F};
    state.get<osg::GLExtensions>()->glVertexAttrib4fv(attribute, value);
}

} // namespace

MorphArrays::MorphArrays(const ProgressiveShape& shape, std::uint32_t finerSteps, std::uint32_t coarserSteps)
    : _finer(finerSteps), _coarser(coarserSteps)
{
    const MorphTargets targets = core::morphTargets(shape.progressive(), finerSteps, coarserSteps);
    _firstVertex = targets.firstWedge;
    const osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    Attribute<osg::Vec3Array> positions(targets, &MorphTargets::Target::positionWedge, buffer);
    Attribute<osg::Vec3Array> normals(targets, &MorphTargets::Target::attributeWedge, buffer);
    Attribute<osg::Vec4Array> colours(targets, &MorphTargets::Target::attributeWedge, buffer);
    for (const ProgressiveShape::Group& group : shape.groups())
    {
        const osg::Geometry& source = *group.arrays;
        const osg::ref_ptr<osg::Geometry> arrays = new osg::Geometry(source);
        arrays->setVertexAttribArray(kTargetPositionAttribute, positions.of(&shape.vertices()));
        arrays->setVertexAttribArray(kTargetNormalAttribute,
                                     normals.of(perVertex<osg::Vec3Array>(source.getNormalArray())));
        arrays->setVertexAttribArray(kTargetColourAttribute,
                                     colours.of(perVertex<osg::Vec4Array>(source.getColorArray())));
        arrays->setVertexAttribArray(kTargetTexCoordsAttribute, texCoordsOf(targets, source, buffer));
        _groups.push_back(arrays);
    }
}

void MorphArrays::set(osg::RenderInfo& renderInfo, std::uint32_t group) const
{
    const osg::Geometry& arrays = *_groups[group];
    arrays.drawVertexArraysImplementation(renderInfo);
    osg::State& state = *renderInfo.getState();
    if (!arrays.getVertexAttribArray(kTargetNormalAttribute)) hold(state, kTargetNormalAttribute, 0.0F);
    if (!arrays.getVertexAttribArray(kTargetColourAttribute)) hold(state, kTargetColourAttribute, -1.0F);
}

/// Disables the arrays through OSG, which knows arrays by their address: the next morph's may have the same.
void MorphArrays::unset(osg::State& state)
{
    for (const unsigned attribute : {kTargetPositionAttribute, kTargetNormalAttribute, kTargetColourAttribute,
                                     kTargetTexCoordsAttribute})
        state.getCurrentVertexArrayState()->disableVertexAttribArray(state, attribute);
}

} // namespace osgPMObjects
