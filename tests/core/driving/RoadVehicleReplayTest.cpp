// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the vehicles of the tree with seeded mutations, the same in every run.
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>

#include "RoadSupport.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutations = 250; ///< of each vehicle

constexpr std::array<const char*, 10> kNumbers{"0",    "-1",  "1e9",    "1e-9", "1",
                                               "1000", "nan", "-1e308", "",     "0.5"};

/// Puts a number for a number, within quotes or in a table.
std::string mutatedVehicle(std::string text, std::mt19937& random)
{
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

TEST(RoadVehicleReplay, MutationsDriveOrAreRefused)
{
    std::mt19937 random(20240103);
    int readable = 0;
    for (const char* const name : testsupport::kVehicleNames)
    {
        std::ifstream stream(testsupport::vehicleFile(name));
        const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        for (int i = 0; i < kMutations; ++i)
        {
            const std::string changed = mutatedVehicle(text, random);
            LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(changed.data()), changed.size());
            if (simulation::parseRoadVehicle(changed, "mutation")) ++readable;
        }
    }
    EXPECT_GE(readable, kMutations / 2) << "mutations that are not read test nothing behind the reader";
}

} // namespace
