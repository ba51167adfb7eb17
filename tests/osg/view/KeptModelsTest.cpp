// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <foundation/KeptResults.h>
#include <gtest/gtest.h>

#include <osg/observer_ptr>

#include <osgPMObjects/core/field/FieldLevels.h>
#include <osgPMObjects/core/progressive/PmFile.h>

#include "KeptFiles.h"
#include "TestFolder.h"
#include "scenery/models/Catalogue.h"
#include "scenery/models/Paint.h"
#include "scenery/models/paint/MipChain.h"
#include "scenery/nodes/KeptPaintings.h"
#include "scenery/nodes/ModelStates.h"
#include "scenery/nodes/PaintedTexture.h"
#include "scenery/nodes/ProgressiveModel.h"
#include "scenery/nodes/SceneryShapes.h"

namespace
{

namespace fs = std::filesystem;
using foundation::KeptResults;
using scenery::models::Kind;
using scenery::models::Painting;
using testsupport::filesIn;
using testsupport::UserCache;
using testsupport::writeNonsense;

std::string levelsOf(const KeptResults& kept)
{
    return osgPMObjects::core::pmBytes(
        scenery::progressiveOf(scenery::models::generate(Kind::barn, 3).mesh, kept));
}

} // namespace

TEST(KeptModels, LevelsAreThoseThatWouldBeMade)
{
    const testsupport::TestFolder folder("kept-levels");
    const KeptResults kept(folder / "made");
    const std::string made = levelsOf(KeptResults());
    EXPECT_EQ(levelsOf(kept), made);
    const auto files = filesIn(folder / "made");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(levelsOf(kept), made);
    EXPECT_EQ(filesIn(folder / "made"), files); // found, not made
}

TEST(KeptModels, NonsenseOfTheRightCheckSumIsMadeAnew)
{
    const testsupport::TestFolder folder("kept-nonsense");
    const KeptResults kept(folder / "made");
    const std::string levels = levelsOf(kept);
    const auto chain = scenery::paintedChain(Painting::plaster, false, kept);
    writeNonsense(folder / "made");
    const auto files = filesIn(folder / "made");
    EXPECT_EQ(levelsOf(kept), levels);
    EXPECT_EQ(scenery::paintedChain(Painting::plaster, false, kept), chain);
    for (const auto& [name, file] : filesIn(folder / "made"))
        EXPECT_NE(file, files.at(name)) << name;
}

TEST(KeptModels, PaintingsAreThoseThatWouldBePainted)
{
    const testsupport::TestFolder folder("kept-paintings");
    const KeptResults kept(folder / "made");
    for (const bool isFoliage : {false, true})
    {
        const auto painted =
            scenery::models::mipChain(scenery::models::paint(Painting::oakLeaves), isFoliage);
        EXPECT_EQ(scenery::paintedChain(Painting::oakLeaves, isFoliage, kept), painted);
        const auto files = filesIn(folder / "made");
        EXPECT_EQ(scenery::paintedChain(Painting::oakLeaves, isFoliage, kept), painted);
        EXPECT_EQ(filesIn(folder / "made"), files);
    }
    EXPECT_EQ(filesIn(folder / "made").size(), 2U);
}

TEST(KeptModels, ASceneryThatWasOpenedBeforeMakesAndPaintsNothing)
{
    const testsupport::TestFolder folder("kept-scenery");
    const UserCache cache(folder / "cache");
    const std::vector<scenery::SceneryObject> objects{{Kind::barn, 1, {}}, {Kind::bush, 2, {}}};
    const auto first = scenery::makeSceneryShapes(objects);
    ASSERT_TRUE(first);
    const fs::path made = folder / "cache/osgTrainer/made";
    const auto files = filesIn(made);
    EXPECT_GE(files.size(), 6U); // levels and ladders of two, and what they are painted with
    const auto second = scenery::makeSceneryShapes(objects);
    ASSERT_TRUE(second);
    EXPECT_EQ(filesIn(made), files);
    for (std::size_t i = 0; i < objects.size(); ++i)
        EXPECT_EQ(osgPMObjects::core::pmBytes(second->shapes[i]->progressive()),
                  osgPMObjects::core::pmBytes(first->shapes[i]->progressive()));
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        const auto levels =
            osgPMObjects::core::FieldLevels::of(first->shapes[i]->progressive(), first->shapes[i]->levels());
        EXPECT_EQ(osgPMObjects::core::bytesOf(*second->shapes[i]->fieldLevels()),
                  osgPMObjects::core::bytesOf(levels));
    }
    // What is missing alone is made.
    fs::remove(made / files.begin()->first);
    ASSERT_TRUE(scenery::makeSceneryShapes(objects));
    std::size_t written = 0;
    for (const auto& [name, file] : filesIn(made))
        written += file != files.at(name) ? 1U : 0U;
    EXPECT_EQ(filesIn(made).size(), files.size());
    EXPECT_LE(written, 1U); // the number of a file that is gone may be given again
}

TEST(KeptModels, PaintedTexturesAreSharedAsLongAsSomebodyUsesThem)
{
    osg::ref_ptr<osg::Texture2D> texture = scenery::paintedTexture(Painting::plaster, false, 4.0F);
    EXPECT_EQ(scenery::paintedTexture(Painting::plaster, false, 4.0F), texture);
    EXPECT_NE(scenery::paintedTexture(Painting::plaster, false, 1.0F), texture);
    EXPECT_EQ(scenery::paintedTexture(Painting::plaster, false, 1.0F)->getMaxAnisotropy(), 1.0F);
    scenery::ModelStates states, others;
    const scenery::models::Surface surface{Painting::plaster, scenery::models::Coat::matt};
    for (scenery::ModelStates* const made : {&states, &others})
        EXPECT_EQ(made->stateOf(surface)->getTextureAttribute(0, osg::StateAttribute::TEXTURE),
                  texture.get());
    const osg::observer_ptr<osg::Texture2D> watched(texture);
    states = others = scenery::ModelStates();
    texture = nullptr;
    EXPECT_FALSE(watched.valid());
    EXPECT_TRUE(scenery::paintedTexture(Painting::plaster, false, 4.0F));
}
