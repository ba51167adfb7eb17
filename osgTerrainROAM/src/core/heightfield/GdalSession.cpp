// SPDX-License-Identifier: Apache-2.0
#include "GdalSession.h"

#include <algorithm>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

namespace osgTerrainROAM::core
{

GdalSession::GdalSession()
{
    setOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");
    setOption("GDAL_PAM_ENABLED", "NO");
    setOption("GTIFF_REPORT_COMPD_CS", "YES");
    CPLPushErrorHandlerEx(
        [](CPLErr severity, CPLErrorNum, const char* message)
        {
            if (severity >= CE_Failure)
                static_cast<GdalSession*>(CPLGetErrorHandlerUserData())->record(message);
        },
        this);
    GDALAllRegister(); // does nothing when done before
}

GdalSession::~GdalSession()
{
    CPLPopErrorHandler();
    CPLErrorReset();
    for (const auto& [name, value] : _formerOptions)
        CPLSetThreadLocalConfigOption(name.c_str(), value.empty() ? nullptr : value.c_str());
}

void GdalSession::setOption(const char* name, const char* value)
{
    const char* former = CPLGetThreadLocalConfigOption(name, nullptr);
    _formerOptions.emplace_back(name, former ? former : "");
    CPLSetThreadLocalConfigOption(name, value);
}

void GdalSession::record(const char* message)
{
    if (hasFailed()) return;
    _firstError = message;
    std::replace_if(
        _firstError.begin(), _firstError.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    while (!_firstError.empty() && (_firstError.back() == ' ' || _firstError.back() == '.'))
        _firstError.pop_back();
    if (_firstError.empty()) _firstError = "GDAL gave no reason";
}

} // namespace osgTerrainROAM::core
