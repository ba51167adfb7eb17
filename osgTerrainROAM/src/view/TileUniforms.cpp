// SPDX-License-Identifier: Apache-2.0
#include "TileUniforms.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <osg/Program>
#include <osg/Uniform>
#include <osg/Vec3f>
#include <osg/Vec3i>

#include "FixedFunction.h"

namespace osgTerrainROAM
{

namespace
{

/// Where the shader's mesh and noise are counted from. Metres; every period of the detail texture divides it.
constexpr double kWrapM = 4096.0;

/// The eye as vertices are counted, and what is left of it.
struct EyeUniforms
{
    osg::Vec3i steps;
    osg::Vec3f rest, wrapped;
    osg::Vec3i wraps; ///< whole kWrapM below `wrapped`
};

EyeUniforms eyeUniforms(const osg::Vec3d& eye, double stepM)
{
    // Vertices have 31 bits; an eye farther out than they can be is as far as they, and the rest need not be exact.
    constexpr double kFarthest = 1 << 30;
    EyeUniforms uniforms;
    for (int i = 0; i < 3; ++i)
    {
        const double steps = std::clamp(std::round(eye[i] / stepM), -kFarthest, kFarthest);
        uniforms.steps[i] = static_cast<int>(steps);
        uniforms.rest[i] = static_cast<float>(eye[i] - steps * stepM);
        const double wraps = std::clamp(std::floor(eye[i] / kWrapM), -kFarthest, kFarthest);
        uniforms.wraps[i] = static_cast<int>(wraps);
        uniforms.wrapped[i] = static_cast<float>(eye[i] - kWrapM * wraps);
    }
    return uniforms;
}

/// Sets a uniform of the program in use; nothing when it has none of that name (a depth pass, say).
class ProgramUniforms
{
public:
    explicit ProgramUniforms(osg::State& state)
        : _gl(*state.get<osg::GLExtensions>()), _program(state.getLastAppliedProgramObject())
    {
    }

    void set(const char* name, const osg::Vec3f& value) const
    {
        if (const GLint at = location(name); at >= 0) _gl.glUniform3fv(at, 1, value.ptr());
    }

    void set(const char* name, const osg::Vec3i& value) const
    {
        if (const GLint at = location(name); at >= 0) _gl.glUniform3iv(at, 1, value.ptr());
    }

    void set(const char* name, const osg::Vec4f& value) const
    {
        if (const GLint at = location(name); at >= 0) _gl.glUniform4fv(at, 1, value.ptr());
    }

    void set(const char* name, int value) const
    {
        if (const GLint at = location(name); at >= 0) _gl.glUniform1i(at, value);
    }

    void set(const char* name, float value) const
    {
        if (const GLint at = location(name); at >= 0) _gl.glUniform1f(at, value);
    }

    void setGridMap(const core::TileFrame::GridMap& map) const
    {
        float columns[6];
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 3; ++j)
                columns[2 * j + i] = static_cast<float>(j < 2 ? map.linear[j][i] : map.offset[i]);
        if (const GLint at = location("terrainGridFromLocal"); at >= 0)
            _gl.glUniformMatrix3x2fv(at, 1, GL_FALSE, columns);
    }

    /// The rotation of `matrix`, for column vectors.
    void setRotation(const char* name, const osg::Matrixd& matrix) const
    {
        float columns[9];
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                columns[3 * row + column] = static_cast<float>(matrix(row, column));
        if (const GLint at = location(name); at >= 0) _gl.glUniformMatrix3fv(at, 1, GL_FALSE, columns);
    }

private:
    GLint location(const char* name) const
    {
        return _program ? _program->getUniformLocation(osg::Uniform::getNameID(name)) : -1;
    }

    osg::GLExtensions& _gl;
    const osg::Program::PerContextProgram* _program;
};

} // namespace

void setTileUniforms(osg::State& state, const core::TileFrame& frame, double stepM)
{
    const osg::Matrixd& eyeFromLocal = state.getModelViewMatrix();
    osg::Matrixd localFromEye;
    localFromEye.invert(eyeFromLocal);
    const EyeUniforms eye = eyeUniforms(localFromEye.getTrans(), stepM);

    const ProgramUniforms uniforms(state);
    uniforms.set("terrainStep", static_cast<float>(stepM));
    uniforms.set("terrainEyeSteps", eye.steps);
    uniforms.set("terrainEyeRest", eye.rest);
    uniforms.set("terrainEyeWrapped", eye.wrapped);
    uniforms.setGridMap(frame.gridMap());
    uniforms.set("terrainEyeWraps", eye.wraps);
    uniforms.setRotation("terrainEyeFromLocal", eyeFromLocal);
    uniforms.setRotation("terrainWorldFromLocal", eyeFromLocal * state.getInitialInverseViewMatrix());
    const int lights = lightsOf(state);
    uniforms.set("terrainLights", lights);
    uniforms.set("terrainLightCount",
                 std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(lights, 0))))));
    uniforms.set("terrainFog", fogOf(state));
}

} // namespace osgTerrainROAM
