// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace osgTerrainROAM::core
{

/// A scope in which GDAL, on this thread, reports errors to this object instead of stderr, writes no files
/// beside its inputs, and names vertical datums. The destructor restores the thread's former settings; other
/// threads are not affected.
/// Threads: constructed, used and destroyed on one thread.
class GdalSession
{
public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// Tells whether GDAL has reported an error (not only a warning) since the last clear().
    bool hasFailed() const { return !_firstError.empty(); }

    /// GDAL's first error since clear(), on one line; empty if there was none.
    const std::string& firstError() const { return _firstError; }

    void clear() { _firstError.clear(); }

private:
    void setOption(const char* name, const char* value);
    void record(const char* message);

    std::string _firstError;
    std::vector<std::pair<std::string, std::string>> _formerOptions; ///< empty value: was unset
};

} // namespace osgTerrainROAM::core
