// SPDX-License-Identifier: Apache-2.0
// The maps of the ground are found again, the same, and made anew where they were damaged.
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include <foundation/KeptFrom.h>
#include <gtest/gtest.h>

#include <osg/Texture>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/TerrainMaterial>

#include "KeptFiles.h"
#include "SyntheticField.h"
#include "material/ImageBytes.h"

namespace
{

using namespace osgTerrainROAM;
using testsupport::filesIn;

/// A field and a road across it.
core::FeatureCells paintedCells(double northM = 200.0)
{
    core::GroundFeature field, road;
    field.style.kind = core::FeatureKind::field;
    field.isArea = true;
    field.paths = {{{100.0, 100.0}, {700.0, 100.0}, {700.0, 500.0}}};
    road.paths = {{{50.0, northM}, {900.0, northM + 50.0}}};
    return *core::FeatureCells::build({field, road});
}

struct KeptFolder
{
    testsupport::TestFolder folder{"kept-ground"};
    std::filesystem::path made = folder / "made";
    std::shared_ptr<const foundation::KeptResults> results =
        std::make_shared<const foundation::KeptResults>(made);

    /// The texels of all maps of a ground with surroundings and features.
    std::string texels(const Climate& climate = {}, const core::FeatureCells& features = paintedCells(),
                       bool isKept = true) const
    {
        const auto tile = std::make_shared<core::RoamTile>(
            core::PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65))), results.get());
        const foundation::KeptFrom kept =
            isKept ? foundation::KeptFrom(results, tile->mark()) : foundation::KeptFrom();
        const osg::ref_ptr<TerrainMaterial> material =
            new TerrainMaterial(tile->tile, climate, nullptr, kept);
        material->setFeatures(features);
        material->setFarFeatures(features, 500.0);
        const osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material.get());
        terrain->showSurroundings(true);
        std::string all;
        for (unsigned unit = 0; unit < 32; ++unit)
            if (const auto* const texture = dynamic_cast<const osg::Texture*>(
                    material->stateSet()->getTextureAttribute(unit, osg::StateAttribute::TEXTURE)))
                for (unsigned i = 0; i < texture->getNumImages(); ++i)
                    all += bytesOf(*texture->getImage(i));
        return all;
    }
};

TEST(KeptGround, HasTheMapsThatWouldBeMade)
{
    const KeptFolder ground;
    const std::string made = ground.texels({}, paintedCells(), false);
    const std::string first = ground.texels();
    EXPECT_TRUE(first == made);
    const auto files = filesIn(ground.made);
    for (const char* name : {"beds-", "bounds-", "detail-", "far-", "grain-", "land-", "normals-", "outer-"})
        EXPECT_TRUE(files.lower_bound(name) != files.end() &&
                    files.lower_bound(name)->first.starts_with(name))
            << name;
    EXPECT_TRUE(ground.texels() == made);
    EXPECT_EQ(filesIn(ground.made), files); // found, not made
}

TEST(KeptGround, AnotherClimateOrOtherFeaturesHaveMapsOfTheirOwn)
{
    const KeptFolder ground;
    const std::string first = ground.texels();
    const auto files = filesIn(ground.made).size();
    Climate dry;
    dry.aridity = 0.9;
    dry.treeLineM = 100.0;
    EXPECT_TRUE(ground.texels(dry) == ground.texels(dry, paintedCells(), false));
    EXPECT_EQ(filesIn(ground.made).size(), files + 2); // land and outer
    EXPECT_TRUE(ground.texels({}, paintedCells(300.0)) != first);
    EXPECT_EQ(filesIn(ground.made).size(), files + 4); // the far maps, and those of beds alone
}

TEST(KeptGround, DamagedMapsAreMadeAnew)
{
    const KeptFolder ground;
    const std::string first = ground.texels();
    testsupport::writeNonsense(ground.made);
    const auto nonsense = filesIn(ground.made);
    EXPECT_TRUE(ground.texels() == first);
    for (const auto& [name, number] : filesIn(ground.made))
        EXPECT_NE(nonsense.at(name), number) << name;
}

TEST(KeptGround, AnEditedTileFindsNothingForItsSurroundings)
{
    const KeptFolder ground;
    const auto tile = std::make_shared<core::RoamTile>(
        core::PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65))), ground.results.get());
    ASSERT_TRUE(tile->mark());
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(
        tile->tile, Climate(), nullptr, foundation::KeptFrom(ground.results, tile->mark()));
    const osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material.get());
    tile->note({});
    EXPECT_FALSE(tile->mark());
    terrain->showSurroundings(true);
    for (const auto& [name, number] : filesIn(ground.made))
        EXPECT_FALSE(name.starts_with("outer-")) << name;
}

TEST(ImageBytes, OfOtherSizesAreNone)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(3, 5, 1, GL_RG, GL_UNSIGNED_SHORT);
    std::memset(image->data(), 7, image->getTotalSizeInBytes());
    const std::string bytes = bytesOf(*image);
    const auto read = imageIn(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(**read), bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(imageIn(bytes.substr(0, size))) << size;
    EXPECT_FALSE(imageIn(bytes + "x"));
    std::string wide = bytes;
    wide[3] = 0x7f; // 2 billion texels
    EXPECT_FALSE(imageIn(wide));
    std::string large = bytes;
    large[1] = large[5] = 0x40; // 16 387 x 16 389, more than a side may have
    EXPECT_FALSE(imageIn(large));
    large = bytes;
    const std::int32_t sides[]{16384, 16384, 16}; // 17 GB, which zero runs say in 16 bytes
    std::memcpy(large.data(), sides, sizeof sides);
    EXPECT_FALSE(imageIn(large));
}

} // namespace
