// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the vehicles of the tree with seeded mutations, the same in every run.
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>

#include "RoadSupport.h"
#include "VehicleMutation.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutations = 250; ///< of each vehicle

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
            const std::string changed = testsupport::mutatedVehicleFile(text, random);
            LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(changed.data()), changed.size());
            if (simulation::parseRoadVehicle(changed, "mutation")) ++readable;
        }
    }
    EXPECT_GE(readable, kMutations / 2) << "mutations that are not read test nothing behind the reader";
}

} // namespace
