// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foundation
{

/// Appends a number in as many bytes as it has groups of 7 bits, the lowest first; all bytes but the last
/// have their highest bit set. Source: DWARF 5, section 7.6, ULEB128.
inline void appendShort(std::string& bytes, std::uint32_t number)
{
    for (; number >= 0x80U; number >>= 7U)
        bytes.push_back(static_cast<char>(number | 0x80U));
    bytes.push_back(static_cast<char>(number));
}

/// Returns a difference, modulo 2³², as a number that is small where the difference is near 0 on either side.
inline std::uint32_t foldedDifference(std::uint32_t difference)
{
    return difference << 1U ^ (difference >> 31U ? ~0U : 0U);
}

/// The inverse of foldedDifference().
inline std::uint32_t unfoldedDifference(std::uint32_t folded)
{
    return folded >> 1U ^ (folded & 1U ? ~0U : 0U);
}

/// Takes numbers off the front of bytes that appendShort() made.
class ShortTaker
{
public:
    explicit ShortTaker(std::string_view bytes) : _next(bytes.data()), _end(bytes.data() + bytes.size()) {}

    /// False: there is no whole number.
    bool take(std::uint32_t& number)
    {
        number = 0;
        for (unsigned shift = 0; _next != _end && shift < 35; shift += 7)
        {
            const auto byte = static_cast<unsigned char>(*_next++);
            number |= static_cast<std::uint32_t>(byte & 0x7FU) << shift;
            if (byte < 0x80U) return true;
        }
        return false;
    }

    bool isEmpty() const { return _next == _end; }

private:
    const char *_next, *_end;
};

} // namespace foundation
