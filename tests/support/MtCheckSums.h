// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include <zlib.h>

namespace testsupport
{

/// Makes the check sums of a .mt file right again after bytes were changed, those of its trees, its directory
/// and its header (docs/reference/mt-file.md). What does not lie in the file is left out.
inline void renewMtCheckSums(std::string& bytes)
{
    constexpr std::size_t kHeader = 80, kEntry = 56;
    const auto sumOf = [&](std::size_t first, std::size_t count)
    {
        return static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + first), static_cast<uInt>(count)));
    };
    const auto put = [&](std::size_t at, std::uint32_t sum)
    { std::memcpy(bytes.data() + at, &sum, sizeof sum); };
    if (bytes.size() < kHeader) return;
    std::uint32_t trees = 0;
    std::memcpy(&trees, bytes.data() + 12, sizeof trees);
    if (trees > (bytes.size() - kHeader) / kEntry) return;
    for (std::size_t entry = kHeader; entry < kHeader + trees * kEntry; entry += kEntry)
    {
        std::uint64_t first = 0;
        std::uint32_t count = 0;
        std::memcpy(&first, bytes.data() + entry, sizeof first);
        std::memcpy(&count, bytes.data() + entry + 8, sizeof count);
        if (first <= bytes.size() && count <= bytes.size() - first) put(entry + 12, sumOf(first, count));
    }
    put(72, sumOf(kHeader, trees * kEntry));
    put(76, sumOf(0, 76));
}

} // namespace testsupport
