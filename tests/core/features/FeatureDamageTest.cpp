// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: a randomly damaged map is read or refused, and features that are read can
// be painted.
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/features/FeatureCover.h>
#include <osgTerrainROAM/core/features/FeatureImport.h>

#include "FeatureText.h"

namespace
{

using namespace osgTerrainROAM::core;
using namespace featuretext;

} // namespace

TEST(FeatureDamage, AMapDamagedAtRandomIsReadOrRefused)
{
    const Folder folder("features-damage");
    const std::string whole = collection(
        {lineFeature(R"("highway":"primary","lanes":"2","width":"9")", {{100, 200}, {400, 250}, {500, 900}}),
         lineFeature(R"("waterway":"river")", {{0, 0}, {1900, 1900}}),
         areaFeature(R"("landuse":"farmland","crop":"maize")", {{10, 10}, {90, 0}, {90, 80}, {0, 70}}),
         lineFeature(R"("aeroway":"runway","ref":"09/27")", {{200, 1000}, {1700, 1000}})});
    const PlacedTile tile = planarTile();
    testsupport::Random random(4711);
    int refused = 0, read = 0;
    for (int round = 0; round < 3000; ++round)
    {
        std::string text = whole;
        for (std::uint32_t change = 0; change <= random.below(3); ++change)
        {
            const std::size_t at = random.below(static_cast<std::uint32_t>(text.size() - 1));
            switch (random.below(4))
            {
            case 0:
                text[at] = static_cast<char>(32 + random.below(95));
                break;
            case 1:
                text.erase(at, 1 + random.below(12));
                break;
            case 2:
                text.insert(at, std::to_string(random.below(10)));
                break;
            default:
                text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size() - 1)), 20));
                break;
            }
        }
        const auto set = importFeatures(folder.write("map.geojson", text), tile);
        if (!set)
        {
            ++refused;
            EXPECT_FALSE(set.error().remedy.empty());
            continue;
        }
        ++read;
        if (const auto cells = FeatureCells::build(set->features))
        {
            EXPECT_TRUE(cells->isConsistent());
            EXPECT_GE(featureCover(*cells, {250.0, 225.0}, 1.0).asphalt, 0.0f);
        }
    }
    EXPECT_GT(refused, 300) << "damage must show";
    EXPECT_GT(read, 300) << "and not everything is damage";
}
