// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace osgTerrainROAM::core
{

/// While it lives, GDAL on this thread reports to it instead of to stderr, writes nothing beside its inputs,
/// and names vertical datums. What the thread had set before comes back with the destructor; other threads
/// notice nothing.
/// Threads: lives and dies on one thread.
class GdalSession
{
public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// Has GDAL reported an error (not merely a warning) since the last clear()?
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
