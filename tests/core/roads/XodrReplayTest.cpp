// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: its seeds and seeded mutations of them, the same in every run.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutationsOfSeed = 1000;

std::vector<std::string> seeds()
{
    std::vector<std::string> texts;
    for (const char* name : {"bend.xodr", "curves.xodr", "junction.xodr", "latin.xodr", "things.xodr"})
    {
        std::ifstream stream(std::filesystem::path(OSGTRAINER_SOURCE_DIR) / "tests/fuzz/corpus" / name);
        texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// Puts another value for an attribute, so that what lies behind the XML is reached, or cuts a piece out.
void mutate(std::string& text, std::mt19937& random)
{
    static const std::vector<std::string> values = {"0",     "-1",  "1e308", "1e-308", "nan", "1e12",
                                                    "-1e12", "1e6", "0.1",   "1000",   "-4",  "7",
                                                    "",      "1",   "2",     "end",    "LHT", "junction"};
    if (random() % 8 == 0)
    {
        const std::size_t at = random() % text.size();
        text.erase(at, random() % 60);
        return;
    }
    const std::size_t open = text.find("=\"", random() % text.size());
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 2);
    if (close != std::string::npos)
        text.replace(open + 2, close - open - 2, values[random() % values.size()]);
}

TEST(XodrReplay, SeedsAndMutationsNeitherCrashNorHang)
{
    std::mt19937 random(3);
    std::size_t readable = 0;
    for (const std::string& seed : seeds())
    {
        ASSERT_TRUE(osgRoads::core::parseNetwork(seed, "seed"));
        for (int i = 0; i < kMutationsOfSeed; ++i)
        {
            std::string text = seed;
            for (unsigned edit = 0; edit < 1 + static_cast<unsigned>(i % 3); ++edit)
                mutate(text, random);
            LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
            if (osgRoads::core::parseNetwork(text, "mutation")) ++readable;
        }
    }
    EXPECT_GE(readable, 1000u) << "mutations that are not read test nothing behind the parser";
}

} // namespace
