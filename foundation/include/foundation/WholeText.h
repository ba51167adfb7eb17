// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <foundation/ReadableFile.h>
#include <foundation/Result.h>

namespace foundation
{

/// Returns the whole text of a file. Errors: those of checkReadable(); it is larger than `mostBytes`.
inline Result<std::string> readWholeText(const std::filesystem::path& file, std::uintmax_t mostBytes)
{
    if (const auto readable = checkReadable(file); !readable) return readable.error();
    std::error_code code;
    if (std::filesystem::file_size(file, code) > mostBytes || code)
        return Error{file.string(), "is larger than " + std::to_string(mostBytes >> 20) + " MiB",
                     "shorten it"};
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace foundation
