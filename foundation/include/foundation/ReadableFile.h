// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <foundation/Result.h>

namespace foundation
{

/// Tells whether a file can be read and is not empty; a reader then has only its contents to complain about.
/// Errors: there is no such file, it is a folder or a pipe, it cannot be opened or read, it is empty.
inline Outcome checkReadable(const std::filesystem::path& file)
{
    std::error_code failed;
    const std::filesystem::file_status status = std::filesystem::status(file, failed);
    if (status.type() == std::filesystem::file_type::not_found)
        return Error{file.string(), "there is no such file", "check its path"};
    if (is_directory(status)) return Error{file.string(), "is a folder", "name a file in it"};
    if (failed)
        return Error{file.string(), "cannot be opened: " + failed.message(),
                     "check its path and permissions"};
    if (!is_regular_file(status))
        return Error{file.string(), "is a device or a pipe", "write it to a file first"};
    const auto reason = [] { return std::generic_category().message(errno); };
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return Error{file.string(), "cannot be opened: " + reason(), "check its path and permissions"};
    stream.get();
    if (stream) return success();
    if (stream.bad() || errno != 0)
        return Error{file.string(), "cannot be read: " + reason(), "check the disk, or copy the file again"};
    return Error{file.string(), "is empty", "write or copy it again"};
}

} // namespace foundation
