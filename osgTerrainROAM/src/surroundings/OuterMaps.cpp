// SPDX-License-Identifier: Apache-2.0
#include "OuterMaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../material/GroundRule.h"
#include "../material/NormalMap.h"
#include "../material/ParallelRows.h"
#include "../material/SkyVisibility.h"

namespace osgTerrainROAM
{

namespace
{

constexpr int kMapSide = OuterAxis::kTexels;

unsigned char shareByte(double share)
{
    return static_cast<unsigned char>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

osg::ref_ptr<osg::Image> squareImage(GLenum format, GLenum type, GLint internal)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kMapSide, kMapSide, 1, format, type);
    image->setInternalTextureFormat(internal);
    return image;
}

/// Writes the texels of both maps, from the ground at each of them.
class MapWriter
{
public:
    MapWriter(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows,
              const Climate& climate)
        : _ground(ground),
          _rule(climate, ground.spacingM()),
          _sunSide(climate.latitudeDeg < 0.0 ? 1.0 : -1.0),
          _sites(static_cast<std::size_t>(kMapSide) * kMapSide)
    {
        for (int i = 0; i < kMapSide; ++i)
            _at.emplace_back(columns.gridAt(i), rows.gridAt(i));
        parallelRows(kMapSide,
                     [&](int first, int end)
                     {
                         for (int y = first; y < end; ++y)
                             for (int x = 0; x < kMapSide; ++x)
                                 _sites[index(x, y)] = _ground.at({_at[x].x, _at[y].y});
                     });
    }

    void write(int x, int y, const OuterMaps& maps) const
    {
        const OuterGround::Site& site = _sites[index(x, y)];
        const glm::dvec2 gradient = gradientAt(x, y);
        const glm::dvec2 tilt = -gradient / std::sqrt(1.0 + glm::dot(gradient, gradient));
        packNormal(glm::dvec3(tilt, 0.0), reinterpret_cast<std::uint16_t*>(maps.normals->data(x, y)));
        const double steepness = glm::length(gradient);
        const double perPoint = _ground.spacingM() / _ground.tile().grid().cellSide();
        const double noise = _rule.noiseAt(_at[x].x * perPoint, _at[y].y * perPoint);
        const GroundSite land{site.heightM, steepness, _sunSide * tilt.y, 0.0, noise};
        unsigned char* const out = maps.land->data(x, y);
        out[0] = shareByte(_rule.vegetation(land));
        out[1] = shareByte(_rule.snow(land));
        out[2] = shareByte(0.5 + 6.0 * (site.water - 0.5));
        out[3] = shareByte(skyVisibility(0.0f));
    }

private:
    static std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * kMapSide + x; }

    glm::dvec2 gradientAt(int x, int y) const
    {
        const int west = std::max(x - 1, 0), east = std::min(x + 1, kMapSide - 1);
        const int south = std::max(y - 1, 0), north = std::min(y + 1, kMapSide - 1);
        const glm::dvec2 perGrid((_sites[index(east, y)].heightM - _sites[index(west, y)].heightM) /
                                     (_at[east].x - _at[west].x),
                                 (_sites[index(x, north)].heightM - _sites[index(x, south)].heightM) /
                                     (_at[north].y - _at[south].y));
        return _ground.localGradient(perGrid);
    }

    const OuterGround& _ground;
    GroundRule _rule;
    double _sunSide;
    std::vector<glm::dvec2> _at; ///< grid position of each texel, of both axes
    std::vector<OuterGround::Site> _sites;
};

} // namespace

OuterMaps outerMaps(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows,
                    const Climate& climate)
{
    OuterMaps maps{squareImage(GL_RG, GL_UNSIGNED_SHORT, GL_RG16),
                   squareImage(GL_RGBA, GL_UNSIGNED_BYTE, GL_RGBA8)};
    const MapWriter writer(ground, columns, rows, climate);
    parallelRows(kMapSide,
                 [&](int first, int end)
                 {
                     for (int y = first; y < end; ++y)
                         for (int x = 0; x < kMapSide; ++x)
                             writer.write(x, y, maps);
                 });
    return maps;
}

} // namespace osgTerrainROAM
