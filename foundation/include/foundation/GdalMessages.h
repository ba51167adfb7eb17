// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <cpl_error.h>

namespace foundation
{

/// A scope in which GDAL, on this thread, tells its errors and warnings to this object instead of stderr.
/// Whoever includes this links GDAL.
/// Threads: constructed, used and destroyed on one thread; other threads are not affected.
class GdalMessages
{
public:
    GdalMessages()
    {
        CPLPushErrorHandlerEx(
            [](CPLErr severity, CPLErrorNum number, const char* message)
            {
                auto* const messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
                messages->_lacksMemory = messages->_lacksMemory || number == CPLE_OutOfMemory;
                if (severity >= CE_Failure) messages->record(message);
                if (severity == CE_Warning) messages->note("GDAL warns: " + onOneLine(message));
            },
            this);
    }
    ~GdalMessages()
    {
        CPLPopErrorHandler();
        CPLErrorReset();
    }
    GdalMessages(const GdalMessages&) = delete;
    GdalMessages& operator=(const GdalMessages&) = delete;

    /// Tells whether GDAL has reported an error (not only a warning) since the last clear().
    bool hasFailed() const { return !_firstError.empty(); }

    /// GDAL's first error since clear(), on one line; empty if there was none.
    const std::string& firstError() const { return _firstError; }

    /// Tells whether memory has been too small for something.
    bool lacksMemory() const { return _lacksMemory; }

    void clear() { _firstError.clear(); }

    /// Names the file that is read from here on, for notes.
    void setFile(std::string name) { _file = std::move(name); }

    /// What GDAL has warned of, each once, with the file and on one line; at most kMostNotes.
    const std::vector<std::string>& notes() const { return _notes; }

    /// Adds a note on the file, unless it is there.
    void note(const std::string& text)
    {
        std::string line = _file.empty() ? text : _file + ": " + text;
        if (_notes.size() < kMostNotes && std::find(_notes.begin(), _notes.end(), line) == _notes.end())
            _notes.push_back(std::move(line));
    }

    static constexpr std::size_t kMostNotes = 8;

private:
    /// Returns a message without line ends, and without dots and spaces at its own end.
    static std::string onOneLine(std::string text)
    {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
            text.pop_back();
        return text;
    }

    void record(const char* message)
    {
        if (hasFailed()) return;
        _firstError = onOneLine(message);
        if (_firstError.empty()) _firstError = "GDAL gave no reason";
    }

    std::string _file, _firstError;
    std::vector<std::string> _notes;
    bool _lacksMemory = false;
};

} // namespace foundation
