// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <foundation/GdalMessages.h>

namespace osgTerrainROAM::core
{

/// A scope in which GDAL, on this thread, reports errors and warnings to this object instead of stderr,
/// writes no files beside its inputs, names vertical datums, and reads south-up GeoTIFF as its specification
/// has it. The destructor restores the thread's former settings; other threads are not affected.
/// Threads: constructed, used and destroyed on one thread.
class GdalSession : public foundation::GdalMessages
{
public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

private:
    void setOption(const char* name, const char* value);

    std::vector<std::pair<std::string, std::string>> _formerOptions; ///< empty value: was unset
};

} // namespace osgTerrainROAM::core
