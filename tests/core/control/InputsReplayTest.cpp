// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: a file of inputs with seeded mutations, the same in every run.
#include <array>
#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutations = 20'000;
constexpr std::array kPieces{
    "\n",  " ", "-", "#",  "1e308", "ramped\n", "rate 120\n", "end 7\n", "columns step a\n",
    "nan", "0", "9", "\t", "."};

TEST(InputsReplay, MutationsAreReadBackOrRefused)
{
    const std::string sound = "osgtrainer-inputs 1\nrate 120\nramped\ncolumns step elevator throttle\n0 0 "
                              "-\n7 -0.5 1\n9 - 0\nend 12\n";
    std::mt19937 random(1);
    for (int i = 0; i < kMutations; ++i)
    {
        std::string text = sound;
        for (unsigned edits = random() % 4U; edits > 0; --edits)
            text.replace(random() % text.size(), random() % 4U, kPieces[random() % kPieces.size()]);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
}

} // namespace
