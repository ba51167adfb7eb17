// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include <foundation/ContentMark.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "TestFolder.h"

namespace testsupport
{

/// Which file each name stands for: one that was written anew is another.
inline std::map<std::string, ino_t> filesIn(const std::filesystem::path& folder)
{
    std::map<std::string, ino_t> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        struct stat about
        {
        };
        EXPECT_EQ(stat(entry.path().c_str(), &about), 0);
        files[entry.path().filename()] = about.st_ino;
    }
    return files;
}

/// Leaves the head of each file right for contents that are not.
inline void writeNonsense(const std::filesystem::path& folder)
{
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (!entry.is_regular_file()) continue;
        const std::string whole = bytesOf(entry.path());
        const std::size_t head = whole.find('\n', whole.find('\n') + 1) + 1;
        const std::string bytes = whole.substr(head, (whole.size() - head) / 2);
        const std::string text = whole.substr(0, whole.find('\n') + 1) +
                                 foundation::ContentMark().add(bytes).text() + '\n' + bytes;
        std::ofstream(entry.path(), std::ios::binary) << text;
    }
}

/// Sets where the user's cache is, for the time of a test.
class UserCache
{
public:
    explicit UserCache(const std::filesystem::path& folder)
    {
        if (const char* const before = std::getenv(kName)) _before = before;
        setenv(kName, folder.c_str(), 1);
    }
    ~UserCache() { _before ? setenv(kName, _before->c_str(), 1) : unsetenv(kName); }
    UserCache(const UserCache&) = delete;
    UserCache& operator=(const UserCache&) = delete;

private:
    static constexpr const char* kName = "XDG_CACHE_HOME";
    std::optional<std::string> _before;
};

} // namespace testsupport
