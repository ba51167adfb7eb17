// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// A scope in which GDAL, on this thread, tells its errors and warnings to this object instead of stderr.
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
                if (severity >= CE_Failure && scope->firstError.empty())
                    scope->firstError = onOneLine(message);
                if (severity == CE_Warning) scope->addWarning(onOneLine(message));
            },
            this);
    }
    ~GdalScope() { CPLPopErrorHandler(); }
    GdalScope(const GdalScope&) = delete;
    GdalScope& operator=(const GdalScope&) = delete;

    std::string firstError; ///< on one line; empty: none so far
    bool lacksMemory = false;
    std::vector<std::string> warnings; ///< each once, on one line, at most eight

private:
    static std::string onOneLine(std::string text)
    {
        std::replace(text.begin(), text.end(), '\n', ' ');
        while (text.ends_with('.') || text.ends_with(' '))
            text.pop_back();
        return text;
    }

    void addWarning(std::string text)
    {
        constexpr std::size_t kMost = 8;
        if (warnings.size() < kMost && std::find(warnings.begin(), warnings.end(), text) == warnings.end())
            warnings.push_back(std::move(text));
    }
};

} // namespace worldmaking
