// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace foundation
{

/// The hash FNV-1a of 64 bits (Fowler, Noll, Vo 1991), byte by byte: equal on every machine, so that what
/// follows from it may be kept in files and goldens. Not against forgery.
class Fnv1a
{
public:
    /// Other seeds give other hashes of the same bytes; 0 gives the published one.
    explicit constexpr Fnv1a(std::uint64_t seed = 0) : _value(0xcbf29ce484222325u ^ seed) {}

    constexpr void add(std::string_view bytes)
    {
        for (const char byte : bytes)
            addByte(static_cast<unsigned char>(byte));
    }
    /// Adds the lowest BYTES bytes of a number, the lowest first.
    constexpr void addNumber(std::uint64_t number, std::size_t bytes)
    {
        for (std::size_t i = 0; i < bytes; ++i)
            addByte(static_cast<unsigned char>(number >> (8 * i)));
    }
    constexpr std::uint64_t value() const { return _value; }
    /// 16 digits.
    std::string text() const
    {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(_value));
        return digits;
    }

private:
    constexpr void addByte(unsigned char byte) { _value = (_value ^ byte) * 0x100000001b3u; }

    std::uint64_t _value;
};

} // namespace foundation
