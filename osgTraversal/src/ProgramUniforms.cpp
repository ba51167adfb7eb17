// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osg/Uniform>

#include <osgTraversal/ProgramUniforms>

namespace osgTraversal
{

namespace
{

constexpr double kFarthestSteps = 1 << 30;

} // namespace

GLint ProgramUniforms::location(const char* name) const
{
    return _program ? _program->getUniformLocation(osg::Uniform::getNameID(name)) : -1;
}

void ProgramUniforms::set(const char* name, int value) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniform1i(at, value);
}

void ProgramUniforms::set(const char* name, float value) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniform1f(at, value);
}

void ProgramUniforms::set(const char* name, const osg::Vec3i& value) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniform3iv(at, 1, value.ptr());
}

void ProgramUniforms::set(const char* name, const osg::Vec3f& value) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniform3fv(at, 1, value.ptr());
}

void ProgramUniforms::set(const char* name, const osg::Vec4f& value) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniform4fv(at, 1, value.ptr());
}

void ProgramUniforms::setRotation(const char* name, const osg::Matrixd& matrix) const
{
    float columns[9];
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            columns[3 * row + column] = static_cast<float>(matrix(row, column));
    if (const GLint at = location(name); at >= 0) _gl.glUniformMatrix3fv(at, 1, GL_FALSE, columns);
}

void ProgramUniforms::setMatrix3x2(const char* name, const float (&columns)[6]) const
{
    if (const GLint at = location(name); at >= 0) _gl.glUniformMatrix3x2fv(at, 1, GL_FALSE, columns);
}

WholeSteps WholeSteps::of(const osg::Vec3d& placeM, double stepM)
{
    WholeSteps whole;
    for (int i = 0; i < 3; ++i)
    {
        const double steps = std::clamp(std::round(placeM[i] / stepM), -kFarthestSteps, kFarthestSteps);
        whole.steps[i] = static_cast<int>(steps);
        whole.rest[i] = static_cast<float>(placeM[i] - steps * stepM);
    }
    return whole;
}

WrappedPlace WrappedPlace::of(const osg::Vec3d& placeM, double periodM)
{
    WrappedPlace wrapped;
    for (int i = 0; i < 3; ++i)
    {
        const double periods = std::clamp(std::floor(placeM[i] / periodM), -kFarthestSteps, kFarthestSteps);
        wrapped.periods[i] = static_cast<int>(periods);
        wrapped.within[i] = static_cast<float>(placeM[i] - periods * periodM);
    }
    return wrapped;
}

osg::Vec3d eyeInLocal(const osg::State& state)
{
    osg::Matrixd localFromEye;
    localFromEye.invert(state.getModelViewMatrix());
    return localFromEye.getTrans();
}

} // namespace osgTraversal
