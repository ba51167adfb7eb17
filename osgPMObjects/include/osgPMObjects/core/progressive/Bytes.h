// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace osgPMObjects::core
{

/// Appends a number in few bytes: seven bits a byte, the lowest first; the top bit tells that more bytes
/// follow.
inline void appendNumber(std::vector<std::byte>& bytes, std::uint64_t number)
{
    for (; number >= 0x80; number >>= 7)
        bytes.push_back(static_cast<std::byte>(number | 0x80));
    bytes.push_back(static_cast<std::byte>(number));
}

/// Appends a signed number so that small ones of either sign take one byte: the sign becomes the lowest bit.
inline void appendDifference(std::vector<std::byte>& bytes, std::int64_t difference)
{
    appendNumber(bytes, (static_cast<std::uint64_t>(difference) << 1) ^
                            static_cast<std::uint64_t>(difference >> 63));
}

/// Appends a number in `width` bytes, the lowest first.
inline void appendFixed(std::vector<std::byte>& bytes, std::uint64_t number, int width)
{
    for (int i = 0; i < width; ++i)
        bytes.push_back(static_cast<std::byte>(number >> (8 * i)));
}

/// Returns the bytes that numbers below `count` need.
inline int widthFor(std::uint64_t count)
{
    return count <= 0x100 ? 1 : count <= 0x10000 ? 2 : count <= 0x1000000 ? 3 : 4;
}

/// The width of numbers with a fixed number of bytes.
struct FixedWidth
{
    int bytes;
    std::uint32_t mask;

    explicit FixedWidth(int width) : bytes(width), mask(~0u >> (32 - 8 * width)) {}
};

/// Reads what the functions above have appended. It does not check: isValid() checks records from files as a
/// whole before.
class ByteReader
{
public:
    explicit ByteReader(const std::byte* at) : _at(at) {}

    std::uint32_t byte() { return static_cast<std::uint32_t>(*_at++); }

    std::uint32_t number()
    {
        std::uint32_t value = byte();
        if (value < 0x80) [[likely]]
            return value;
        value &= 0x7f;
        for (int shift = 7;; shift += 7)
        {
            const std::uint32_t next = byte();
            value |= (next & 0x7f) << shift;
            if (next < 0x80) return value;
        }
    }

    std::int32_t difference()
    {
        const std::uint32_t value = number();
        return static_cast<std::int32_t>(value >> 1) ^ -static_cast<std::int32_t>(value & 1);
    }

    /// Reads a number of fixed width. Four bytes must be readable, whatever the width.
    std::uint32_t fixed(const FixedWidth& width)
    {
        std::uint32_t value = 0;
        std::memcpy(&value, _at, sizeof value);
        if constexpr (std::endian::native == std::endian::big) value = __builtin_bswap32(value);
        _at += width.bytes;
        return value & width.mask;
    }

    void skip(int bytes) { _at += bytes; }
    const std::byte* at() const { return _at; }

private:
    const std::byte* _at;
};

} // namespace osgPMObjects::core
