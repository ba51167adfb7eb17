// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace foundation
{

/// Appends bytes in a shorter form where many of them are 0: runs of words of eight bytes that are 0 are
/// counted, the others follow as they are.
/// Form: [words that are 0, words that follow] as two numbers of 32 bits, those words, and so on until all
/// words are told; then the last bytes.
inline void appendZeroRuns(std::string& to, std::string_view bytes)
{
    constexpr std::size_t kWord = 8;
    const std::size_t words = bytes.size() / kWord;
    const auto isZero = [&](std::size_t i)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i * kWord, kWord);
        return word == 0;
    };
    constexpr std::size_t kMost = 1U << 31;
    for (std::size_t i = 0; i < words;)
    {
        const std::size_t begin = i;
        while (i < words && i - begin < kMost && isZero(i))
            ++i;
        const std::size_t first = i;
        while (i < words && i - first < kMost && !(isZero(i) && (i + 1 == words || isZero(i + 1))))
            ++i;
        const std::uint32_t counts[2]{static_cast<std::uint32_t>(first - begin),
                                      static_cast<std::uint32_t>(i - first)};
        to.append(reinterpret_cast<const char*>(counts), sizeof counts);
        to += bytes.substr(first * kWord, (i - first) * kWord);
    }
    to += bytes.substr(words * kWord);
}

/// Writes `size` bytes that appendZeroRuns() was given. False: `text` is not what it appended for so many;
/// `to` holds something then.
inline bool readZeroRuns(std::string_view text, char* to, std::size_t size)
{
    constexpr std::size_t kWord = 8;
    std::size_t words = size / kWord;
    while (words > 0)
    {
        std::uint32_t counts[2];
        if (text.size() < sizeof counts) return false;
        std::memcpy(counts, text.data(), sizeof counts);
        text.remove_prefix(sizeof counts);
        const std::size_t zeros = counts[0], others = counts[1];
        if (zeros + others == 0 || zeros + others > words || others * kWord > text.size()) return false;
        std::memset(to, 0, zeros * kWord);
        to += zeros * kWord;
        std::memcpy(to, text.data(), others * kWord);
        to += others * kWord;
        text.remove_prefix(others * kWord);
        words -= zeros + others;
    }
    if (text.size() != size % kWord) return false;
    if (!text.empty()) std::memcpy(to, text.data(), text.size());
    return true;
}

} // namespace foundation
