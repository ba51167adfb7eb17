// SPDX-License-Identifier: Apache-2.0
// Ground beside a wall and below a crown gets less light of the sky, and as much of the sun as before.
#include <gtest/gtest.h>

#include "RenderedView.h"
#include "scenery/nodes/SkyShadeNode.h"

namespace
{

constexpr int kAcrossPx = 320, kUpPx = 240;

scenery::SkyOccluders wallAndCrown()
{
    scenery::SkyOccluders occluders;
    occluders.walls.push_back({{-10.0, 0.0}, {0.0, 0.0}, 6.0}); // its outer side looks south
    occluders.bodies.push_back({{6.0, -3.0}, {1.0, 0.0}, {2.5, 2.5}, 2.0, 0.8});
    return occluders;
}

/// The green of the ground seen from straight above, 24 m high.
class FromAbove
{
public:
    FromAbove(double sunDeg, bool isShown, double groundM = 0.0)
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(180.0, sunDeg);
        const rendered::ViewScene scene(air);
        scenery::SkyShadeNode shade(wallAndCrown(),
                                    [=](const glm::dvec2&) { return std::optional<double>(groundM); });
        shade.setShown(isShown);
        const glm::dvec3 eye(0.0, -3.0, 24.0);
        shade.follow(eye);
        scene.root->addChild(shade.node());
        osgOffscreen::OffscreenSettings settings = rendered::smallPicture();
        settings.widthPx = kAcrossPx;
        settings.heightPx = kUpPx;
        settings.samples = 1;
        _image = rendered::pictureFrom(
            scene.root, scenery::poseLookingAt(eye, eye + glm::dvec3(0.0, 1e-3, -1.0)), settings);
    }

    double at(double x, double y) const
    {
        const double perM = 0.5 * kUpPx / (24.0 * std::tan(glm::radians(20.0)));
        return _image->data(static_cast<unsigned>(0.5 * kAcrossPx + perM * x),
                            static_cast<unsigned>(0.5 * kUpPx + perM * (y + 3.0)))[1];
    }

private:
    osg::ref_ptr<osg::Image> _image;
};

} // namespace

TEST(SkyShade, WhereTheSkyIsHiddenTheGroundIsDarker)
{
    const FromAbove dusk(-3.0, true), none(-3.0, false); // the sky alone gives light
    const double open = none.at(-5.0, -7.9);
    EXPECT_NEAR(none.at(-5.0, -0.3), open, 2.0) << "the control: without patches nothing is darker";
    EXPECT_LT(dusk.at(-5.0, -0.3), 0.90 * open) << "beside the wall";
    EXPECT_LT(dusk.at(6.0, -3.0), 0.80 * open) << "below the crown";
    EXPECT_GT(dusk.at(-5.0, -4.5), 0.97 * open) << "5 m from the wall it is as bright as in the open";
    EXPECT_NEAR(dusk.at(-5.0, 1.0), open, 2.0) << "behind the wall is its inside";
}

TEST(SkyShade, TheSunIsLeft)
{
    const FromAbove noon(60.0, true), none(60.0, false);
    EXPECT_LT(noon.at(-5.0, -0.3), none.at(-5.0, -0.3));
    EXPECT_GT(noon.at(-5.0, -0.3), 0.93 * none.at(-5.0, -0.3));
}

TEST(SkyShade, PatchesInTheGroundAreNotSeen)
{
    const FromAbove sunk(-3.0, true, -2.0), none(-3.0, false);
    EXPECT_NEAR(sunk.at(6.0, -3.0), none.at(6.0, -3.0), 1.0)
        << "so the first test sees patches that lie on it";
}
