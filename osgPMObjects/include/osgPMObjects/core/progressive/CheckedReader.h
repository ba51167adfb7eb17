// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <osgPMObjects/core/progressive/Bytes.h>

namespace osgPMObjects::core
{

/// Reads like ByteReader, but never beyond the end: isGood() is false after an attempt.
class CheckedReader
{
public:
    CheckedReader(const std::byte* at, const std::byte* end) : _at(at), _end(end) {}

    std::uint32_t byte()
    {
        if (_at == _end)
        {
            _isGood = false;
            return 0;
        }
        return static_cast<std::uint32_t>(*_at++);
    }

    std::uint32_t number()
    {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 35; shift += 7)
        {
            const std::uint64_t next = byte();
            value |= (next & 0x7f) << shift;
            if (next >= 0x80) continue;
            if (value > kMost) _isGood = false;
            return _isGood ? static_cast<std::uint32_t>(value) : 0;
        }
        _isGood = false;
        return 0;
    }

    std::int32_t difference()
    {
        const std::uint32_t value = number();
        return static_cast<std::int32_t>(value >> 1) ^ -static_cast<std::int32_t>(value & 1);
    }

    std::uint32_t fixed(const FixedWidth& width)
    {
        std::uint32_t value = 0;
        for (int i = 0; i < width.bytes; ++i)
            value |= byte() << (8 * i);
        return value;
    }

    bool isGood() const { return _isGood; }
    const std::byte* at() const { return _at; }

private:
    static constexpr std::uint64_t kMost = 0x7fffffff; ///< so that the sum of two numbers does not overflow

    const std::byte* _at;
    const std::byte* _end;
    bool _isGood = true;
};

} // namespace osgPMObjects::core
