// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: its seeds and seeded mutations of them, the same in every run.
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "worldmaking/map/ReadOsm.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

/// Puts another value for an attribute, or cuts a piece out.
void mutate(std::string& text, std::mt19937& random)
{
    static const std::vector<std::string> values = {"0",          "-1",
                                                    "1e308",      "nan",
                                                    "42.5",       "1.5",
                                                    "90",         "180",
                                                    "9999",       "",
                                                    "bridge",     "yes",
                                                    "highway",    "motorway",
                                                    "1",          "2",
                                                    "3",          "12",
                                                    "-12",        "only_straight_on",
                                                    "delete",     "false",
                                                    "reversible", "2;3",
                                                    "72'",        "lanes:both_ways",
                                                    "busway",     "opposite_lane",
                                                    "DE:",        "~"};
    if (random() % 8 == 0)
    {
        text.erase(random() % text.size(), random() % 60);
        return;
    }
    const std::size_t open = text.find("=\"", random() % text.size());
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 2);
    if (close != std::string::npos)
        text.replace(open + 2, close - open - 2, values[random() % values.size()]);
}

TEST(OsmReplay, SeedsAndMutationsNeitherCrashNorHang)
{
    std::mt19937 random(5);
    std::size_t readable = 0;
    std::vector<std::string> seeds;
    for (const char* name : {"village.osm", "josm.osm"})
    {
        seeds.push_back(
            testsupport::bytesOf(std::string(OSGTRAINER_SOURCE_DIR) + "/tests/fuzz/corpus/" + name));
        ASSERT_TRUE(worldmaking::parseOsm(seeds.back(), "osm", "seed")) << name;
    }
    for (std::size_t i = 0; i < 1000; ++i)
    {
        std::string text = seeds[i % seeds.size()];
        for (unsigned edit = 0; edit < 1 + static_cast<unsigned>(i % 4); ++edit)
            mutate(text, random);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
        readable += worldmaking::parseOsm(text, "osm", "mutation") ? 1 : 0;
    }
    EXPECT_GE(readable, 300u) << "mutations that are not read test nothing behind the parser";
}

} // namespace
