// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

/// Counts how often each file of a folder is opened, by whatever process, while it lives. The kernel counts
/// (inotify), so that the programs need nothing for it, no clock is asked, and what a child of theirs opens
/// counts, too.
class OpenedFiles
{
public:
    explicit OpenedFiles(const std::filesystem::path& folder);
    ~OpenedFiles();
    OpenedFiles(const OpenedFiles&) = delete;
    OpenedFiles& operator=(const OpenedFiles&) = delete;

    /// How often each has been opened since the last call, by name; a failed test where events were lost.
    std::map<std::string, int> take();

private:
    int _events;
};
