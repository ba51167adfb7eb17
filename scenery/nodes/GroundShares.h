// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <osgTerrainROAM/RoamTerrain>

namespace scenery
{

/// What the ground of a terrain is made of at a place, as far as it decides what grows there: by the maps and
/// rules of its shaders (GroundColour.glsl, LandCover.glsl, GroundDetail.glsl), without their grain. Where a
/// map shows water, snow, road, runway or field there is none.
/// Frame: the terrain's. Threads: any, while the material is not changed.
class GroundShares
{
public:
    /// `terrain`: with a material, which it keeps.
    explicit GroundShares(const osgTerrainROAM::RoamTerrain& terrain);

    struct Shares
    {
        float grass = 0.0F, stones = 0.0F, litter = 0.0F;
    };
    Shares at(glm::dvec2 place) const;

private:
    /// A texture and how grid coordinates lead into it, 0 … 1.
    struct Map
    {
        osg::ref_ptr<const osg::Image> image;
        glm::dvec4 fromGrid{0.0}; ///< scale, offset

        /// The texel at a place, channels 0 … 1; outside of the map that at its border.
        glm::vec4 at(glm::dvec2 grid) const;
    };

    Map mapOf(int unit, const char* uniform) const;

    std::shared_ptr<const osgTerrainROAM::core::RoamTile> _tile;
    osg::ref_ptr<const osgTerrainROAM::TerrainMaterial> _material;
    Map _land, _normals, _cover, _crops, _beds;
};

} // namespace scenery
