// SPDX-License-Identifier: Apache-2.0
#include "RoadPart.h"

#include <algorithm>
#include <cmath>

#include <osg/Program>
#include <osg/Uniform>
#include <osg/Vec4f>

namespace osgRoads
{

namespace
{

/// Where the grain's coordinates are counted from, metres; every period of the grain divides it.
constexpr double kWrapM = 1024.0;

/// The location of a uniform in the program in use; below 0: it has none of that name.
GLint locationOf(const osg::State& state, const char* name)
{
    const osg::Program::PerContextProgram* program = state.getLastAppliedProgramObject();
    return program ? program->getUniformLocation(osg::Uniform::getNameID(name)) : -1;
}

void setRotation(osg::State& state, const char* name, const osg::Matrixd& matrix)
{
    float columns[9];
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            columns[3 * row + column] = static_cast<float>(matrix(row, column));
    const GLint at = locationOf(state, name);
    if (at >= 0) state.get<osg::GLExtensions>()->glUniformMatrix3fv(at, 1, GL_FALSE, columns);
}

} // namespace

RoadPart::RoadPart(std::shared_ptr<RoadBuffers> buffers, const std::vector<core::ChunkChoice>& choices,
                   const core::RoadViewSettings& settings, double pixelsPerTangent,
                   const osg::BoundingBox& bounds)
    : _buffers(std::move(buffers)), _settings(settings), _pixelsPerTangent(pixelsPerTangent), _bounds(bounds)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setUseVertexArrayObject(false);
    setDataVariance(osg::Object::STATIC);
    for (const core::ChunkChoice& choice : choices)
    {
        const core::ChunkLevel& level = _buffers->mesh().chunks[choice.chunk].levels[choice.level];
        _ranges.push_back({level.firstIndex, level.indexCount});
    }
}

void RoadPart::setUniforms(osg::State& state) const
{
    const osg::Matrixd& eyeFromLocal = state.getModelViewMatrix();
    osg::Matrixd localFromEye;
    localFromEye.invert(eyeFromLocal);
    const osg::Vec3d eye = localFromEye.getTrans();
    const double stepM = core::RoadMesh::kMeshStepM;
    GLint steps[3];
    GLfloat rest[3], wrapped[3];
    for (int i = 0; i < 3; ++i)
    {
        const double away = eye[i] - _buffers->mesh().origin[i];
        const double whole = std::clamp(std::round(away / stepM), -2e9, 2e9);
        steps[i] = static_cast<GLint>(whole);
        rest[i] = static_cast<GLfloat>(away - whole * stepM);
        wrapped[i] = static_cast<GLfloat>(eye[i] - kWrapM * std::floor(eye[i] / kWrapM));
    }
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    if (const GLint at = locationOf(state, "roadEyeSteps"); at >= 0) gl.glUniform3iv(at, 1, steps);
    if (const GLint at = locationOf(state, "roadEyeRest"); at >= 0) gl.glUniform3fv(at, 1, rest);
    if (const GLint at = locationOf(state, "roadEyeWrapped"); at >= 0) gl.glUniform3fv(at, 1, wrapped);
    const osg::Vec4f lift(static_cast<float>(_settings.liftPx / _pixelsPerTangent),
                          static_cast<float>(_settings.liftFromM), static_cast<float>(_settings.liftFullM),
                          static_cast<float>(_settings.farthestM));
    if (const GLint at = locationOf(state, "roadLift"); at >= 0) gl.glUniform4fv(at, 1, lift.ptr());
    setRotation(state, "roadEyeFromLocal", eyeFromLocal);
    setRotation(state, "roadWorldFromLocal", eyeFromLocal * state.getInitialInverseViewMatrix());
}

void RoadPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    setUniforms(state);
    _buffers->draw(state, _ranges);
}

void RoadPart::accept(osg::PrimitiveFunctor& functor) const
{
    showTriangles(_buffers->mesh(), _ranges, functor);
}

void showTriangles(const core::RoadMesh& mesh, const std::vector<RoadRange>& ranges,
                   osg::PrimitiveFunctor& functor)
{
    std::vector<osg::Vec3d> places;
    for (const RoadRange& range : ranges)
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
        {
            const glm::dvec3 place = mesh.placeOf(mesh.vertices[mesh.indices[i]]);
            places.emplace_back(place.x, place.y, place.z);
        }
    if (places.empty()) return;
    functor.setVertexArray(static_cast<unsigned int>(places.size()), places.data());
    functor.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(places.size()));
}

} // namespace osgRoads
