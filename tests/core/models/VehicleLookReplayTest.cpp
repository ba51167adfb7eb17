// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the corpus and seeded mutations of it, the same in every run.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "scenery/models/Dice.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

void give(const std::string& text)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

TEST(VehicleLookFuzzer, FindsNothingInItsCorpusAndMutations)
{
    for (const auto& entry : std::filesystem::directory_iterator(OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus"))
    {
        std::ifstream stream(entry.path(), std::ios::binary);
        give({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()});
    }
    std::ifstream stream(OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus/small-car.json", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    ASSERT_FALSE(text.empty());
    scenery::models::Dice dice(11);
    constexpr std::string_view kLetters = "{}[]\",:-.0123456789etrn\\";
    for (int round = 0; round < 700; ++round)
    {
        std::string changed = text;
        for (int changes = 1 + dice.below(3); changes > 0; --changes)
        {
            const auto at = static_cast<std::size_t>(dice.below(static_cast<int>(changed.size())));
            if (dice.chance(0.5)) // another number: most of the file goes on to be sound
            {
                const std::size_t digit = changed.find_first_of("123456789", at);
                if (digit != std::string::npos) changed[digit] = static_cast<char>('0' + dice.below(10));
            }
            else if (dice.chance(0.3))
                changed.erase(at, static_cast<std::size_t>(dice.below(12)));
            else
                changed[at] = dice.oneOf(kLetters);
            if (changed.empty()) break;
        }
        give(changed);
    }
}

} // namespace
