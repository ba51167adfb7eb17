// SPDX-License-Identifier: Apache-2.0
#include "FeatureTextures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include <osg/Texture2D>
#include <osg/Uniform>

#include <osgTerrainROAM/core/features/FeatureCover.h>

#include "ImageBytes.h"
#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

constexpr int kRecordsPerRow = 1024; ///< a power of two: the shader divides by a shift and a mask
constexpr int kMaxFarSide = 4096;
constexpr int kMaxFarPerCell = 8; ///< and twice as many where the far maps are all there is

osg::ref_ptr<osg::Image> floatImage(int width, int height)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGBA, GL_FLOAT);
    image->setInternalTextureFormat(GL_RGBA32F_ARB);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    return image;
}

/// Whether a cell lists a road with markings.
bool listsMarkedRoad(const core::FeatureCells& cells, const core::FeatureCells::Cell& cell)
{
    constexpr float kMarked = 256.0F; // of a line's code
    std::size_t record = cell.first;
    for (std::uint32_t area = 0; area < cell.areas; ++area)
        record += 2 + static_cast<std::size_t>(cells.records[record][0]);
    for (std::uint32_t line = 0; line < cell.lines; ++line, record += 2)
        if (cells.records[record + 1][2] >= kMarked) return true;
    return false;
}

/// A half is added to the number of lines where a road among them has markings.
osg::ref_ptr<osg::Image> cellImage(const core::FeatureCells& cells)
{
    const osg::ref_ptr<osg::Image> image = floatImage(cells.columns, cells.rows);
    auto* out = reinterpret_cast<float*>(image->data());
    for (const core::FeatureCells::Cell& cell : cells.cells)
    {
        *out++ = static_cast<float>(cell.first);
        *out++ = static_cast<float>(cell.areas);
        *out++ = static_cast<float>(cell.lines) + (listsMarkedRoad(cells, cell) ? 0.5F : 0.0F);
        *out++ = static_cast<float>(cell.strokes);
    }
    return image;
}

osg::ref_ptr<osg::Image> recordImage(const core::FeatureCells& cells)
{
    const auto rows = static_cast<int>((cells.records.size() + kRecordsPerRow - 1) / kRecordsPerRow);
    const osg::ref_ptr<osg::Image> image = floatImage(kRecordsPerRow, std::max(rows, 1));
    if (!cells.records.empty())
        std::memcpy(image->data(), cells.records.data(), cells.records.size() * sizeof(cells.records[0]));
    return image;
}

/// The far maps: texels along a cell, and the two images.
struct FarMaps
{
    int perCell;
    osg::ref_ptr<osg::Image> crops, beds;

    /// `kept`: what follows from the program alone; the images are found there the second time.
    FarMaps(const core::FeatureCells& cells, int mostPerCell, const foundation::KeptFrom& kept)
        : perCell(mostPerCell)
    {
        while (perCell > 1 && std::max(cells.columns, cells.rows) * perCell > kMaxFarSide)
            perCell /= 2;
        const auto both =
            keptImages<2>(kept, "far", core::markOfCells(cells).addWord(static_cast<unsigned>(perCell)),
                          [&]
                          {
                              paint(cells);
                              return std::array{crops, beds};
                          });
        crops = both[0];
        beds = both[1];
    }

private:
    void paint(const core::FeatureCells& cells)
    {
        crops = new osg::Image;
        beds = new osg::Image;
        for (osg::Image* image : {crops.get(), beds.get()})
        {
            image->allocateImage(cells.columns * perCell, cells.rows * perCell, 1, GL_RGBA, GL_UNSIGNED_BYTE);
            image->setInternalTextureFormat(GL_RGBA8);
            std::memset(image->data(), 0, image->getTotalSizeInBytes());
        }
        parallelRows(cells.rows,
                     [&](int first, int end)
                     {
                         for (int row = first; row < end; ++row)
                             for (int column = 0; column < cells.columns; ++column)
                                 fillCell(cells, column, row);
                     });
    }

    void fillCell(const core::FeatureCells& cells, int column, int row) const
    {
        const auto& cell = cells.cells[static_cast<std::size_t>(row) * cells.columns + column];
        if (cell.areas + cell.lines + cell.strokes == 0) return;
        for (int y = row * perCell; y < (row + 1) * perCell; ++y)
            for (int x = column * perCell; x < (column + 1) * perCell; ++x)
                fillTexel(cells, x, y);
    }

    void fillTexel(const core::FeatureCells& cells, int x, int y) const
    {
        const double texelM = cells.cellM / perCell;
        // Lists reach 16 m: a wider texel takes the mean of several filters.
        const int parts = static_cast<int>(std::ceil(texelM / (2.0 * core::FeatureCells::kReachM)));
        float sums[8]{};
        for (int j = 0; j < parts; ++j)
            for (int i = 0; i < parts; ++i)
            {
                const glm::dvec2 at(x + (i + 0.5) / parts, y + (j + 0.5) / parts);
                const glm::dvec2 place = glm::dvec2(cells.firstCell) * cells.cellM + at * texelM;
                const core::FeatureCover cover = core::featureCover(cells, place, texelM / parts);
                for (std::size_t c = 0; c < 4; ++c)
                    sums[c] += cover.crops[c];
                for (const auto& [c, value] :
                     {std::pair{4, cover.river}, {5, cover.asphalt}, {6, cover.gravel}, {7, cover.runway}})
                    sums[c] += value;
            }
        const std::size_t texel = 4 * (static_cast<std::size_t>(y) * crops->s() + x);
        for (std::size_t c = 0; c < 8; ++c)
            (c < 4 ? crops : beds)->data()[texel + (c & 3)] =
                static_cast<unsigned char>(std::lround(255.0f * std::min(sums[c] / (parts * parts), 1.0f)));
    }
};

void addTexture(osg::StateSet& stateSet, const char* name, int unit, osg::Image* image, bool filtered)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER,
                       filtered ? osg::Texture::LINEAR_MIPMAP_LINEAR : osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, filtered ? osg::Texture::LINEAR : osg::Texture::NEAREST);
    // Beyond the border all shares are 0.
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_BORDER);
    texture->setBorderColor(osg::Vec4d(0.0, 0.0, 0.0, 0.0));
    stateSet.setTextureAttributeAndModes(unit, texture);
    stateSet.addUniform(new osg::Uniform(name, unit));
}

/// Adds where the cells lie, as uniforms of names that begin with `prefix`.
void addGrid(osg::StateSet& stateSet, const core::FeatureCells& cells, const std::string& prefix)
{
    osg::ref_ptr<osg::Uniform> grid = new osg::Uniform(osg::Uniform::INT_VEC4, prefix + "Grid");
    grid->set(cells.firstCell.x, cells.firstCell.y, cells.columns, cells.rows);
    stateSet.addUniform(grid);
    const std::string cellM = prefix + "CellM";
    stateSet.addUniform(new osg::Uniform(cellM.c_str(), static_cast<float>(cells.cellM)));
}

} // namespace

namespace
{

constexpr std::size_t kMostRunways =
    16; ///< in shaders/FeatureMaps.glsl; where there are more, the far map shows them all

void addRunways(osg::StateSet& stateSet, const core::FeatureCells& cells)
{
    const bool areAll = cells.runways.size() <= kMostRunways;
    const std::size_t count = areAll ? cells.runways.size() : 0;
    const osg::ref_ptr<osg::Uniform> ends =
        new osg::Uniform(osg::Uniform::FLOAT_VEC4, "featureRunways", kMostRunways);
    const osg::ref_ptr<osg::Uniform> halves =
        new osg::Uniform(osg::Uniform::FLOAT, "featureRunwayHalfM", kMostRunways);
    const glm::dvec2 first = glm::dvec2(cells.firstCell) * cells.cellM;
    for (unsigned int i = 0; i < count; ++i)
    {
        const glm::vec2 from(cells.runways[i].from - first), to(cells.runways[i].to - first);
        ends->setElement(i, osg::Vec4f(from.x, from.y, to.x, to.y));
        halves->setElement(i, static_cast<float>(0.5 * cells.runways[i].widthM));
    }
    stateSet.addUniform(ends);
    stateSet.addUniform(halves);
    stateSet.addUniform(new osg::Uniform("featureRunwayCount", static_cast<int>(count)));
}

} // namespace

void addFeatureTextures(osg::StateSet& stateSet, const core::FeatureCells& cells, int firstUnit,
                        const foundation::KeptFrom& kept)
{
    const FarMaps far(cells, kMaxFarPerCell, kept);
    addTexture(stateSet, "featureCells", firstUnit, cellImage(cells).get(), false);
    addTexture(stateSet, "featureRecords", firstUnit + 1, recordImage(cells).get(), false);
    addTexture(stateSet, "featureFarCrops", firstUnit + 2, far.crops.get(), true);
    addTexture(stateSet, "featureFarBeds", firstUnit + 3, far.beds.get(), true);
    addGrid(stateSet, cells, "feature");
    addRunways(stateSet, cells);
    stateSet.addUniform(new osg::Uniform("featureFarTexelM", static_cast<float>(cells.cellM / far.perCell)));
}

void addFarFeatureTexture(osg::StateSet& stateSet, const core::FeatureCells& cells, int unit,
                          const foundation::KeptFrom& kept)
{
    addTexture(stateSet, "farFeatureBeds", unit, FarMaps(cells, 2 * kMaxFarPerCell, kept).beds.get(), true);
    addGrid(stateSet, cells, "farFeature");
}

} // namespace osgTerrainROAM
