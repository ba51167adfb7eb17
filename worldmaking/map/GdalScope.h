// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

namespace worldmaking
{

struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// A scope in which GDAL, on this thread, tells its errors to this object instead of stderr.
class GdalScope
{
public:
    GdalScope()
    {
        static const bool isRegistered = (GDALAllRegister(), true); // it looks for all drivers each time
        (void)isRegistered;
        CPLPushErrorHandlerEx(
            [](CPLErr severity, CPLErrorNum number, const char* message)
            {
                auto* const scope = static_cast<GdalScope*>(CPLGetErrorHandlerUserData());
                scope->lacksMemory = scope->lacksMemory || number == CPLE_OutOfMemory;
                if (severity < CE_Failure || !scope->firstError.empty()) return;
                scope->firstError = message;
                std::replace(scope->firstError.begin(), scope->firstError.end(), '\n', ' ');
                while (scope->firstError.ends_with('.'))
                    scope->firstError.pop_back();
            },
            this);
    }
    ~GdalScope() { CPLPopErrorHandler(); }
    GdalScope(const GdalScope&) = delete;
    GdalScope& operator=(const GdalScope&) = delete;

    std::string firstError; ///< on one line; empty: none so far
    bool lacksMemory = false;
};

} // namespace worldmaking
