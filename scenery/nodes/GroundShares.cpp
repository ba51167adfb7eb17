// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/GroundShares.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <glm/common.hpp>

#include <osg/Texture2D>

#include <osgTerrainROAM/core/cover/GroundMakeup.h>

namespace scenery
{

namespace
{

using osgTerrainROAM::TerrainMaterial;
using Shares = GroundShares::Shares;

/// What grows wild there. Between houses half of it is kept short; crops are painted.
Shares byKind(std::size_t kind)
{
    using osgTerrainROAM::core::GroundKind;
    const auto& of = osgTerrainROAM::core::kGroundMakeup[kind];
    if (kind == static_cast<std::size_t>(GroundKind::crop)) return {};
    for (const GroundKind mown : {GroundKind::urban, GroundKind::garden, GroundKind::yard})
        if (kind == static_cast<std::size_t>(mown)) return {0.5F * of.grass, 0.0F, 0.0F};
    return {of.grass, of.stones, of.litter};
}

/// The rules of GroundColour.glsl.
Shares byLand(float green, float steep)
{
    const float grown = glm::smoothstep(0.22F, 0.42F, green), wood = glm::smoothstep(0.68F, 0.80F, green);
    const float rock = glm::smoothstep(0.22F, 0.34F, steep + 0.16F * (0.35F - green)) * (1.0F - 0.55F * wood);
    const float open = 1.0F - rock;
    return {grown * (1.0F - wood) * open, (0.15F * (1.0F - grown) + 0.1F * rock) * open, wood * open};
}

} // namespace

GroundShares::GroundShares(const osgTerrainROAM::RoamTerrain& terrain)
    : _tile(terrain.tile()),
      _material(terrain.material()),
      _land(mapOf(TerrainMaterial::land, "terrainMapFromGrid")),
      _normals(mapOf(TerrainMaterial::normals, "terrainMapFromGrid")),
      _cover(mapOf(TerrainMaterial::cover, "coverFromGrid")),
      _crops(mapOf(TerrainMaterial::features + 2, nullptr)),
      _beds(mapOf(TerrainMaterial::features + 3, nullptr))
{
}

/// Without a uniform the map is one of the features, by metres: its scale is found from their cells.
GroundShares::Map GroundShares::mapOf(int unit, const char* uniform) const
{
    Map map;
    const osg::StateSet& state = *_material->stateSet();
    const auto* texture = dynamic_cast<const osg::Texture2D*>(
        state.getTextureAttribute(static_cast<unsigned>(unit), osg::StateAttribute::TEXTURE));
    if (!texture) return map;
    if (uniform)
    {
        osg::Vec4f value;
        if (!state.getUniform(uniform) || !state.getUniform(uniform)->get(value)) return map;
        map.fromGrid = {value.x(), value.y(), value.z(), value.w()};
    }
    else
    {
        int column = 0, row = 0, columns = 1, rows = 1;
        float cellM = 1.0F;
        if (!state.getUniform("featureGrid") ||
            !state.getUniform("featureGrid")->get(column, row, columns, rows) ||
            !state.getUniform("featureCellM")->get(cellM))
            return map;
        map.fromGrid = {1.0 / (columns * cellM), 1.0 / (rows * cellM), -column / static_cast<double>(columns),
                        -row / static_cast<double>(rows)};
    }
    map.image = texture->getImage();
    return map;
}

glm::vec4 GroundShares::Map::at(glm::dvec2 grid) const
{
    if (!image) return glm::vec4(0.0F);
    const glm::dvec2 at = grid * glm::dvec2(fromGrid.x, fromGrid.y) + glm::dvec2(fromGrid.z, fromGrid.w);
    const int x = std::clamp(static_cast<int>(std::floor(at.x * image->s())), 0, image->s() - 1);
    const int y = std::clamp(static_cast<int>(std::floor(at.y * image->t())), 0, image->t() - 1);
    const unsigned char* const texel = image->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
    const int channels = static_cast<int>(osg::Image::computeNumComponents(image->getPixelFormat()));
    const bool isWide = image->getDataType() == GL_UNSIGNED_SHORT;
    glm::vec4 values(0.0F);
    for (int i = 0; i < std::min(channels, 4); ++i)
    {
        std::uint16_t wide = 0;
        if (isWide) std::memcpy(&wide, texel + 2 * i, sizeof wide);
        values[i] = isWide ? static_cast<float>(wide) / 65535.0F : static_cast<float>(texel[i]) / 255.0F;
    }
    return values;
}

Shares GroundShares::at(glm::dvec2 place) const
{
    const glm::dvec2 grid = _tile->tile.frame().gridNear(place);
    const glm::vec4 land = _land.at(grid), crops = _crops.at(place), beds = _beds.at(place);
    constexpr float kSome = 0.02F, kSnow = 0.35F, kWater = 0.4F;
    if (land.g > kSnow || land.b > kWater) return {};
    if (std::max({beds.x, beds.y, beds.z, beds.w, crops.x + crops.y + crops.z + crops.w}) > kSome) return {};
    const auto kind = static_cast<std::size_t>(std::lround(255.0F * _cover.at(grid).r));
    if (kind > 0 && kind < osgTerrainROAM::core::kGroundMakeup.size()) return byKind(kind);
    const glm::vec4 normal = _normals.at(grid) * 2.0F - 1.0F;
    const float flat2 = 1.0F - normal.x * normal.x - normal.y * normal.y;
    return byLand(land.r, 1.0F - std::sqrt(std::max(flat2, 0.0F)));
}

} // namespace scenery
