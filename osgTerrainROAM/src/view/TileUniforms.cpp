// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>

#include <osgTerrainROAM/TileUniforms>
#include <osgTraversal/ProgramUniforms>

#include "FixedFunction.h"

namespace osgTerrainROAM
{

namespace
{

/// Where the shader's mesh and noise are counted from. Metres; every period of the detail texture divides it.
constexpr double kWrapM = 4096.0;

void setGridMap(const osgTraversal::ProgramUniforms& uniforms, const core::TileFrame::GridMap& map)
{
    float columns[6];
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            columns[2 * j + i] = static_cast<float>(j < 2 ? map.linear[j][i] : map.offset[i]);
    uniforms.setMatrix3x2("terrainGridFromLocal", columns);
}

} // namespace

void setTileUniforms(osg::State& state, const core::TileFrame& frame, double stepM)
{
    const osg::Matrixd& eyeFromLocal = state.getModelViewMatrix();
    const osg::Vec3d eye = osgTraversal::eyeInLocal(state);
    const auto whole = osgTraversal::WholeSteps::of(eye, stepM);
    const auto wrapped = osgTraversal::WrappedPlace::of(eye, kWrapM);

    const osgTraversal::ProgramUniforms uniforms(state);
    uniforms.set("terrainStep", static_cast<float>(stepM));
    uniforms.set("terrainEyeSteps", whole.steps);
    uniforms.set("terrainEyeRest", whole.rest);
    uniforms.set("terrainEyeWrapped", wrapped.within);
    uniforms.set("terrainEyeWraps", wrapped.periods);
    setGridMap(uniforms, frame.gridMap());
    uniforms.setRotation("terrainEyeFromLocal", eyeFromLocal);
    uniforms.setRotation("terrainWorldFromLocal", eyeFromLocal * state.getInitialInverseViewMatrix());
    const int lights = lightsOf(state);
    uniforms.set("terrainLights", lights);
    uniforms.set("terrainLightCount",
                 std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(lights, 0))))));
    uniforms.set("terrainFog", fogOf(state));
}

} // namespace osgTerrainROAM
