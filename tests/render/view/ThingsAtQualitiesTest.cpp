// SPDX-License-Identifier: Apache-2.0
// What a rule needs is there at every quality: lamps of runways, PAPI, road signs, traffic lights, other
// traffic.
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <osgViewer/Viewer>

#include <osgOffscreen/FrameGrabber>
#include <osgOffscreen/OffscreenContext>

#include "RenderedBox.h"
#include "RoadTexts.h"
#include "ScenarioText.h"
#include "TestFolder.h"
#include "play/PlayScene.h"
#include "scene/ScenarioStage.h"
#include "scenery/lights/RunwayLights.h"
#include "simulation/parser/ParseScenario.h"
#include "view/ChannelRig.h"

namespace
{

using trainer::Quality;

constexpr int kWidePx = 256, kHighPx = 144;
constexpr double kBeginM = 11.0, kSpeedMps = 12.0, kSeenAtS = 1.0; ///< of the other car
const glm::dvec3 kThingsEye(0.0, 0.0, 4.0), kThingsLookedAt(100.0, 0.0, 2.0);

/// A thing, and where it stands: the corners of a box, in metres along the road, to the left and upwards.
struct Thing
{
    const char* name;
    osg::Vec3d from, to;
};

const std::array<Thing, 6> kThings{{{"road sign", {14.0, 4.7, 2.1}, {14.0, 5.3, 2.7}},
                                    {"traffic light", {9.0, -4.15, 2.2}, {9.0, -3.85, 3.1}},
                                    {"its red lamp", {8.9, -4.1, 2.85}, {8.9, -3.9, 3.05}},
                                    {"other car", {23.0, -2.7, 0.2}, {28.0, -0.8, 1.5}},
                                    {"runway lamps", {60.0, 5.0, 0.1}, {60.0, 35.0, 0.6}},
                                    {"PAPI", {150.0, -77.0, 0.3}, {150.0, -50.0, 0.7}}}};
using Names = std::set<std::string>;
const Names kAll{"road sign", "traffic light", "other car", "runway lamps", "PAPI"};

std::string networkWithout(const Names& left)
{
    std::string signals;
    if (!left.contains("road sign"))
        signals += R"(<signal id="1" type="274" subtype="-1" country="de" s="14" t="5" zOffset="2.1"
orientation="+" width="0.6" height="0.6" dynamic="no" value="50"/>)";
    if (!left.contains("traffic light"))
        signals += R"(<signal id="2" type="1000001" subtype="-1" country="OpenDRIVE" s="9" t="-4"
zOffset="2.2" orientation="+" width="0.3" height="0.9" dynamic="yes"/>)";
    return roadtexts::network(roadtexts::road("1", 300.0,
                                              roadtexts::straightPlan(300.0) + roadtexts::twoLanes() +
                                                  "<signals>" + signals + "</signals>"));
}

/// The watched car is behind the eye; the other one drives away. The sun is so low that lamps burn.
std::string scenarioWithout(const Names& left)
{
    simulation::ScenarioText text;
    const auto at = [](double x)
    { return simulation::teleport("<WorldPosition x=\"" + std::to_string(x) + "\" y=\"-1.75\"/>"); };
    text.globals = R"(<GlobalAction><EnvironmentAction><Environment name="dusk">
<Weather cloudState="free"><Sun azimuth="4.7" elevation="0.03" illuminance="400"/></Weather>
</Environment></EnvironmentAction></GlobalAction>)";
    if (!left.contains("other car"))
    {
        text.entities += R"(<ScenarioObject name="red">)" + simulation::kCar + "</ScenarioObject>";
        text.globals +=
            "<Private entityRef=\"red\">" + at(kBeginM) + simulation::speedAction(kSpeedMps) + "</Private>";
    }
    text.privates = at(3.0) + simulation::speedAction(0.0);
    text.stop = simulation::stopAt(60.0);
    std::string whole = text.text();
    const std::string none = "<RoadNetwork/>";
    return whole.replace(whole.find(none), none.size(),
                         R"(<RoadNetwork><LogicFile filepath="road.xodr"/></RoadNetwork>)");
}

/// The lamps of a runway beside the road and the PAPI on the other side, as addStructures() has them.
std::shared_ptr<scenery::AirfieldNode> airfieldWithout(const Names& left)
{
    std::vector<scenery::PapiUnit> units;
    if (!left.contains("PAPI")) units = scenery::papiUnits({-150.0, -107.0}, {1.0, 0.0}, 1500.0, 30.0);
    std::vector<scenery::LightPoint> lamps;
    if (!left.contains("runway lamps"))
        lamps = scenery::runwayLights({{60.0, 20.0}, {1160.0, 20.0}, 30.0, true},
                                      [](const glm::dvec2&) { return 0.0; });
    return std::make_shared<scenery::AirfieldNode>(units, std::span<const glm::dvec3>(), lamps);
}

/// The scene of a play and its camera, as the trainer has them.
class Stage
{
public:
    explicit Stage(const Names& left)
    {
        _folder.write("road.xodr", networkWithout(left));
        _request.scenario = _folder.write("drive.xosc", scenarioWithout(left));
        _request.frames.eye = trainer::EyePoint::free;
        _request.frames.lightSteps.fill(5); // all lamps in full
        auto parsed = simulation::readScenario(_request.scenario, {});
        if (!parsed) throw std::runtime_error(parsed.error().message());
        auto terrain = trainer::openStage(parsed->scenario, _request);
        if (!terrain) throw std::runtime_error(terrain.error().message());
        terrain->airfield = airfieldWithout(left);
        const osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(terrain->node);
        group->addChild(terrain->airfield->node());
        terrain->node = group;
        auto made = trainer::PlayScene::create(std::move(parsed->scenario), std::move(*terrain), _request,
                                               simulation::FixedClock::forFrameRate(24));
        if (!made) throw std::runtime_error(made.error().message());
        _play.emplace(std::move(*made));
        if (left.contains("its red lamp")) _play->terrain.roadThings->setState("2", scenery::LightState::off);
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = kWidePx;
        settings.heightPx = kHighPx;
        auto context = osgOffscreen::OffscreenContext::create(settings);
        if (!context) throw std::runtime_error(context.error().message());
        _contexts = {*context};
        _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        _viewer.setLightingMode(osg::View::NO_LIGHT);
        _viewer.setSceneData(&_play->scene->root());
        _rig.emplace(_viewer, trainer::singleChannel(kWidePx, kHighPx), _contexts);
        _rig->setEye(scenery::poseLookingAt(kThingsEye, kThingsLookedAt));
        while (_play->player->timeS() < kSeenAtS)
            _play->player->step();
        _play->scene->show(*_play->player);
        _play->follow(kThingsEye);
    }

    osg::ref_ptr<osg::Image> picture(Quality quality)
    {
        trainer::drawWith(*_play, *_rig, quality, trainer::rulesOf(quality).tolerancePx, 1);
        osg::ref_ptr<osg::Image> picture;
        _contexts.front()->setSwapCallback(new osgOffscreen::FrameGrabber(
            [&picture](const osgOffscreen::GrabbedFrame& frame) { picture = frame.picture; }, 0));
        _viewer.frame(_play->player->timeS());
        _contexts.front()->setSwapCallback(nullptr);
        return picture;
    }

    osg::Matrixd toClip() const
    {
        const osg::Camera& camera = *_rig->cameras().front();
        return camera.getViewMatrix() * camera.getProjectionMatrix();
    }

private:
    testsupport::TestFolder _folder{"things-at-qualities"};
    trainer::PlayRequest _request;
    std::optional<trainer::PlayScene> _play;
    std::vector<osg::ref_ptr<osg::GraphicsContext>> _contexts;
    osgViewer::Viewer _viewer;
    std::optional<trainer::ChannelRig> _rig;
};

/// By how many levels the boxes of all things differ between two pictures: means.
std::map<std::string, double> differences(const osg::Image& a, const osg::Image& b,
                                          const osg::Matrixd& toClip)
{
    std::map<std::string, double> levels;
    for (const Thing& thing : kThings)
    {
        std::vector<osg::Vec3d> corners;
        for (const double x : {thing.from.x(), thing.to.x()})
            for (const double y : {thing.from.y(), thing.to.y()})
                for (const double z : {thing.from.z(), thing.to.z()})
                    corners.emplace_back(x, y, z);
        const rendered::PixelBox box = rendered::boxAround(corners, toClip, a);
        EXPECT_GT(box.count(), 6) << thing.name;
        levels[thing.name] = box.mean(
            [&](int x, int y)
            {
                const osg::Vec4 difference = a.getColor(x, y) - b.getColor(x, y);
                return 255.0 / 3.0 *
                       (std::abs(difference.r()) + std::abs(difference.g()) + std::abs(difference.b()));
            });
    }
    return levels;
}

/// Two scenes for all tests: one with all things, one without any.
class ThingsAtQualities : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        _with = std::make_unique<Stage>(Names{});
        _without = std::make_unique<Stage>(kAll);
    }
    static void TearDownTestSuite()
    {
        _with = nullptr;
        _without = nullptr;
    }

    /// What of all things a stage shows at a quality.
    static std::map<std::string, double> seenOn(Stage& stage, Quality quality)
    {
        return differences(*stage.picture(quality), *_without->picture(quality), stage.toClip());
    }

    static inline std::unique_ptr<Stage> _with, _without;
};

TEST_F(ThingsAtQualities, AreAllThere)
{
    const auto atHigh = seenOn(*_with, Quality::high);
    for (const Quality quality : {Quality::high, Quality::medium, Quality::low})
        for (const auto& [name, levels] : seenOn(*_with, quality))
        {
            EXPECT_GT(levels, 4.0) << name << " at quality " << static_cast<int>(quality);
            EXPECT_GT(levels, 0.7 * atHigh.at(name)) << name << " at quality " << static_cast<int>(quality);
        }
}

/// The control: what is left out is missed, and what stands elsewhere is not.
TEST_F(ThingsAtQualities, AreMissedWhereTheyAreLeftOut)
{
    const auto all = seenOn(*_with, Quality::low);
    for (const Names& left : {Names{"road sign", "runway lamps"}, Names{"traffic light", "PAPI"},
                              Names{"other car", "its red lamp"}})
    {
        Stage stage(left);
        for (const auto& [name, levels] : seenOn(stage, Quality::low))
        {
            const double share = levels / all.at(name);
            const std::string what = name + " without the " + *left.begin();
            // A lamp is no thing of its own: it may be dark, or gone with its housing.
            const bool isGone = left.contains(name);
            if (name == "its red lamp" && left.contains("traffic light")) continue;
            if (isGone && name == "its red lamp")
                EXPECT_LT(share, 0.65) << what;
            else if (isGone)
                EXPECT_LT(share, 0.1) << what;
            else
                EXPECT_GT(share, 0.75) << what;
        }
    }
}

} // namespace
