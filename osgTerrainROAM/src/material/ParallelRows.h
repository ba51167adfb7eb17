// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>

#include <foundation/Threads.h>

namespace osgTerrainROAM
{

/// Calls work(firstRow, endRow) on bands of rows from several threads and returns when all bands are done.
/// Each row belongs to one band, so results that are computed row by row do not depend on the number of
/// threads.
/// Errors: the first exception of a band is thrown again here, after all have ended.
inline void parallelRows(int rows, const std::function<void(int, int)>& work)
{
    const int bands = std::clamp(static_cast<int>(foundation::processors()), 1, 8);
    if (rows < 64 || bands == 1) return work(0, rows);
    foundation::Threads threads;
    for (int band = 0; band < bands; ++band)
        threads.run(
            [&work, rows, band, bands]
            {
                work(static_cast<int>(static_cast<long long>(rows) * band / bands),
                     static_cast<int>(static_cast<long long>(rows) * (band + 1) / bands));
            });
    threads.join();
}

} // namespace osgTerrainROAM
