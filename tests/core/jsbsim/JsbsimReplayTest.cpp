// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: its seeds with seeded mutations, the same in every run.
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "simulation/vehicle/jsbsim/JsbsimFile.h"
#include "simulation/vehicle/jsbsim/JsbsimRow.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace simulation;

std::string textOf(const std::string& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// One to three bytes changed, left out or doubled.
std::string mutatedText(std::string text, std::mt19937& random)
{
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
    for (std::size_t count = 1 + below(3); count > 0 && !text.empty(); --count)
    {
        const std::size_t at = below(text.size());
        const std::size_t kind = below(3);
        if (kind == 0) text[at] = static_cast<char>(below(256));
        if (kind == 1) text.erase(at, 1 + below(8));
        if (kind == 2) text.insert(at, text.substr(at, 1 + below(40)));
    }
    return text;
}

struct Seed
{
    const char* name;
    std::string file;
    bool (*isRead)(const std::string& text);
};

class JsbsimReplay : public testing::TestWithParam<Seed>
{
};

TEST_P(JsbsimReplay, MutationsAreReadOrRefused)
{
    constexpr int kMutations = 1500;
    const std::string text = textOf(GetParam().file);
    ASSERT_TRUE(GetParam().isRead(text));
    std::mt19937 random(20240107);
    int readable = 0;
    for (int i = 0; i < kMutations; ++i)
    {
        const std::string changed = mutatedText(text, random);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(changed.data()), changed.size());
        if (GetParam().isRead(changed)) ++readable;
    }
    EXPECT_GE(readable, kMutations / 10) << "mutations that are not read test nothing behind the reader";
    EXPECT_LT(readable, kMutations) << "mutations that are all read refuse nothing";
}

INSTANTIATE_TEST_SUITE_P(
    Seeds, JsbsimReplay,
    testing::Values(Seed{"File", OSGTRAINER_SOURCE_DIR "/data/aircraft/c172x-jsbsim.xml",
                         [](const std::string& text) { return bool(parseJsbsimAircraft(text, "seed")); }},
                    Seed{"Table", OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus/steps.jsbsim",
                         [](const std::string& text)
                         { return JsbsimTable::create(text.substr(0, text.find('\n'))).has_value(); }}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
