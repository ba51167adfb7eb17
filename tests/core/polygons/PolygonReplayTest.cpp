// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the seeds of polygons and seeded mutations of them, the same in every
// run.
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

void give(const std::string& text)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

void replay(const std::string& name, const std::string& letters)
{
    std::ifstream stream(OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus/" + name, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    ASSERT_FALSE(text.empty()) << name;
    give(text);
    std::mt19937 random(5);
    const auto below = [&](std::size_t count) { return random() % count; };
    for (int round = 0; round < 1500; ++round)
    {
        std::string changed = text;
        for (std::size_t changes = 1 + below(3); changes > 0 && !changed.empty(); --changes)
        {
            const std::size_t at = below(changed.size());
            if (below(3) == 0)
                changed.erase(at, below(12));
            else
                changed[at] = letters[below(letters.size())];
        }
        give(changed);
    }
}

TEST(PolygonFuzzer, FindsNothingInItsSeedsAndMutations)
{
    replay("faces.obj", "0123456789-./ \nevtf\\");
    replay("frame.geojson", "{}[]\",:-.0123456789e");
}

} // namespace
