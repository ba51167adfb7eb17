// SPDX-License-Identifier: Apache-2.0
#include "GdalSession.h"

#include <cpl_conv.h>
#include <gdal.h>

namespace osgTerrainROAM::core
{

GdalSession::GdalSession()
{
    setOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");
    setOption("GDAL_PAM_ENABLED", "NO");
    setOption("GTIFF_REPORT_COMPD_CS", "YES");
    setOption("GTIFF_HONOUR_NEGATIVE_SCALEY", "YES"); // by default GDAL takes such a file for north-up
    GDALAllRegister();                                // does nothing when done before
}

GdalSession::~GdalSession()
{
    for (const auto& [name, value] : _formerOptions)
        CPLSetThreadLocalConfigOption(name.c_str(), value.empty() ? nullptr : value.c_str());
}

void GdalSession::setOption(const char* name, const char* value)
{
    const char* former = CPLGetThreadLocalConfigOption(name, nullptr);
    _formerOptions.emplace_back(name, former ? former : "");
    CPLSetThreadLocalConfigOption(name, value);
}

} // namespace osgTerrainROAM::core
