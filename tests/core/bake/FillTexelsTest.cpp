// SPDX-License-Identifier: Apache-2.0
#include "core/bake/FillTexels.h"

#include <gtest/gtest.h>

namespace
{

using Texel = std::array<std::uint8_t, 2>;

TEST(FillTexels, KeepsWhatIsShownAndGivesTheRestTheMeanOfTheNearest)
{
    // Two texels of the lower left quarter are filled; the nearest value for the upper right one is their
    // mean.
    std::vector<Texel> texels(16, {99, 99});
    std::vector<std::uint8_t> isShown(16, 0);
    texels[0] = {10, 200}, isShown[0] = 1;
    texels[5] = {20, 100}, isShown[5] = 1;
    osgPMObjects::core::fillTexels(texels, isShown, 4);
    EXPECT_EQ(texels[0], (Texel{10, 200}));
    EXPECT_EQ(texels[5], (Texel{20, 100}));
    EXPECT_EQ(texels[1], (Texel{15, 150}));
    EXPECT_EQ(texels[15], (Texel{15, 150}));
}

TEST(FillTexels, TakesTheNearerOfTwo)
{
    std::vector<Texel> texels(16);
    std::vector<std::uint8_t> isShown(16, 0);
    texels[0] = {10, 10}, isShown[0] = 1;
    texels[15] = {90, 90}, isShown[15] = 1;
    osgPMObjects::core::fillTexels(texels, isShown, 4);
    EXPECT_EQ(texels[4], (Texel{10, 10}));
    EXPECT_EQ(texels[11], (Texel{90, 90}));
    EXPECT_EQ(texels[3], (Texel{50, 50}));
}

TEST(FillTexels, OfNothingShownStayEmpty)
{
    std::vector<Texel> texels(64);
    osgPMObjects::core::fillTexels(texels, std::vector<std::uint8_t>(64, 0), 8);
    for (const Texel& texel : texels)
        EXPECT_EQ(texel, (Texel{0, 0}));
}

} // namespace
