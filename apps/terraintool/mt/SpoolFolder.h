// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <system_error>

#include <malloc.h>

namespace terraintool
{

/// A folder beside the output that is removed in the end, and when the program starts again after a kill.
class SpoolFolder
{
public:
    explicit SpoolFolder(const std::filesystem::path& output) : _folder(output)
    {
        _folder += ".spool";
        std::error_code ignored;
        std::filesystem::create_directories(_folder, ignored); // the first file in it tells what is wrong
    }
    ~SpoolFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(_folder, ignored);
    }
    SpoolFolder(const SpoolFolder&) = delete;
    SpoolFolder& operator=(const SpoolFolder&) = delete;

    const std::filesystem::path& path() const { return _folder; }

private:
    std::filesystem::path _folder;
};

/// Gives freed memory back at once, so that what is resident is what is used.
inline void keepHeapSmall()
{
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
    mallopt(M_TRIM_THRESHOLD, 1 << 20);
    mallopt(M_ARENA_MAX, 2);
}

} // namespace terraintool
