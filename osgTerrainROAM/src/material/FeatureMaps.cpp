// SPDX-License-Identifier: Apache-2.0
#include "FeatureMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>

#include <foundation/PlainBytes.h>

#include <osgTerrainROAM/core/features/FeatureCover.h>

#include "ImageBytes.h"
#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

constexpr int kRecordsPerRow = 1024; ///< a power of two: the shader divides by a shift and a mask
constexpr int kMaxFarSide = 4096;    ///< of maps of four shares; twice that of maps of one

osg::ref_ptr<osg::Image> floatImage(int width, int height)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGBA, GL_FLOAT);
    image->setInternalTextureFormat(GL_RGBA32F_ARB);
    std::fill_n(image->data(), image->getTotalSizeInBytes(), static_cast<unsigned char>(0));
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

using FarShares = std::array<float, 9>; ///< crops, then river, asphalt, gravel, runway, shade of fields

/// What a texel of the far maps holds.
FarShares farShares(const core::FeatureCells& cells, int perCell, const glm::ivec2& texel)
{
    const double texelM = cells.cellM / perCell;
    // Lists reach 16 m: a wider texel takes the mean of several filters.
    const int parts = static_cast<int>(std::ceil(texelM / (2.0 * core::FeatureCells::kReachM)));
    FarShares sums{};
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i)
        {
            const glm::dvec2 at = glm::dvec2(texel) + glm::dvec2((i + 0.5) / parts, (j + 0.5) / parts);
            const glm::dvec2 place = glm::dvec2(cells.firstCell) * cells.cellM + at * texelM;
            const core::FeatureCover cover = core::featureCover(cells, place, texelM / parts);
            for (std::size_t c = 0; c < 4; ++c)
                sums[c] += cover.crops[c];
            for (const auto& [c, value] : {std::pair{4, cover.river},
                                           {5, cover.asphalt},
                                           {6, cover.gravel},
                                           {7, cover.runway},
                                           {8, cover.shade}})
                sums[c] += value;
        }
    for (float& sum : sums)
        sum = std::min(sum / static_cast<float>(parts * parts), 1.0f);
    return sums;
}

unsigned char shareByte(float share)
{
    return static_cast<unsigned char>(std::lround(255.0f * share));
}

/// Calls `fill` with each texel of cells that list something, by several threads.
void forFarTexels(const core::FeatureCells& cells, int perCell, const std::function<void(glm::ivec2)>& fill)
{
    const auto fillCell = [&](int column, int row)
    {
        const auto& cell = cells.cells[static_cast<std::size_t>(row) * cells.columns + column];
        if (cell.areas + cell.lines + cell.strokes == 0) return;
        for (int y = row * perCell; y < (row + 1) * perCell; ++y)
            for (int x = column * perCell; x < (column + 1) * perCell; ++x)
                fill({x, y});
    };
    parallelRows(cells.rows,
                 [&](int first, int end)
                 {
                     for (int row = first; row < end; ++row)
                         for (int column = 0; column < cells.columns; ++column)
                             fillCell(column, row);
                 });
}

/// An image of the far maps, of zeros. `format`: of texels and of the texture.
osg::ref_ptr<osg::Image> farImage(const core::FeatureCells& cells, int perCell, GLenum format, GLint internal)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(cells.columns * perCell, cells.rows * perCell, 1, format, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(internal);
    std::fill_n(image->data(), image->getTotalSizeInBytes(), static_cast<unsigned char>(0));
    return image;
}

/// Paints the far maps.
class FarPainter
{
public:
    osg::ref_ptr<osg::Image> crops, beds;

    /// `isShaded`: the last channel of beds is the shade of fields where it is larger than the runway.
    FarPainter(const core::FeatureCells& cells, int perCell, bool isShaded)
        : crops(farImage(cells, perCell, GL_RGBA, GL_RGBA8)),
          beds(farImage(cells, perCell, GL_RGBA, GL_RGBA8))
    {
        forFarTexels(cells, perCell,
                     [&](const glm::ivec2& texel)
                     {
                         FarShares shares = farShares(cells, perCell, texel);
                         if (isShaded) shares[7] = std::max(shares[7], shares[8]);
                         for (unsigned c = 0; c < 8; ++c)
                             (c < 4 ? crops : beds)->data(texel.x, texel.y)[c & 3] = shareByte(shares[c]);
                     });
    }
};

/// Whether cells list roads of asphalt and nothing else.
bool listAsphaltAlone(const core::FeatureCells& cells)
{
    for (const core::FeatureCells::Cell& cell : cells.cells)
    {
        if (cell.areas + cell.strokes > 0) return false;
        for (std::uint32_t i = 0; i < cell.lines; ++i)
            if ((static_cast<int>(cells.records[cell.first + 2 * i + 1][2]) & 15) !=
                static_cast<int>(core::FeatureKind::road))
                return false;
    }
    return true;
}

/// The share of asphalt alone: a quarter of the memory of beds.
osg::ref_ptr<osg::Image> asphaltImage(const core::FeatureCells& cells, int perCell)
{
    const osg::ref_ptr<osg::Image> image = farImage(cells, perCell, GL_RED, GL_R8);
    forFarTexels(cells, perCell,
                 [&](const glm::ivec2& texel)
                 { *image->data(texel.x, texel.y) = shareByte(farShares(cells, perCell, texel)[5]); });
    return image;
}

FeatureMaps gridOf(const core::FeatureCells& cells, int mostPerCell, int mostSide = kMaxFarSide)
{
    FeatureMaps maps;
    maps.firstCell = cells.firstCell;
    maps.columns = cells.columns;
    maps.rows = cells.rows;
    maps.cellM = cells.cellM;
    maps.farPerCell = mostPerCell;
    while (maps.farPerCell > 1 && std::max(cells.columns, cells.rows) * maps.farPerCell > mostSide)
        maps.farPerCell /= 2;
    return maps;
}

foundation::ContentMark markOf(const core::FeatureCells& cells, const FeatureMaps& maps)
{
    return core::markOfCells(cells).addWord(static_cast<unsigned>(maps.farPerCell));
}

/// The plain numbers of maps.
struct MapNumbers
{
    glm::ivec2 firstCell{0};
    std::int32_t columns = 0, rows = 0;
    double cellM = 0.0;
    std::int32_t farPerCell = 0;
    std::uint32_t images = 0; ///< a bit for each that is there, in the order of imagesOf()
};

std::array<FeatureMaps::Image*, 4> imagesOf(FeatureMaps& maps)
{
    return {&maps.cells, &maps.records, &maps.crops, &maps.beds};
}

bool hasSides(const osg::Image& image, int width, int height)
{
    return image.s() == width && image.t() == height;
}

/// Whether images have the sizes that the shaders count on.
bool fit(const FeatureMaps& maps)
{
    constexpr int kMostCells = 1 << 20;
    if (maps.columns == 0 && maps.rows == 0) return !maps.cells && !maps.records && !maps.crops && !maps.beds;
    if (maps.columns < 0 || maps.rows < 0 || maps.columns > kMostCells || maps.rows > kMostCells ||
        !(maps.cellM >= 1.0 && maps.cellM <= 1e6) || maps.farPerCell < 1 || maps.farPerCell > kMaxFarSide ||
        !maps.beds)
        return false;
    const int far = maps.farPerCell;
    const auto isFar = [&](const osg::Image& image)
    { return hasSides(image, std::max(maps.columns * far, 1), std::max(maps.rows * far, 1)); };
    const auto isOfFloats = [](const osg::Image& image) { return image.getDataType() == GL_FLOAT; };
    if (!isFar(*maps.beds)) return false;
    if (!maps.cells && !maps.records && !maps.crops) return true;
    return maps.cells && maps.records && maps.crops && isFar(*maps.crops) && isOfFloats(*maps.cells) &&
           isOfFloats(*maps.records) && maps.records->s() == kRecordsPerRow &&
           hasSides(*maps.cells, std::max(maps.columns, 1), std::max(maps.rows, 1));
}

} // namespace

FeatureMaps FeatureMaps::of(const core::FeatureCells& cells, const foundation::KeptFrom& kept)
{
    constexpr int kMaxFarPerCell = 8;
    FeatureMaps maps = gridOf(cells, kMaxFarPerCell);
    maps.runways = cells.runways;
    maps.cells = cellImage(cells);
    maps.records = recordImage(cells);
    const auto far = keptImages<2>(kept, "far", markOf(cells, maps),
                                   [&]
                                   {
                                       const FarPainter painted(cells, maps.farPerCell,
                                                                cells.runways.size() <= kMostRunways);
                                       return std::array{painted.crops, painted.beds};
                                   });
    maps.crops = far[0];
    maps.beds = far[1];
    return maps;
}

FeatureMaps FeatureMaps::farOf(const core::FeatureCells& cells, const foundation::KeptFrom& kept)
{
    constexpr int kMaxBedsPerCell = 16;
    const bool isAsphalt = listAsphaltAlone(cells);
    FeatureMaps maps = gridOf(cells, kMaxBedsPerCell, isAsphalt ? 2 * kMaxFarSide : kMaxFarSide);
    if (cells.cells.empty()) return maps;
    const auto paint = [&] {
        return isAsphalt ? asphaltImage(cells, maps.farPerCell)
                         : FarPainter(cells, maps.farPerCell, false).beds;
    };
    maps.beds = keptImage(kept, isAsphalt ? "asphalt" : "beds", markOf(cells, maps), paint);
    return maps;
}

std::string bytesOf(const FeatureMaps& maps)
{
    FeatureMaps copy = maps;
    MapNumbers numbers{maps.firstCell, maps.columns, maps.rows, maps.cellM, maps.farPerCell, 0};
    const auto images = imagesOf(copy);
    for (std::size_t i = 0; i < images.size(); ++i)
        numbers.images |= *images[i] ? 1U << i : 0U;
    std::string bytes;
    foundation::appendValue(bytes, numbers);
    foundation::appendValues(bytes, maps.runways);
    for (const FeatureMaps::Image* image : images)
        if (*image) foundation::appendText(bytes, bytesOf(**image));
    return bytes;
}

std::optional<FeatureMaps> featureMapsIn(std::string_view bytes)
{
    foundation::ValueTaker taker(bytes);
    MapNumbers numbers;
    FeatureMaps maps;
    if (!taker.take(numbers) || !taker.take(maps.runways)) return std::nullopt;
    maps.firstCell = numbers.firstCell;
    maps.columns = numbers.columns;
    maps.rows = numbers.rows;
    maps.cellM = numbers.cellM;
    maps.farPerCell = numbers.farPerCell;
    const auto images = imagesOf(maps);
    for (std::size_t i = 0; i < images.size(); ++i)
    {
        std::string_view text;
        if ((numbers.images >> i & 1U) == 0) continue;
        auto image = taker.take(text) ? imageIn(text) : std::nullopt;
        if (!image) return std::nullopt;
        *images[i] = *std::move(image);
    }
    return taker.isEmpty() && fit(maps) ? std::optional(std::move(maps)) : std::nullopt;
}

} // namespace osgTerrainROAM
