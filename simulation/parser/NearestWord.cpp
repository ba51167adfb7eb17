// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/NearestWord.h"

#include <algorithm>
#include <vector>

namespace simulation
{
namespace
{

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::size_t wordDistance(std::string_view left, std::string_view right)
{
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

} // namespace simulation
