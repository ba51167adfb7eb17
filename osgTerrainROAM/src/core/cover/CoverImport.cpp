// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include <foundation/ForEachAtOnce.h>
#include <foundation/PlainBytes.h>
#include <gdal_priv.h>

#include <osgTerrainROAM/core/cover/CoverImport.h>

#include "../heightfield/DatasetPtr.h"
#include "../heightfield/GdalSession.h"
#include "../heightfield/RasterOrientation.h"
#include "PixelNet.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

constexpr int kMaxCoverSide = 8192;        ///< texels
constexpr std::size_t kMostCodesTold = 32; ///< counted separately in a report
constexpr int kNoClass = -2000000;         ///< smaller than every code

/// The part of the raster under the tile, perhaps thinned out.
struct Classes
{
    glm::dvec2 firstPixel{0.0}; ///< of the raster, upper left
    glm::dvec2 perPixel{1.0};   ///< pixels of this part to a pixel of the raster
    int width = 0, height = 0;
    std::vector<std::int32_t> codes;

    int at(const glm::dvec2& pixel) const
    {
        const glm::dvec2 place = glm::floor((pixel - firstPixel) * perPixel);
        if (!(place.x >= 0.0 && place.y >= 0.0 && place.x < width && place.y < height)) return kNoClass;
        return codes[static_cast<std::size_t>(place.y) * width + static_cast<std::size_t>(place.x)];
    }
};

/// The part of the raster that the tile's corners, edges and middle need.
bool readClasses(GDALDataset& dataset, const PixelNet& net, const PlacedTile& tile, Classes& classes)
{
    glm::dvec2 low(1e9), high(-1e9);
    for (int j = 0; j <= 32; ++j)
        for (int i = 0; i <= 32; ++i)
        {
            const glm::dvec2 pixel = net.pixelAt((tile.grid().dataColumns() - 1) * i / 32.0,
                                                 (tile.grid().dataRows() - 1) * j / 32.0);
            low = glm::min(low, pixel - 2.0);
            high = glm::max(high, pixel + 2.0);
        }
    const glm::dvec2 size(dataset.GetRasterXSize(), dataset.GetRasterYSize());
    low = glm::floor(glm::clamp(low, glm::dvec2(0.0), size));
    high = glm::ceil(glm::clamp(high, glm::dvec2(0.0), size));
    const glm::dvec2 extent = high - low;
    if (!(extent.x >= 1.0 && extent.y >= 1.0)) return true; // outside the raster: all unknown
    classes.firstPixel = low;
    classes.width = static_cast<int>(std::min<double>(extent.x, kMaxCoverSide));
    classes.height = static_cast<int>(std::min<double>(extent.y, kMaxCoverSide));
    classes.perPixel = glm::dvec2(classes.width, classes.height) / extent;
    classes.codes.resize(static_cast<std::size_t>(classes.width) * classes.height);
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    if (band.RasterIO(GF_Read, static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(extent.x),
                      static_cast<int>(extent.y), classes.codes.data(), classes.width, classes.height,
                      GDT_Int32, 0, 0, nullptr) != CE_None)
        return false;
    int hasNoData = 0;
    const double noData = band.GetNoDataValue(&hasNoData);
    if (hasNoData && std::abs(noData) < 2.0e9)
        std::replace(classes.codes.begin(), classes.codes.end(),
                     static_cast<std::int32_t>(std::lround(noData)), kNoClass);
    return true;
}

int sideOf(double pixels)
{
    return static_cast<int>(std::clamp(std::ceil(pixels), 2.0, static_cast<double>(kMaxCoverSide)));
}

GroundKind kindOf(int code, const CoverTable& table, CoverMap& map)
{
    if (code == kNoClass) return GroundKind::unknown;
    if (const auto found = table.find(code); found != table.end()) return found->second;
    if (map.unknownCodes.size() < kMostCodesTold || map.unknownCodes.contains(code)) ++map.unknownCodes[code];
    return GroundKind::unknown;
}

CoverMap mapOf(const Classes& classes, const PixelNet& net, const CoverTable& table, const PlacedTile& tile)
{
    const int lastColumn = tile.grid().dataColumns() - 1, lastRow = tile.grid().dataRows() - 1;
    CoverMap map;
    const glm::dvec2 corner = net.pixelAt(0, 0);
    map.width = sideOf(glm::distance(corner, net.pixelAt(lastColumn, 0)));
    map.height = sideOf(glm::distance(corner, net.pixelAt(0, lastRow)));
    std::vector<std::int32_t> codes(static_cast<std::size_t>(map.width) * map.height);
    foundation::forEachAtOnce(static_cast<std::size_t>(map.height),
                              [&](std::size_t y)
                              {
                                  const double row = static_cast<double>(y) * lastRow / (map.height - 1);
                                  for (int x = 0; x < map.width; ++x)
                                      codes[y * map.width + x] = classes.at(net.pixelAt(
                                          static_cast<double>(x) * lastColumn / (map.width - 1), row));
                              });
    map.kinds.reserve(codes.size());
    for (const std::int32_t code : codes)
        map.kinds.push_back(kindOf(code, table, map));
    return map;
}

Result<CoverMap> readCover(const std::filesystem::path& file, const CoverTable& table, const PlacedTile& tile)
{
    GdalSession gdal;
    const std::string name = file.string();
    gdal.setFile(name);
    const DatasetPtr dataset(
        GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (!dataset || dataset->GetRasterCount() < 1)
        return Error{name, gdal.hasFailed() ? gdal.firstError() : "is no raster GDAL can open",
                     "give a raster of classes"};
    const auto net = PixelNet::make(*dataset, tile, name);
    if (!net) return net.error();
    noteSouthUp(GDALDataset::ToHandle(dataset.get()), gdal);
    Classes classes;
    if (!readClasses(*dataset, *net, tile, classes))
        return Error{name, "cannot be read: " + gdal.firstError(), "check the file"};
    CoverMap map = mapOf(classes, *net, table, tile);
    if (std::all_of(map.kinds.begin(), map.kinds.end(),
                    [](GroundKind kind) { return kind == GroundKind::unknown; }))
        return Error{name,
                     map.unknownCodes.empty()
                         ? "covers nothing of the terrain"
                         : "has no class that its table knows: it has " +
                               std::to_string(map.unknownCodes.begin()->first) + " and others",
                     "give a land cover of the same place, and its table with land_cover_classes"};
    map.notes = gdal.notes();
    return map;
}

std::string bytesOf(const CoverMap& map)
{
    std::string bytes;
    foundation::appendValue(bytes, std::array{map.width, map.height});
    foundation::appendValues(bytes, map.kinds);
    foundation::appendValue(bytes, static_cast<std::uint64_t>(map.unknownCodes.size()));
    for (const auto& [code, count] : map.unknownCodes)
        foundation::appendValue(
            bytes, std::array{static_cast<std::int64_t>(code), static_cast<std::int64_t>(count)});
    foundation::appendTexts(bytes, map.notes);
    return bytes;
}

/// Absent: bytesOf() did not write them.
std::optional<CoverMap> coverIn(std::string_view bytes)
{
    CoverMap map;
    foundation::ValueTaker taker(bytes);
    std::array<int, 2> sides{};
    std::uint64_t count = 0;
    if (!taker.take(sides) || !taker.take(map.kinds) || !taker.takeCount(count, 16)) return std::nullopt;
    map.width = sides[0];
    map.height = sides[1];
    if (map.width < 2 || map.height < 2 || map.width > kMaxCoverSide || map.height > kMaxCoverSide ||
        map.kinds.size() != static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height))
        return std::nullopt;
    for (const GroundKind kind : map.kinds)
        if (static_cast<int>(kind) >= kGroundKinds) return std::nullopt;
    std::array<std::int64_t, 2> unknown{};
    for (; count > 0; --count)
    {
        if (!taker.take(unknown)) return std::nullopt;
        map.unknownCodes.emplace(static_cast<int>(unknown[0]), static_cast<std::size_t>(unknown[1]));
    }
    return taker.take(map.notes) && taker.isEmpty() ? std::optional(std::move(map)) : std::nullopt;
}

} // namespace

Result<CoverMap> importCover(const std::filesystem::path& file, const CoverTable& table,
                             const PlacedTile& tile, const foundation::KeptFrom& kept)
{
    foundation::ContentMark codes;
    for (const auto& [code, kind] : table)
        codes.addWord(static_cast<std::uint64_t>(code)).addWord(static_cast<std::uint64_t>(kind));
    return kept.findOrRead(
        "cover", file, codes, coverIn, [&] { return readCover(file, table, tile); },
        [](const CoverMap& map) { return bytesOf(map); });
}

} // namespace osgTerrainROAM::core
