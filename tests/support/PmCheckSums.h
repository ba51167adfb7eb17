// SPDX-License-Identifier: Apache-2.0
// Damage that check sums do not tell: they are made anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <zlib.h>

namespace testsupport
{

/// Gives every section of a `.pm` file the check sum of what it holds now, as far as its lengths lead.
inline void renewCheckSums(std::string& file)
{
    constexpr std::size_t kHead = 12, kFirst = 12;
    for (std::size_t at = kFirst; at + kHead + 4 <= file.size();)
    {
        std::uint64_t length = 0;
        for (int i = 7; i >= 0; --i)
            length = length << 8 | static_cast<unsigned char>(file[at + 4 + i]);
        if (length > file.size() - at - kHead - 4) return;
        const std::size_t end = at + kHead + length;
        const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(file.data() + at), end - at);
        for (int i = 0; i < 4; ++i)
            file[end + i] = static_cast<char>(sum >> (8 * i));
        at = end + 4;
    }
}

} // namespace testsupport
