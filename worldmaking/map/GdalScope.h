// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <cpl_conv.h>
#include <foundation/GdalMessages.h>
#include <gdal_priv.h>

namespace worldmaking
{

struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// A scope in which GDAL knows its drivers, and tells its errors and warnings to this object instead of
/// stderr.
class GdalScope : public foundation::GdalMessages
{
public:
    GdalScope()
    {
        static const bool isRegistered = (GDALAllRegister(), true); // it looks for all drivers each time
        (void)isRegistered;
    }
};

} // namespace worldmaking
