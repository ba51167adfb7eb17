// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <foundation/Random.h>

namespace foundation
{

/// A mark of 128 bits of what it was given, piece by piece: two sums of eight bytes at a time. It tells
/// contents apart that differ by chance, not by malice. Source: Fowler, Noll & Vo, FNV-1a; differs: eight
/// bytes a step, and each step shifts upper bits down.
class ContentMark
{
public:
    ContentMark& add(std::string_view bytes)
    {
        addWord(bytes.size());
        const char* const end = bytes.data() + bytes.size();
        const char* at = bytes.data();
        std::uint64_t word = 0;
        for (; end - at >= static_cast<std::ptrdiff_t>(sizeof(word)); at += sizeof(word))
        {
            std::memcpy(&word, at, sizeof(word));
            addWord(word);
        }
        if (at == end) return *this;
        word = 0;
        std::memcpy(&word, at, static_cast<std::size_t>(end - at));
        return addWord(word);
    }

    /// The values must have no bytes between their members.
    template<class Value>
    requires(std::is_trivially_copyable_v<Value> &&
             !std::is_same_v<Value, bool>) ContentMark& add(const std::vector<Value>& values)
    {
        return add(
            std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)));
    }

    ContentMark& addWord(std::uint64_t word)
    {
        _sums[0] = mixed(_sums[0] ^ word, 0x100000001b3ULL);
        _sums[1] = mixed(_sums[1] ^ (word >> 32 | word << 32), SplitMix64::kStep);
        return *this;
    }

    /// 32 digits.
    std::string text() const
    {
        char digits[33];
        std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(_sums[0]),
                      static_cast<unsigned long long>(_sums[1]));
        return digits;
    }

    bool operator==(const ContentMark&) const = default;

private:
    static std::uint64_t mixed(std::uint64_t sum, std::uint64_t factor)
    {
        sum *= factor;
        return sum ^ sum >> 32;
    }

    std::array<std::uint64_t, 2> _sums{0xcbf29ce484222325ULL, 0x6c62272e07bb0142ULL};
};

} // namespace foundation
