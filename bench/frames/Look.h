// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <osg/Program>
#include <osg/StateSet>

#include <osgTerrainROAM/TerrainMaterial>

namespace framebench
{

/// The appearance of the ground. Every one shades with maps of the full resolution, so that levels of detail
/// differ in their triangles only.
enum class Look
{
    full,     ///< TerrainMaterial as it is
    relief,   ///< one grey albedo, the material's normal map and haze: no land cover, no grain
    distance, ///< the distance from the camera, for finding silhouettes (Picture.h)
};

constexpr std::string_view lookName(Look look)
{
    constexpr std::string_view kNames[] = {"full", "relief", "distance"};
    return kNames[static_cast<int>(look)];
}

/// Returns the StateSet of the material with the program of a look.
osg::ref_ptr<osg::StateSet> lookState(const osgTerrainROAM::TerrainMaterial& material, Look look);

/// Returns the program of a look for geometry without grid coordinates, whose gl_Vertex is in a shifted
/// frame, as that of osgTerrain: the same fragment shader after another vertex shader, which computes grid
/// coordinates with the uniform `benchSpacing`. It reads the uniforms of EyeUniforms.
osg::ref_ptr<osg::Program> plainVertexProgram(const osgTerrainROAM::TerrainMaterial& material, Look look);

} // namespace framebench
