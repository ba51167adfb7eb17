// SPDX-License-Identifier: Apache-2.0
#include "SheetNormals.h"

#include <algorithm>
#include <cmath>

#include <osg/Uniform>

#include "MapTexture.h"
#include "NormalMap.h"

namespace osgTerrainROAM
{

SheetNormals::SheetNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned firstUnit)
{
    const auto& sheets = tile.samples().sheets();
    const std::size_t count = std::min(sheets.size(), kMostMaps);
    const auto array = [&](const char* name)
    {
        return stateSet.getOrCreateUniform(name, osg::Uniform::FLOAT_VEC4,
                                           static_cast<unsigned>(std::max<std::size_t>(count, 1)));
    };
    osg::Uniform *fromGrid = array("sheetFromGrid"), *rects = array("sheetRect"),
                 *bumpiness = array("sheetBumpiness");
    for (std::size_t i = 0; i < count; ++i)
    {
        const core::SampleSheet& sheet = sheets[sheets.size() - count + i];
        const auto n = static_cast<unsigned>(i);
        _maps.push_back({MapGrid(sheet), nullptr});
        Map& map = _maps.back();
        map.image = normalMap(tile, map.grid);
        stateSet.setTextureAttribute(firstUnit + n, mapTexture(map.image, osg::Texture::CLAMP_TO_EDGE));
        stateSet.addUniform(
            new osg::Uniform(("sheetNormals" + std::to_string(i)).c_str(), static_cast<int>(firstUnit + n)));
        const auto perTexel = static_cast<float>(map.grid.step);
        const auto width = static_cast<float>(map.grid.width), height = static_cast<float>(map.grid.height);
        const core::GridRect& r = sheet.rect();
        fromGrid->setElement(n, osg::Vec4f(1.0f / (perTexel * width), 1.0f / (perTexel * height),
                                           (0.5f - static_cast<float>(r.west) / perTexel) / width,
                                           (0.5f - static_cast<float>(r.south) / perTexel) / height));
        rects->setElement(n, osg::Vec4f(static_cast<float>(r.west), static_cast<float>(r.south),
                                        static_cast<float>(r.east), static_cast<float>(r.north)));
        bumpiness->setElement(n, bumpinessOver(map.grid.spacingM(tile)));
    }
    stateSet.addUniform(new osg::Uniform("sheetCell", std::ldexp(1.0f, tile.grid().exponent())));
}

void SheetNormals::follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved)
{
    for (const Map& map : _maps)
        updateNormals(*map.image, tile, map.grid, moved);
}

osg::Vec4f bumpinessOver(double spacingM)
{
    // A layer counts where its features, an eighth of its period wide, are narrower than two samples.
    const auto finer = [=](double periodM)
    { return static_cast<float>(std::clamp((2.0 * spacingM - periodM / 8.0) / spacingM, 0.0, 1.0)); };
    return {0.55f * std::max(finer(2.0), 0.8f), 0.45f * std::max(finer(28.0), 0.3f), 0.40f * finer(324.0),
            0.35f * finer(4700.0)};
}

} // namespace osgTerrainROAM
