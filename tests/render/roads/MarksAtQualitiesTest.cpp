// SPDX-License-Identifier: Apache-2.0
// What is painted on roads is there at every quality: stop lines, arrows, crossings, lines of lanes.
#include <array>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <osg/Group>
#include <osgSky/Atmosphere>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "RenderedBox.h"
#include "RenderedPicture.h"
#include "RoadTexts.h"
#include "osgSession/view/Quality.h"
#include "scenery/nodes/RoadShading.h"

namespace
{

using namespace roadtexts;

constexpr int kSidePx = 256;

/// A mark, as the file has it, and where it lies on the road. Metres along and to the left.
struct Mark
{
    const char* name;
    std::string object;
    std::array<double, 4> box; ///< from s, from t, to s, to t
};

const std::array<Mark, 4> kMarks{
    {{"crossing",
      R"(<object id="1" type="crosswalk" s="55" t="0" zOffset="0" hdg="0" length="4" width="7"/>)",
      {53.0, -3.4, 57.0, 3.4}},
     {"stop line",
      R"(<object id="2" type="roadMark" subtype="signalLines" name="stopLine" s="51" t="-1.75" zOffset="0" hdg="0" width="3.3"/>)",
      {50.7, -3.2, 51.3, -0.3}},
     {"arrow",
      R"(<object id="3" type="roadMark" subtype="arrowStraight" s="46" t="-1.75" zOffset="0" hdg="0" length="5" width="1"/>)",
      {43.5, -2.3, 48.5, -1.2}},
     {"line", R"(<roadMark sOffset="0" type="solid" width="0.15"/>)", {41.0, -0.15, 49.0, 0.15}}}};

/// A straight road of two lanes with all marks but one (empty: with all).
std::shared_ptr<const osgRoads::core::RoadMesh> roadWithout(const std::string& left)
{
    std::string objects, line;
    for (const Mark& mark : kMarks)
        if (mark.name != left && left != "all")
            (mark.object.starts_with("<roadMark") ? line : objects) += mark.object;
    const std::string lane = std::string(R"(type="driving" level="false">)") + kWidth + "</lane>";
    const std::string lanes = R"(<lanes><laneSection s="0"><left><lane id="1" )" + lane +
                              R"(</left><center><lane id="0" type="none" level="false">)" + line +
                              R"(</lane></center><right><lane id="-1" )" + lane +
                              "</right></laneSection></lanes>";
    const auto read = std::make_shared<const osgRoads::core::RoadNetwork>(
        sound(network(road("1", 100.0, straightPlan(100.0) + lanes + "<objects>" + objects + "</objects>"))));
    return std::make_shared<const osgRoads::core::RoadMesh>(
        osgRoads::core::buildRoadMesh(osgRoads::core::PlacedNetwork(read)));
}

/// Mean levels of the boxes of all marks, by name, in a picture of a quality from 16 m above.
std::map<std::string, double> levelsOf(trainer::Quality quality, const std::string& left)
{
    const osg::ref_ptr<osgSky::Atmosphere> air = new osgSky::Atmosphere;
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->setStateSet(air->stateSet());
    scene->addChild(scenery::makeRoadNode(roadWithout(left)));
    if (const char* const define = trainer::rulesOf(quality).define)
        scene->getOrCreateStateSet()->setDefine(define);
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = kSidePx;
    const auto viewer = rendered::viewerOf(scene, settings);
    if (!viewer) return {};
    osg::Camera& camera = viewer->camera();
    camera.setProjectionMatrixAsPerspective(60.0, 1.0, 0.5, 1e3);
    camera.setViewMatrixAsLookAt({50.0, 0.0, 16.0}, {50.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    const osg::ref_ptr<osg::Image> picture = viewer->picture();
    const osg::Matrixd toClip = camera.getViewMatrix() * camera.getProjectionMatrix();
    std::map<std::string, double> levels;
    for (const Mark& mark : kMarks)
    {
        const std::array<osg::Vec3d, 2> corners{osg::Vec3d(mark.box[0], mark.box[1], 0.0),
                                                osg::Vec3d(mark.box[2], mark.box[3], 0.0)};
        const rendered::PixelBox box = rendered::boxAround(corners, toClip, *picture);
        EXPECT_GT(box.count(), 20) << mark.name;
        levels[mark.name] = box.mean([&](int x, int y) { return 255.0 * picture->getColor(x, y).g(); });
    }
    return levels;
}

TEST(MarksAtQualities, AreAllThere)
{
    std::map<std::string, double> atHigh;
    for (const auto quality : {trainer::Quality::high, trainer::Quality::medium, trainer::Quality::low})
    {
        auto with = levelsOf(quality, "");
        const auto without = levelsOf(quality, "all");
        for (const Mark& mark : kMarks)
        {
            const double brighter = with[mark.name] - without.at(mark.name);
            if (quality == trainer::Quality::high)
                EXPECT_GT(atHigh[mark.name] = brighter, 15.0) << mark.name;
            else
                EXPECT_NEAR(brighter, atHigh[mark.name], 0.15 * atHigh[mark.name])
                    << mark.name << " at quality " << static_cast<int>(quality);
        }
    }
}

/// The control: one mark is left out, and that one alone is missed.
TEST(MarksAtQualities, AreMissedWhereTheyAreLeftOut)
{
    const auto quality = trainer::Quality::low;
    const auto with = levelsOf(quality, ""), without = levelsOf(quality, "all");
    for (const Mark& left : kMarks)
    {
        const auto rest = levelsOf(quality, left.name);
        for (const Mark& mark : kMarks)
        {
            const double share =
                (rest.at(mark.name) - without.at(mark.name)) / (with.at(mark.name) - without.at(mark.name));
            if (mark.name == left.name)
                EXPECT_LT(share, 0.1) << mark.name;
            else
                EXPECT_GT(share, 0.9) << mark.name << " without the " << left.name;
        }
    }
}

} // namespace
