// SPDX-License-Identifier: Apache-2.0
// A tunnel through a ridge in pictures: its mouth is open, nothing is seen through, the hill above is whole.
#include <algorithm>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include <osgDB/WriteFile>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "RenderedPicture.h"
#include "TunnelScene.h"
#include "scenery/nodes/RoadShading.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/roads/CutRoads.h"
#include "scenery/roads/TunnelOpenings.h"

namespace
{

using namespace osgTerrainROAM;
using namespace tunnelscene;

/// What is left out or made wrong.
struct Faults
{
    bool noOpenings = false, noConcrete = false, noFront = false;
    double crownM = osgRoads::core::TunnelTube{}.crownM;
};

osg::ref_ptr<osg::Node> makeThings(const osgRoads::core::PlacedNetwork& roads, const Faults& faults)
{
    auto things = scenery::roads::placeRoadThings(roads);
    if (faults.noConcrete) things.own.clear();
    if (faults.noFront)
        things.own.erase(things.own.end() - 4, things.own.end()); // fronts and backs are the last
    auto node = scenery::RoadThingsNode::create(things);
    EXPECT_TRUE(node);
    return node ? (*node)->node() : nullptr;
}

osg::ref_ptr<osg::Node> makeScene(const Faults& faults)
{
    const auto tile = ridge();
    const auto roads = road();
    core::TileEditor editor(tile);
    EXPECT_TRUE(scenery::cutRoads(editor, *roads));
    core::RoamFile description;
    description.placement = core::Placement::planar;
    description.land.water = osgTerrainROAM::core::WaterRule::none;
    description.surroundings = false;
    const auto terrain = makeTerrain(description, tile);
    EXPECT_TRUE(terrain);
    osgRoads::core::TunnelTube tube;
    tube.crownM = faults.crownM;
    const auto openings = core::OpeningCells::build(scenery::tunnelOpenings(*roads, tube));
    EXPECT_TRUE(openings);
    if (!faults.noOpenings) (*terrain)->material()->setOpenings(*openings);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->setStateSet((*terrain)->atmosphere()->stateSet());
    scene->addChild(*terrain);
    scene->addChild(scenery::makeRoadNode(
        std::make_shared<const osgRoads::core::RoadMesh>(osgRoads::core::buildRoadMesh(*roads)), *terrain));
    scene->addChild(makeThings(*roads, faults));
    return scene;
}

/// A picture with places of the scene in it. Where nothing is drawn it is magenta.
class Picture
{
public:
    Picture(const osg::Vec3d& eye, const osg::Vec3d& at, const Faults& faults = {})
    {
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = 320;
        settings.heightPx = 180;
        const auto viewer = rendered::viewerOf(makeScene(faults), settings);
        if (!viewer) return;
        viewer->camera().setClearColor({1.0F, 0.0F, 1.0F, 1.0F});
        viewer->camera().setProjectionMatrixAsPerspective(60.0, 16.0 / 9.0, 0.3, 5e3);
        viewer->camera().setViewMatrixAsLookAt(eye, at, {0.0, 0.0, 1.0});
        viewer->picture();
        _image = viewer->picture();
        const char* const folder = std::getenv("TUNNEL_PICTURES");
        static int count = 0;
        if (folder) osgDB::writeImageFile(*_image, folder + std::to_string(count++) + ".png");
        _pixels = viewer->camera().getViewMatrix() * viewer->camera().getProjectionMatrix();
    }

    const osg::Image& image() const { return *_image; }

    /// The share of pixels of a kind within the bounds of some places.
    double share(const std::vector<osg::Vec3d>& corners,
                 const std::function<bool(const osg::Vec4&)>& kind) const
    {
        osg::Vec2d low(1e9, 1e9), high(-1e9, -1e9);
        for (const osg::Vec3d& corner : corners)
        {
            const osg::Vec3d clip = corner * _pixels;
            const osg::Vec2d at(0.5 * (clip.x() + 1.0) * _image->s(), 0.5 * (clip.y() + 1.0) * _image->t());
            low = {std::min(low.x(), at.x()), std::min(low.y(), at.y())};
            high = {std::max(high.x(), at.x()), std::max(high.y(), at.y())};
        }
        int all = 0, some = 0;
        for (int y = std::max(0, int(low.y())); y < std::min(_image->t(), int(high.y())); ++y)
            for (int x = std::max(0, int(low.x())); x < std::min(_image->s(), int(high.x())); ++x, ++all)
                some += kind(_image->getColor(x, y)) ? 1 : 0;
        EXPECT_GT(all, 100) << "the places are not in the picture";
        return double(some) / std::max(all, 1);
    }

private:
    osg::ref_ptr<osg::Image> _image;
    osg::Matrixd _pixels;
};

bool isNothing(const osg::Vec4& colour)
{
    return colour.r() > 0.8F && colour.g() < 0.3F && colour.b() > 0.8F;
}

bool isGround(const osg::Vec4& colour)
{
    // Green: the crown of the tube is lit from below, by light that earth and grass throw back, and is brown.
    return !isNothing(colour) && colour.g() > 1.1F * colour.b() && colour.g() > 1.05F * colour.r();
}

constexpr double kHalf = 4.5; ///< of the tube, inside
constexpr double kExitX = kPortalX + kTunnelM;

/// The inside of the mouth, clear of its border and above the road.
const std::vector<osg::Vec3d> kMouth{{kPortalX, kRoadY - kHalf + 0.3, kRoadM + 0.3},
                                     {kPortalX, kRoadY + kHalf - 0.3, kRoadM + 4.4}};
/// The portal and the slopes beside and above it, all below the sky line.
const std::vector<osg::Vec3d> kAround{{kPortalX, kRoadY - 14.0, kRoadM - 0.5},
                                      {kPortalX, kRoadY + 14.0, kRoadM + 10.0}};
/// The front beside the mouth, to the left.
const std::vector<osg::Vec3d> kFront{{kPortalX, kRoadY + kHalf + 0.9, kRoadM + 3.0},
                                     {kPortalX, kRoadY + kHalf + 2.1, kRoadM + 7.5}};

Picture beforePortal(const Faults& faults = {})
{
    return {{kPortalX - 25.0, kRoadY - 1.75, kRoadM + 1.2}, {kPortalX, kRoadY - 1.75, kRoadM + 2.5}, faults};
}

/// 20 m before the exit, towards it; and what lies in the mouth above the horizon.
Picture leaving(const Faults& faults = {})
{
    return {{kExitX - 20.0, kRoadY - 1.75, kRoadM + 1.2}, {kExitX, kRoadY - 1.75, kRoadM + 1.6}, faults};
}
const std::vector<osg::Vec3d> kSkyInExit{{kExitX, kRoadY - 3.5, kRoadM + 2.0},
                                         {kExitX, kRoadY + 2.5, kRoadM + 4.0}};

/// The left wall before the exit.
const std::vector<osg::Vec3d> kWall{{kExitX - 12.0, kRoadY + kHalf, kRoadM + 0.3},
                                    {kExitX - 2.0, kRoadY + kHalf, kRoadM + 4.0}};

Picture abovePortal(const Faults& faults = {})
{
    return {{kPortalX - 20.0, kRoadY - 15.0, kRoadM + 30.0}, {kPortalX + 5.0, kRoadY, kRoadM}, faults};
}

Picture aboveHill(const Faults& faults = {})
{
    return {{480.0, kRoadY - 30.0, 110.0}, {480.0, kRoadY, 64.0}, faults};
}

bool isSame(const osg::Image& a, const osg::Image& b)
{
    return a.getTotalSizeInBytes() == b.getTotalSizeInBytes() &&
           std::memcmp(a.data(), b.data(), a.getTotalSizeInBytes()) == 0;
}

TEST(TunnelPictures, TheMouthIsOpenAndNothingIsSeenThrough)
{
    const Picture seen = beforePortal();
    EXPECT_EQ(seen.share(kMouth, isGround), 0.0);
    EXPECT_LT(seen.share(kAround, isNothing), 0.002) << "more than the exit, 9 m wide and 305 m away";
    EXPECT_EQ(seen.share(kFront, isGround), 0.0);
}

TEST(TunnelPictures, WithoutAnOpeningTheHillIsInTheMouth)
{
    EXPECT_GT(beforePortal({.noOpenings = true}).share(kMouth, isGround), 0.5);
}

TEST(TunnelPictures, WithoutATubeOneSeesThrough)
{
    EXPECT_GT(beforePortal({.noConcrete = true}).share(kAround, isNothing), 0.02);
}

TEST(TunnelPictures, WithoutAFrontTheSlopeIsSeenBesideTheMouth)
{
    EXPECT_GT(beforePortal({.noFront = true}).share(kFront, isGround), 0.5);
}

TEST(TunnelPictures, FromInsideOneSeesOutAndNothingBesideTheMouth)
{
    EXPECT_GT(leaving().share(kSkyInExit, isNothing), 0.5);
    EXPECT_EQ(leaving().share(kWall, isNothing), 0.0);
    EXPECT_GT(leaving({.noConcrete = true}).share(kWall, isNothing), 0.2);
}

TEST(TunnelPictures, FromAboveThePortalIsClosed)
{
    const std::vector<osg::Vec3d> around{{kPortalX - 5.0, kRoadY - 12.0, kRoadM},
                                         {kPortalX + 20.0, kRoadY + 12.0, kRoadM + 8.0}};
    EXPECT_EQ(abovePortal().share(around, isNothing), 0.0);
    EXPECT_GT(abovePortal({.noConcrete = true}).share(around, isNothing), 0.005);
}

TEST(TunnelPictures, TheHillAboveIsWhole)
{
    const Picture whole = aboveHill({.noOpenings = true});
    EXPECT_TRUE(isSame(aboveHill().image(), whole.image()));
    EXPECT_FALSE(isSame(aboveHill({.crownM = 80.0}).image(), whole.image()));
}

} // namespace
