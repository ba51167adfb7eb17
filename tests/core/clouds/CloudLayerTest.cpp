// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/CloudLayer.h"

#include <gtest/gtest.h>

using namespace simulation;

TEST(CloudLayer, IsReadAsItIsWritten)
{
    const auto layers = readCloudLayers("3 cirrus 8000 8500; 4 cumulus 1200 2000", "here");
    ASSERT_TRUE(layers) << layers.error().message();
    ASSERT_EQ(layers->size(), 2U);
    EXPECT_EQ((*layers)[0], (CloudLayer{CloudKind::cumulus, 4, 1200.0, 2000.0})) << "the lower one is first";
    EXPECT_EQ((*layers)[1], (CloudLayer{CloudKind::cirrus, 3, 8000.0, 8500.0}));
    const auto none = readCloudLayers(" none ", "here");
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->empty());
}

TEST(CloudLayer, WhatIsNoneIsRefusedWithItsPlace)
{
    for (const char* text :
         {"", "cumulus", "9 cumulus 1200 2000", "-1 cumulus 1200 2000", "2.5 cumulus 1200 2000",
          "4 cotton 1200 2000", "4 cumulus 1200", "4 cumulus 1200 1210", "4 cumulus -5 2000",
          "4 cumulus 1200 nan", "4 cumulus 1200 1e9", "4 cumulus 1200 2000;", "4 cumulus 1200 2000 5",
          "1 cumulus 1000 2000; 1 stratus 1500 3000",
          "1 cumulus 100 200; 1 stratus 300 400; 1 stratus 500 600; 1 cirrus 7000 8000"})
    {
        const auto layers = readCloudLayers(text, "here");
        ASSERT_FALSE(layers) << text;
        EXPECT_NE(layers.error().message().find("here"), std::string::npos);
    }
}

TEST(CloudLayer, ACoverWithoutAHeightHasOne)
{
    EXPECT_TRUE(defaultClouds(0, false).empty());
    for (int oktas = 1; oktas <= 8; ++oktas)
        for (const bool falls : {false, true})
        {
            const auto layers = defaultClouds(oktas, falls);
            ASSERT_EQ(layers.size(), 1U);
            EXPECT_EQ(layers[0].oktas, oktas);
        }
}
