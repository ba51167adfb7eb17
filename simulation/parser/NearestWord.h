// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace simulation
{

/// Returns the number of letters to insert, remove, replace or swap with their neighbour to turn one word
/// into the other; case does not count. Source: Damerau, "A technique for computer detection and correction
/// of spelling errors", 1964 (restricted to neighbours that are swapped once). Cost: the product of the
/// lengths.
std::size_t wordDistance(std::string_view left, std::string_view right);

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

} // namespace simulation
