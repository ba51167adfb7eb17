// SPDX-License-Identifier: Apache-2.0
#include "ImageryDrape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <gdal_priv.h>

#include <osg/Notify>

#include "../core/cover/PixelNet.h"
#include "../core/heightfield/DatasetPtr.h"
#include "../core/heightfield/GdalSession.h"
#include "../core/heightfield/RasterOrientation.h"
#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

using foundation::Error;
using foundation::Result;

constexpr int kMaxSide = 8192; ///< texels; 256 MiB at four bytes

/// The pixels of the image as RGBA, at a reduced resolution where it is too large.
struct Pixels
{
    int width = 0;
    int height = 0;
    double reduction = 1.0; ///< file pixels per pixel here
    std::vector<unsigned char> rgba;

    const unsigned char* at(int x, int y) const
    {
        return &rgba[4 * (static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width +
                          std::clamp(x, 0, width - 1))];
    }

    /// Interpolates bilinearly; pixel centres lie at half-integers, as in GDAL. Alpha is 0 beyond the image.
    std::array<unsigned char, 4> sample(double x, double y) const
    {
        x /= reduction;
        y /= reduction;
        if (!(x >= 0.0 && y >= 0.0 && x <= width && y <= height)) return {0, 0, 0, 0};
        const int i = static_cast<int>(std::floor(x - 0.5));
        const int j = static_cast<int>(std::floor(y - 0.5));
        const double fx = x - 0.5 - i;
        const double fy = y - 0.5 - j;
        std::array<unsigned char, 4> result{};
        for (int c = 0; c < 4; ++c)
            result[c] = static_cast<unsigned char>(std::lround(
                std::lerp(std::lerp<double, double, double>(at(i, j)[c], at(i + 1, j)[c], fx),
                          std::lerp<double, double, double>(at(i, j + 1)[c], at(i + 1, j + 1)[c], fx), fy)));
        return result;
    }
};

/// Reads one band into every fourth byte; a band of more than eight bits is stretched between its extremes.
bool readBand(GDALRasterBand& band, Pixels& pixels, int channel)
{
    double extremes[2] = {0.0, 255.0};
    if (band.GetRasterDataType() != GDT_Byte && band.ComputeRasterMinMax(TRUE, extremes) != CE_None)
        return false;
    std::vector<float> values(static_cast<std::size_t>(pixels.width) * pixels.height);
    if (band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), values.data(), pixels.width,
                      pixels.height, GDT_Float32, 0, 0, nullptr) != CE_None)
        return false;
    const double scale = 255.0 / std::max(extremes[1] - extremes[0], 1e-9);
    for (std::size_t i = 0; i < values.size(); ++i)
        pixels.rgba[4 * i + channel] = static_cast<unsigned char>(
            std::lround(std::clamp((values[i] - extremes[0]) * scale, 0.0, 255.0)));
    return true;
}

void applyPalette(const GDALColorTable& table, Pixels& pixels)
{
    for (std::size_t i = 0; i < pixels.rgba.size(); i += 4)
    {
        GDALColorEntry entry{};
        table.GetColorEntryAsRGB(std::min<int>(pixels.rgba[i], table.GetColorEntryCount() - 1), &entry);
        pixels.rgba[i] = static_cast<unsigned char>(entry.c1);
        pixels.rgba[i + 1] = static_cast<unsigned char>(entry.c2);
        pixels.rgba[i + 2] = static_cast<unsigned char>(entry.c3);
    }
}

bool readPixels(GDALDataset& dataset, Pixels& pixels)
{
    const int longest = std::max(dataset.GetRasterXSize(), dataset.GetRasterYSize());
    pixels.reduction = std::max(1.0, static_cast<double>(longest) / kMaxSide);
    pixels.width = std::max(1, static_cast<int>(dataset.GetRasterXSize() / pixels.reduction));
    pixels.height = std::max(1, static_cast<int>(dataset.GetRasterYSize() / pixels.reduction));
    pixels.rgba.assign(static_cast<std::size_t>(4) * pixels.width * pixels.height, 255);
    const int bands = dataset.GetRasterCount();
    const bool colour = bands >= 3;
    for (int channel = 0; channel < 3; ++channel)
        if (!readBand(*dataset.GetRasterBand(colour ? channel + 1 : 1), pixels, channel)) return false;
    if (bands == 2 || bands >= 4)
    {
        GDALRasterBand& last = *dataset.GetRasterBand(colour ? 4 : 2);
        if (last.GetColorInterpretation() == GCI_AlphaBand && !readBand(last, pixels, 3)) return false;
    }
    if (const GDALColorTable* table = dataset.GetRasterBand(1)->GetColorTable(); table && !colour)
        applyPalette(*table, pixels);
    return true;
}

/// The number of texels along one axis that keeps the resolution of the image.
int drapeSide(double imageryPixels)
{
    return static_cast<int>(std::clamp(std::ceil(imageryPixels), 2.0, static_cast<double>(kMaxSide)));
}

/// The part of a tile's grid that an image covers.
struct GridBox
{
    glm::dvec2 first, last;
};

GridBox wholeGrid(const core::PlacedTile& tile)
{
    return {{0.0, 0.0}, {tile.grid().dataColumns() - 1.0, tile.grid().dataRows() - 1.0}};
}

/// The grid position of a pixel, by Newton's method: the mapping is nearly linear.
glm::dvec2 gridUnder(const core::PixelNet& net, const glm::dvec2& pixel, glm::dvec2 grid)
{
    for (int step = 0; step < 12; ++step)
    {
        const glm::dvec2 at = net.pixelAt(grid.x, grid.y);
        const glm::dmat2 slope(net.pixelAt(grid.x + 1.0, grid.y) - at,
                               net.pixelAt(grid.x, grid.y + 1.0) - at);
        if (std::abs(glm::determinant(slope)) < 1e-12) break;
        grid += glm::inverse(slope) * (pixel - at);
    }
    return grid;
}

/// The box of the tile's grid around the border of an image; empty (last below first) where they do not
/// overlap.
GridBox gridOf(const core::PixelNet& net, const core::PlacedTile& tile, const glm::dvec2& size)
{
    const GridBox whole = wholeGrid(tile);
    GridBox box{glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (int i = 0; i <= 16; ++i)
        for (const glm::dvec2& share :
             {glm::dvec2(i / 16.0, 0.0), {i / 16.0, 1.0}, {0.0, i / 16.0}, {1.0, i / 16.0}})
        {
            const glm::dvec2 place = gridUnder(net, share * size, 0.5 * whole.last);
            box.first = glm::min(box.first, place);
            box.last = glm::max(box.last, place);
        }
    return {glm::max(box.first, whole.first), glm::min(box.last, whole.last)};
}

/// Samples the image over a box of the grid; counts the rows with a covered texel.
bool sampleInto(osg::Image& image, const Pixels& pixels, const core::PixelNet& net, const GridBox& box)
{
    std::vector<int> covered(static_cast<std::size_t>(image.t()), 0);
    const glm::dvec2 extent = box.last - box.first;
    parallelRows(image.t(),
                 [&](int first, int end)
                 {
                     for (int y = first; y < end; ++y)
                         for (int x = 0; x < image.s(); ++x)
                         {
                             const glm::dvec2 pixel =
                                 net.pixelAt(box.first.x + x * extent.x / (image.s() - 1),
                                             box.first.y + y * extent.y / (image.t() - 1));
                             const auto rgba = pixels.sample(pixel.x, pixel.y);
                             std::copy(rgba.begin(), rgba.end(), image.data(x, y));
                             covered[static_cast<std::size_t>(y)] += rgba[3] > 0;
                         }
                 });
    return std::any_of(covered.begin(), covered.end(), [](int count) { return count > 0; });
}

Result<ImageryLayer> laid(const std::filesystem::path& file, const core::PlacedTile& tile, bool overAll)
{
    core::GdalSession session;
    GDALAllRegister();
    const std::string name = file.string();
    session.setFile(name);
    const core::DatasetPtr dataset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (!dataset || dataset->GetRasterCount() < 1)
        return Error{name, session.firstError().empty() ? "is no raster GDAL can open" : session.firstError(),
                     "give an image or a georeferenced raster"};
    const auto net = core::PixelNet::make(*dataset, tile, name);
    if (!net) return net.error();
    core::noteSouthUp(GDALDataset::ToHandle(dataset.get()), session);
    const glm::dvec2 size(dataset->GetRasterXSize(), dataset->GetRasterYSize());
    const GridBox box = overAll ? wholeGrid(tile) : gridOf(*net, tile, size);
    const Error nothing{name, "covers nothing of the terrain", "give an imagery of the same place"};
    if (!(box.first.x < box.last.x && box.first.y < box.last.y)) return nothing;
    Pixels pixels;
    if (!readPixels(*dataset, pixels))
        return Error{name, "cannot be read: " + session.firstError(), "check the file"};

    ImageryLayer layer{new osg::Image, box.first, box.last};
    const glm::dvec2 corner = net->pixelAt(box.first.x, box.first.y);
    const double wide = glm::distance(corner, net->pixelAt(box.last.x, box.first.y)) / pixels.reduction;
    layer.image->allocateImage(
        drapeSide(wide),
        drapeSide(glm::distance(corner, net->pixelAt(box.first.x, box.last.y)) / pixels.reduction), 1,
        GL_RGBA, GL_UNSIGNED_BYTE);
    if (!sampleInto(*layer.image, pixels, *net, box)) return nothing;
    const double placeM = tile.field().spacingEastM / tile.grid().cellSide();
    for (const std::string& note : session.notes())
        osg::notify(osg::NOTICE) << note << std::endl;
    layer.texelM = (box.last.x - box.first.x) * placeM / (layer.image->s() - 1);
    return layer;
}

} // namespace

Result<osg::ref_ptr<osg::Image>> imageryDrape(const std::filesystem::path& file, const core::PlacedTile& tile)
{
    auto layer = laid(file, tile, true);
    if (!layer) return layer.error();
    return layer->image;
}

Result<ImageryLayer> imageryLayer(const std::filesystem::path& file, const core::PlacedTile& tile)
{
    return laid(file, tile, false);
}

} // namespace osgTerrainROAM
