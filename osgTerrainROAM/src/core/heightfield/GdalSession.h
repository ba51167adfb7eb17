// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace osgTerrainROAM::core
{

/// A scope in which GDAL, on this thread, reports errors and warnings to this object instead of stderr,
/// writes no files beside its inputs, names vertical datums, and reads south-up GeoTIFF as its specification
/// has it. The destructor restores the thread's former settings; other threads are not affected.
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

    /// Names the file that is read from here on, for notes.
    void setFile(std::string name) { _file = std::move(name); }

    /// What GDAL has warned of, each once, with the file and on one line; at most kMostNotes.
    const std::vector<std::string>& notes() const { return _notes; }

    /// Adds a note on the file, unless it is there.
    void note(const std::string& text);

    static constexpr std::size_t kMostNotes = 8;

private:
    void setOption(const char* name, const char* value);
    void record(const char* message);

    std::string _file, _firstError;
    std::vector<std::string> _notes;
    std::vector<std::pair<std::string, std::string>> _formerOptions; ///< empty value: was unset
};

} // namespace osgTerrainROAM::core
