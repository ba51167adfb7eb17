// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <zlib.h>

namespace testsupport
{

/// The CRC-32 of bytes.
inline std::uint32_t sumOf(std::string_view bytes)
{
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Makes the check sums of a .mt file right again after bytes were changed, those of the sections of its
/// trees, of its directory, its reference and its header (docs/reference/mt-file.md). What does not lie in
/// the file is left out.
inline void renewMtCheckSums(std::string& bytes)
{
    constexpr std::size_t kHeader = 80, kEntry = 56, kReference = 36;
    const auto sumIn = [&](std::size_t first, std::size_t count)
    { return sumOf(std::string_view(bytes).substr(first, count)); };
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
        if (first > bytes.size() || count > bytes.size() - first) continue;
        std::uint32_t fragments = 0;
        std::memcpy(&fragments, bytes.data() + entry + 44, sizeof fragments);
        const std::uint64_t sections = 2 + (std::uint64_t{fragments} + 127) / 128, table = 4 + 8 * sections;
        if (table > count) continue;
        std::uint64_t at = first + table;
        for (std::uint64_t row = first + 4; row < first + table; row += 8)
        {
            std::uint32_t length = 0;
            std::memcpy(&length, bytes.data() + row, sizeof length);
            if (length > first + count - at) break;
            put(row + 4, sumIn(at, length));
            at += length;
        }
        put(entry + 12, sumIn(first, table));
    }
    const std::size_t reference = kHeader + trees * kEntry;
    std::uint32_t version = 0, text = 0;
    std::memcpy(&version, bytes.data() + 8, sizeof version);
    if (version > 2 && bytes.size() - reference >= kReference + sizeof text)
    {
        std::memcpy(&text, bytes.data() + reference, sizeof text);
        if (text <= bytes.size() - reference - kReference - sizeof text)
            put(reference + kReference + text, sumIn(reference, kReference + text));
    }
    put(72, sumIn(kHeader, trees * kEntry));
    put(76, sumIn(0, 76));
}

} // namespace testsupport
