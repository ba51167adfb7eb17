// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <gdal_priv.h>

namespace osgTerrainROAM::core
{

/// Closes a dataset of GDAL.
struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

} // namespace osgTerrainROAM::core
