// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <random>
#include <string>

namespace testsupport
{

/// Returns a vehicle's file with one to three numbers, within quotes or in a table, replaced by odd ones.
inline std::string mutatedVehicleFile(std::string text, std::mt19937& random)
{
    constexpr std::array<const char*, 10> kNumbers{"0",    "-1",  "1e9",    "1e-9", "1",
                                                   "1000", "nan", "-1e308", "",     "0.5"};
    const int edits = 1 + static_cast<int>(random() % 3U);
    for (int edit = 0; edit < edits; ++edit)
    {
        const char* const ends = random() % 4U == 0U ? " \n<" : "\"";
        const std::size_t from = text.find_first_of("0123456789", random() % text.size());
        if (from == std::string::npos) continue;
        const std::size_t to = text.find_first_of(ends, from);
        if (to == std::string::npos || to - from > 20) continue;
        text.replace(from, to - from, kNumbers[random() % kNumbers.size()]);
    }
    return text;
}

} // namespace testsupport
