// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/heightfield/DemRows.h>

#include "PlaceField.h"
#include "RasterOrientation.h"
#include "RasterSource.h"
#include "SampleDecoder.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr GIntBig kCacheBytes = 8 << 20;
constexpr int kMostSamplesAtOnce = 1 << 19;

} // namespace

struct DemRows::State
{
    GdalSession gdal;
    RasterSource source;
    RasterTurn turn;
    HeightField field; ///< without heights
    std::optional<GridPlace> place;
    int firstRow = 0; ///< of the rows in memory, in file order
    int rowsAtOnce = 1;
    std::vector<double> window;
    std::optional<SampleDecoder> decoder;

    foundation::Outcome fetch(int fileRow);
};

DemRows::DemRows(std::unique_ptr<State> state) : _state(std::move(state)) {}
DemRows::~DemRows() = default;
DemRows::DemRows(DemRows&&) noexcept = default;

foundation::Result<DemRows> DemRows::open(const std::filesystem::path& file, const DemImportOptions& options)
{
    auto state = std::make_unique<State>();
    GDALSetCacheMax64(kCacheBytes);
    auto source = openSource(file, state->gdal);
    if (!source) return source.error();
    state->source = std::move(*source);
    if (const auto shape = checkShape(state->source); !shape) return shape.error();
    if (isDriver(state->source, "GRASSASCIIGrid"))
        return foundation::Error{file.string(), "is a GRASS ASCII grid, which has to be in memory to be read",
                                 "convert it with gdal_translate to GeoTIFF"};
    Raster raster;
    raster.columns = GDALGetRasterXSize(state->source.dataset.get());
    raster.rows = GDALGetRasterYSize(state->source.dataset.get());
    const auto turn = readOrientation(state->source.name, state->source.dataset.get(), raster);
    if (!turn) return turn.error();
    state->turn = *turn;
    if (raster.frame) raster.crsWkt = crsWktOf(state->source);
    state->field.name = file.string();
    state->field.columns = raster.columns;
    state->field.rows = raster.rows;
    if (const auto placed = placeField(state->field, raster, options, state->gdal); !placed)
        return placed.error();
    state->place = placeOf(raster);
    state->decoder.emplace(state->source, state->gdal);
    int blockColumns = 0, blockRows = 0;
    GDALGetBlockSize(state->source.band(), &blockColumns, &blockRows);
    state->rowsAtOnce = std::clamp(kMostSamplesAtOnce / raster.columns, 1, std::max(1, blockRows));
    return DemRows(std::move(state));
}

int DemRows::columns() const
{
    return _state->field.columns;
}

int DemRows::rows() const
{
    return _state->field.rows;
}

double DemRows::spacingEastM() const
{
    return _state->field.spacingEastM;
}

double DemRows::spacingNorthM() const
{
    return _state->field.spacingNorthM;
}

const std::optional<GridPlace>& DemRows::place() const
{
    return _state->place;
}

/// Reads the rows around one, by whole blocks of the file where they fit.
foundation::Outcome DemRows::State::fetch(int fileRow)
{
    firstRow = fileRow / rowsAtOnce * rowsAtOnce;
    const int count = std::min(rowsAtOnce, field.rows - firstRow);
    window.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(field.columns));
    const CPLErr result = GDALRasterIO(source.band(), GF_Read, 0, firstRow, field.columns, count,
                                       window.data(), field.columns, count, GDT_Float64, 0, 0);
    if (result == CE_None && !gdal.hasFailed()) return foundation::success();
    window.clear();
    return foundation::Error{
        source.name + ", row " + std::to_string(fileRow + 1) + " of " + std::to_string(field.rows),
        "cannot be read (" + gdal.firstError() + ")", "fetch it again: it is truncated or damaged"};
}

foundation::Outcome DemRows::read(int row, std::span<float> heightsM)
{
    State& state = *_state;
    const int fileRow = state.turn.flipsRows ? state.field.rows - 1 - row : row;
    const auto columns = static_cast<std::size_t>(state.field.columns);
    const auto isHere = [&]
    {
        return fileRow >= state.firstRow &&
               static_cast<std::size_t>(fileRow - state.firstRow) < state.window.size() / columns;
    };
    if (!isHere())
        if (const auto fetched = state.fetch(fileRow); !fetched) return fetched;
    const double* from = state.window.data() + static_cast<std::size_t>(fileRow - state.firstRow) * columns;
    for (std::size_t c = 0; c < columns; ++c)
        heightsM[c] = state.decoder->heightM(from[c]);
    if (state.turn.flipsColumns) std::reverse(heightsM.begin(), heightsM.end());
    return foundation::success();
}

} // namespace osgTerrainROAM::core
