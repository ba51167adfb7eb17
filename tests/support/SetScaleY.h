// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace testsupport
{

/// Writes other values of two tags into a little-endian TIFF of one directory: ModelPixelScale (33550) and
/// ModelTiepoint (33922).
inline void setScaleY(const std::filesystem::path& file, double scaleY, double firstY)
{
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const auto read = [&](std::size_t place, auto value)
    {
        std::memcpy(&value, bytes.data() + place, sizeof value);
        return std::size_t{value};
    };
    const std::size_t directory = read(4, std::uint32_t{});
    for (std::size_t i = 0; i < read(directory, std::uint16_t{}); ++i)
    {
        const std::size_t entry = directory + 2 + 12 * i, tag = read(entry, std::uint16_t{}),
                          values = read(entry + 8, std::uint32_t{});
        if (tag == 33550) std::memcpy(bytes.data() + values + 8, &scaleY, sizeof scaleY);
        if (tag == 33922) std::memcpy(bytes.data() + values + 32, &firstY, sizeof firstY);
    }
    std::ofstream(file, std::ios::binary) << bytes;
}

} // namespace testsupport
