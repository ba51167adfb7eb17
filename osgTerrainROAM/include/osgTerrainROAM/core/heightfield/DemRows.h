// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/GridPlace.h>

namespace osgTerrainROAM::core
{

/// An elevation raster that is read row by row, for data that do not fit into memory. Samples and spacing are
/// those of importDem(), but voids stay voids.
/// Threads: constructed, used and destroyed on one thread. Memory: some rows, at most 4 MB, and a cache of
/// GDAL's of 8 MB.
class DemRows
{
public:
    /// Errors: those of importDem(); a GRASS ASCII grid, whose nulls GDAL does not tell.
    static foundation::Result<DemRows> open(const std::filesystem::path& file,
                                            const DemImportOptions& options);

    ~DemRows();
    DemRows(DemRows&&) noexcept;

    int columns() const;
    int rows() const;
    double spacingEastM() const;
    double spacingNorthM() const;
    const std::optional<GridPlace>& place() const; ///< absent: no georeference

    /// Reads a row into heightsM, metres, voids NaN. `row`: 0 is the southernmost. Rows one after the other
    /// are cheapest.
    /// Errors: truncated or damaged.
    foundation::Outcome read(int row, std::span<float> heightsM);

private:
    struct State;
    explicit DemRows(std::unique_ptr<State> state);

    std::unique_ptr<State> _state;
};

} // namespace osgTerrainROAM::core
