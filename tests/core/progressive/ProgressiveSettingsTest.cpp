// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ArrangementSettings.h>
#include <osgPMObjects/core/progressive/PmFile.h>

namespace
{

using namespace osgPMObjects::core;

const float kWrongFloats[] = {-0.1f, std::nanf(""), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()};

/// Returns the field that checkSettings() complains of; empty: none.
template<class Settings>
std::string refusedField(const Settings& settings)
{
    const auto outcome = checkSettings(settings);
    return outcome ? "" : outcome.error().place;
}

TEST(ArrangementSettings, DefaultsOfEveryArrangementAreAccepted)
{
    for (const Arrangement arrangement :
         {Arrangement::plain, Arrangement::tswap, Arrangement::blocks, Arrangement::windows})
        EXPECT_EQ(refusedField(ArrangementSettings{.arrangement = arrangement}), "");
}

TEST(ArrangementSettings, CountsOutsideTheirRangesAreRefused)
{
    EXPECT_EQ(refusedField(ArrangementSettings{.cacheSize = 3}), "");
    for (const std::uint32_t wrong : {0u, 2u, 1025u})
        EXPECT_EQ(refusedField(ArrangementSettings{.cacheSize = wrong}), "arrangement.cacheSize") << wrong;
    EXPECT_EQ(refusedField(ArrangementSettings{.blockFaces = (1u << 20) + 1}), "arrangement.blockFaces");
    for (const std::uint32_t wrong : {0u, 1u, 65u})
        EXPECT_EQ(refusedField(ArrangementSettings{.windowBlocks = wrong}), "arrangement.windowBlocks")
            << wrong;
    for (const std::uint32_t wrong : {0u, 17u})
        EXPECT_EQ(refusedField(ArrangementSettings{.lookAhead = wrong}), "arrangement.lookAhead") << wrong;
}

TEST(ArrangementSettings, SharesAndWeightsThatAreNoNumbersAreRefused)
{
    EXPECT_EQ(refusedField(ArrangementSettings{.tswapStep = 1.0f}), "");
    EXPECT_EQ(refusedField(ArrangementSettings{.tswapStep = 0.0f}), "arrangement.tswapStep");
    EXPECT_EQ(refusedField(ArrangementSettings{.tswapStep = 1.1f}), "arrangement.tswapStep");
    for (const float wrong : kWrongFloats)
    {
        EXPECT_EQ(refusedField(ArrangementSettings{.tswapStep = wrong}), "arrangement.tswapStep") << wrong;
        EXPECT_EQ(refusedField(ArrangementSettings{.stayWeight = wrong}), "arrangement.stayWeight") << wrong;
        EXPECT_EQ(refusedField(ArrangementSettings{.touchedLineWeight = wrong}),
                  "arrangement.touchedLineWeight")
            << wrong;
    }
}

PmSettings sectioned(std::uint32_t sections)
{
    PmSettings settings;
    settings.stepSections = sections;
    return settings;
}

TEST(PmSettings, SectionsOutsideTheirRangeAreRefusedBeforeAFileIsWritten)
{
    EXPECT_EQ(refusedField(PmSettings{}), "");
    EXPECT_EQ(refusedField(sectioned(32)), "");
    for (const std::uint32_t wrong : {0u, 33u})
    {
        EXPECT_EQ(refusedField(sectioned(wrong)), "pm file.stepSections") << wrong;
        const std::string path = testing::TempDir() + "unwritten.pm";
        EXPECT_FALSE(writePm(path, ProgressiveMesh(), sectioned(wrong)));
        EXPECT_FALSE(std::filesystem::exists(path));
    }
}

} // namespace
