// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace testsupport
{

/// Swaps the first two entries of a little-endian TIFF's directory, of which GDAL warns.
inline void unsortTags(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::uint32_t directory = 0;
    std::memcpy(&directory, bytes.data() + 4, sizeof directory);
    std::swap_ranges(bytes.begin() + directory + 2, bytes.begin() + directory + 14,
                     bytes.begin() + directory + 14);
    std::ofstream(file, std::ios::binary) << bytes;
}

} // namespace testsupport
