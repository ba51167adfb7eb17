// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
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
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    if (size > mostBytes || code)
        return Error{file.string(), "is larger than " + std::to_string(mostBytes >> 20) + " MiB",
                     "shorten it"};
    std::string text(static_cast<std::size_t>(size), '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount())); // it may have become shorter
    return text;
}

} // namespace foundation
