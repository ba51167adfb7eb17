// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foundation
{

/// Returns the number of letters to insert, remove, replace or swap with their neighbour to turn one word
/// into the other; case does not count. Source: Damerau, "A technique for computer detection and correction
/// of spelling errors", 1964 (restricted to neighbours that are swapped once). Cost: the product of the
/// lengths.
inline std::size_t wordDistance(std::string_view left, std::string_view right)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    // Rows of the table of distances between beginnings: the one before the last, the last, the present one.
    std::vector<std::size_t> older(right.size() + 1), old(right.size() + 1), now(right.size() + 1);
    for (std::size_t j = 0; j <= right.size(); ++j)
        old[j] = j;
    for (std::size_t i = 1; i <= left.size(); ++i)
    {
        now[0] = i;
        for (std::size_t j = 1; j <= right.size(); ++j)
        {
            const bool same = lower(left[i - 1]) == lower(right[j - 1]);
            now[j] = std::min({old[j] + 1, now[j - 1] + 1, old[j - 1] + (same ? 0u : 1u)});
            const bool swapped = i > 1 && j > 1 && lower(left[i - 1]) == lower(right[j - 2]) &&
                                 lower(left[i - 2]) == lower(right[j - 1]);
            if (swapped) now[j] = std::min(now[j], older[j - 2] + 1);
        }
        std::swap(older, old);
        std::swap(old, now);
    }
    return old[right.size()];
}

/// Returns the word of a range that is most like a misspelt one: at most a third of its letters differ. The
/// first of several.
template<class Range, class Name>
std::optional<std::string_view> nearestWord(std::string_view misspelt, const Range& range, Name name)
{
    std::optional<std::string_view> nearest;
    std::size_t least = misspelt.size() / 3 + 1;
    if (misspelt.size() > 64) return nearest;
    for (const auto& candidate : range)
    {
        const std::string_view word = name(candidate);
        if (word.size() > misspelt.size() + least || misspelt.size() > word.size() + least) continue;
        const std::size_t distance = wordDistance(misspelt, word);
        if (distance >= least) continue;
        least = distance;
        nearest = word;
    }
    return nearest;
}

/// The remedy for an unknown name: "did you mean X?", where a word of the range is like it, else `otherwise`.
template<class Range>
requires(!std::convertible_to<const Range&, std::string_view>) std::string
    didYouMean(std::string_view misspelt, const Range& words, const std::string& otherwise)
{
    const auto like = nearestWord(misspelt, words, [](const auto& word) { return std::string_view(word); });
    return like ? "did you mean " + std::string(*like) + "?" : otherwise;
}

/// The same among words that blanks part.
inline std::string didYouMean(std::string_view misspelt, std::string_view words, const std::string& otherwise)
{
    std::vector<std::string_view> list;
    for (std::size_t begin = 0; begin < words.size();)
    {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        if (end > begin) list.push_back(words.substr(begin, end - begin));
        begin = end + 1;
    }
    return didYouMean(misspelt, list, otherwise);
}

} // namespace foundation
