// SPDX-License-Identifier: Apache-2.0
#include "input/KeyScript.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "input/Keys.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace trainer;
using Kind = WindowEvent::Kind;

TEST(KeyScript, TellsEventsInTheOrderOfTime)
{
    const auto events = parseKeyScript("# a ride\nosgtrainer-keys 1\n1 hold PageUp 3 # power\n"
                                       "2 tap a\n3 press F12\n4 resize 320 180\n5 close\n",
                                       "keys");
    ASSERT_TRUE(events) << events.error().message();
    ASSERT_EQ(events->size(), 7U);
    EXPECT_EQ((*events)[0].key, keyOf("PageUp"));
    EXPECT_EQ((*events)[1].key, 'a');
    EXPECT_EQ((*events)[1].kind, Kind::press);
    EXPECT_EQ((*events)[2].kind, Kind::release);
    EXPECT_EQ((*events)[3].key, keyOf("F12"));
    EXPECT_EQ((*events)[4].key, keyOf("PageUp")); // at 4 s, after the line of 3 s
    EXPECT_EQ((*events)[4].kind, Kind::release);
    EXPECT_EQ((*events)[5].widthPx, 320);
    EXPECT_EQ((*events)[6].kind, Kind::close);
}

struct Mistake
{
    const char* text;
    const char* place;
    const char* what;
};

class KeyScriptMistakes : public testing::TestWithParam<Mistake>
{
};

TEST_P(KeyScriptMistakes, AreToldWithTheirLine)
{
    const auto events = parseKeyScript(GetParam().text, "keys");
    ASSERT_FALSE(events);
    EXPECT_EQ(events.error().place, GetParam().place);
    EXPECT_NE(events.error().what.find(GetParam().what), std::string::npos) << events.error().message();
    EXPECT_FALSE(events.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, KeyScriptMistakes,
    testing::Values(Mistake{"", "keys", "empty"}, Mistake{"osgtrainer-keys 2\n", "keys:1", "no such file"},
                    Mistake{"osgtrainer-keys 1\n1 tap Foo\n", "keys:2", "no key 'Foo'"},
                    Mistake{"osgtrainer-keys 1\n2 tap a\n1 tap b\n", "keys:3", "no time"},
                    Mistake{"osgtrainer-keys 1\nnan tap a\n", "keys:2", "no time"},
                    Mistake{"osgtrainer-keys 1\n1 push a\n", "keys:2", "no line of keys"},
                    Mistake{"osgtrainer-keys 1\n1\n", "keys:2", "no line of keys"},
                    Mistake{"osgtrainer-keys 1\n1 hold a x\n", "keys:2", "no line of keys"},
                    Mistake{"osgtrainer-keys 1\n1 resize 1 1\n", "keys:2", "no size"}));

TEST(KeyScript, MutationsAreRefusedOrInOrder)
{
    constexpr std::array kPieces{"\n",   " ",       "-1",  "1e9", "nan",       "tap",
                                 "hold", "close\n", "F99", "#",   "resize 9 9"};
    const std::string sound = "osgtrainer-keys 1\n1 hold PageUp 3\n2 tap a\n3 resize 320 180\n5 close\n";
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i)
    {
        std::string text = sound;
        for (unsigned edits = random() % 4U; edits > 0; --edits)
            text.replace(random() % text.size(), random() % 4U, kPieces[random() % kPieces.size()]);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
}

} // namespace
