// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the aircraft of the tree with seeded mutations, the same in every run.
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "FlightSupport.h"
#include "VehicleMutation.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutations = 500;

TEST(AircraftReplay, MutationsFlyOrAreRefused)
{
    std::ifstream stream(testsupport::kAircraftFile);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    std::mt19937 random(20240102);
    int readable = 0;
    for (int i = 0; i < kMutations; ++i)
    {
        const std::string changed = testsupport::mutatedVehicleFile(text, random);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(changed.data()), changed.size());
        if (simulation::parseAircraft(changed, "mutation")) ++readable;
    }
    EXPECT_GE(readable, kMutations / 5) << "mutations that are not read test nothing behind the reader";
}

} // namespace
