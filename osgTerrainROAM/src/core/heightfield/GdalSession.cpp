// SPDX-License-Identifier: Apache-2.0
#include "GdalSession.h"

#include <algorithm>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Returns a message without line ends, and without dots and spaces at its own end.
std::string onOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
        text.pop_back();
    return text;
}

} // namespace

GdalSession::GdalSession()
{
    setOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");
    setOption("GDAL_PAM_ENABLED", "NO");
    setOption("GTIFF_REPORT_COMPD_CS", "YES");
    setOption("GTIFF_HONOUR_NEGATIVE_SCALEY", "YES"); // by default GDAL takes such a file for north-up
    CPLPushErrorHandlerEx(
        [](CPLErr severity, CPLErrorNum, const char* message)
        {
            auto* const session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
            if (severity >= CE_Failure) session->record(message);
            if (severity == CE_Warning) session->note("GDAL warns: " + onOneLine(message));
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
    _firstError = onOneLine(message);
    if (_firstError.empty()) _firstError = "GDAL gave no reason";
}

void GdalSession::note(const std::string& text)
{
    std::string line = _file.empty() ? text : _file + ": " + text;
    if (_notes.size() < kMostNotes && std::find(_notes.begin(), _notes.end(), line) == _notes.end())
        _notes.push_back(std::move(line));
}

} // namespace osgTerrainROAM::core
