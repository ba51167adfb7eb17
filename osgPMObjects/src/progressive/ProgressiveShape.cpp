// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgPMObjects/core/progressive/LevelMesh.h>

#include <osgPMObjects/ObjectShader>
#include <osgPMObjects/ProgressiveShape>

#include "../export/DrawnState.h"
#include "../export/FloatOrigin.h"
#include "ShapeArrays.h"
#include "ShapeJumps.h"

namespace osgPMObjects
{

namespace
{

/// Makes a state with the program, and with a white texture if `state` has no texture.
osg::ref_ptr<osg::StateSet> shadingFor(osg::StateSet* state, osg::Program* program)
{
    constexpr auto kTexture = osg::StateAttribute::TEXTURE;
    if (state && state->getAttribute(osg::StateAttribute::PROGRAM)) return nullptr;
    osg::ref_ptr<osg::StateSet> shading = new osg::StateSet;
    osg::StateAttribute* const texture = state ? state->getTextureAttribute(0, kTexture) : nullptr;
    if (texture) shading->setTextureAttribute(0, texture);
    addObjectShading(*shading);
    shading->setAttributeAndModes(program);                   // one for all groups
    if (texture) shading->removeTextureAttribute(0, texture); // that of `state` stands above
    return shading;
}

} // namespace

ProgressiveShape::ProgressiveShape()
{
    _levels.faces.push_back(0);
    _levels.errors.emplace_back();
}

ProgressiveShape::ProgressiveShape(core::ProgressiveMesh progressive,
                                   std::vector<osg::ref_ptr<osg::StateSet>> states)
{
    make(std::move(progressive), std::move(states));
}

ProgressiveShape::ProgressiveShape(const ProgressiveShape& other, const osg::CopyOp& copyOp)
    : osg::Object(other, copyOp),
      _progressive(other._progressive),
      _states(other._states),
      _levels(other._levels),
      _facing(other._facing),
      _fieldLevels(other._fieldLevels),
      _origin(other._origin),
      _vertices(other._vertices),
      _groups(other._groups),
      _box(other._box),
      _sphere(other._sphere),
      _jumps(ShapeJumps::of(_progressive))
{
}

void ProgressiveShape::make(core::ProgressiveMesh progressive,
                            std::vector<osg::ref_ptr<osg::StateSet>> states)
{
    _progressive = std::move(progressive);
    _states = std::move(states);
    _levels = core::LevelTable::of(_progressive);
    _facing = core::facingBinsOf(core::meshAfter(_progressive, 0));
    _fieldLevels = nullptr;
    const glm::dvec3 origin = floatOrigin(_progressive.mesh.positions);
    _origin.set(origin.x, origin.y, origin.z);
    const ShapeArrays arrays(_progressive, origin);
    const std::vector<std::vector<bool>> isUsedBy = wedgesByGroup(_progressive);
    _vertices = arrays.vertices();
    const osg::ref_ptr<osg::Program> program = makeObjectProgram();
    for (std::uint32_t group = 0; group < _progressive.groups.size(); ++group)
    {
        const std::uint32_t number = _progressive.groups[group].material;
        const core::Material& material = _progressive.mesh.materials[number];
        const std::vector<bool>& isUsed = isUsedBy[group];
        Group made{number, drawnState(material, _states), arrays.geometryOf(material, isUsed), {}, {}};
        made.shading = shadingFor(made.state, program);
        for (std::size_t wedge = 0; wedge < isUsed.size(); ++wedge)
            if (isUsed[wedge]) made.box.expandBy((*_vertices)[wedge]);
        _groups.push_back(std::move(made));
    }
    measure();
    _jumps = ShapeJumps::of(_progressive);
}

void ProgressiveShape::measure()
{
    for (const osg::Vec3& vertex : *_vertices)
        _box.expandBy(vertex);
    if (!_box.valid()) return;
    const osg::Vec3d centre = _box.center();
    double radius2 = 0.0;
    for (const osg::Vec3& vertex : *_vertices)
        radius2 = std::max(radius2, (osg::Vec3d(vertex) - centre).length2());
    _sphere = {{centre.x(), centre.y(), centre.z()}, std::sqrt(radius2)};
}

void ProgressiveShape::resizeGLObjectBuffers(unsigned int contexts) const
{
    for (const Group& group : _groups)
    {
        group.arrays->resizeGLObjectBuffers(contexts);
        if (group.state) group.state->resizeGLObjectBuffers(contexts);
        if (group.shading) group.shading->resizeGLObjectBuffers(contexts);
    }
}

void ProgressiveShape::releaseGLObjects(osg::State* state) const
{
    for (const Group& group : _groups)
    {
        group.arrays->releaseGLObjects(state);
        // OSG does not set an array again that it set last, though its buffer has changed.
        osg::Geometry::ArrayList arrays;
        group.arrays->getArrayList(arrays);
        for (const auto& array : arrays)
            array->dirty();
        if (group.state) group.state->releaseGLObjects(state);
        if (group.shading) group.shading->releaseGLObjects(state);
    }
}

} // namespace osgPMObjects
