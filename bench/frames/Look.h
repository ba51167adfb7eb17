// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <osg/Program>
#include <osg/StateSet>

#include <osgTerrainROAM/TerrainMaterial>

namespace framebench
{

/// What the ground looks like. All of them shade with maps of the full resolution, so that nothing but the triangles
/// differs between the levels of detail.
enum class Look
{
    full,     ///< TerrainMaterial as it is
    relief,   ///< one grey albedo, the material's normal map and haze: no land cover, no grain
    distance, ///< no picture to look at: the eye's distance, for finding silhouettes (Silhouettes.h)
};

constexpr std::string_view lookName(Look look)
{
    constexpr std::string_view kNames[] = {"full", "relief", "distance"};
    return kNames[static_cast<int>(look)];
}

/// The material's StateSet with the program of a look.
osg::ref_ptr<osg::StateSet> lookState(const osgTerrainROAM::TerrainMaterial& material, Look look);

/// The program of a look for geometry that brings gl_Vertex in a moved frame and no grid places, as osgTerrain's does:
/// the same fragment shader behind another vertex shader, which takes the grid's place from the uniform
/// `benchSpacing`. It reads the uniforms of EyeUniforms.
osg::ref_ptr<osg::Program> plainVertexProgram(const osgTerrainROAM::TerrainMaterial& material, Look look);

} // namespace framebench
