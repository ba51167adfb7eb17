// SPDX-License-Identifier: Apache-2.0
// Sessions that a program of others opens, drives and looks at.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <osgSession/Session>

#include "TestFolder.h"

namespace
{

using osgSession::EyeFrom;
using osgSession::Session;
using osgSession::SessionSettings;

SessionSettings ride()
{
    SessionSettings settings;
    settings.world = OSGTRAINER_SOURCE_DIR "/data/street.xodr";
    settings.vehicle = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";
    settings.picture = {160, 90, 1, osgSession::PictureQuality::low};
    return settings;
}

std::unique_ptr<Session> opened(const SessionSettings& settings)
{
    auto session = Session::open(settings);
    EXPECT_TRUE(session) << (session ? "" : session.error().message());
    return session ? std::move(*session) : nullptr;
}

std::string errorOf(const SessionSettings& settings)
{
    const auto session = Session::open(settings);
    return session ? "none" : session.error().message();
}

std::string bytesOf(const osg::ref_ptr<osg::Image>& picture)
{
    return picture
               ? std::string(reinterpret_cast<const char*>(picture->data()), picture->getTotalSizeInBytes())
               : std::string();
}

void stepTo(Session& session, double timeS)
{
    while (session.play().timeS() < timeS - 1e-9)
        ASSERT_TRUE(session.play().step()) << "it ends at " << session.play().timeS() << " s";
}

TEST(SessionPictures, TellHowFarTheOpeningIs)
{
    SessionSettings settings = ride();
    std::vector<std::string> stages;
    std::vector<double> shares{0.0};
    settings.progress = [&](std::string_view stage, double share)
    {
        stages.emplace_back(stage);
        shares.push_back(share);
    };
    const auto session = opened(settings);
    ASSERT_TRUE(session);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    for (const char* stage : {"program", "land", "what stands on it", "entities", "contexts"})
        EXPECT_EQ(std::count(stages.begin(), stages.end(), stage), 1) << stage;
    const std::size_t told = stages.size();
    session->picture();
    EXPECT_EQ(stages.size(), told) << "after it was open: " << stages.back();
    settings.world = "none.roam";
    stages.clear();
    EXPECT_NE(errorOf(settings), "none");
    EXPECT_EQ(std::count(stages.begin(), stages.end(), "contexts"), 0);
}

TEST(SessionPictures, ShowADriveFromEveryEyeInSilence)
{
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const auto session = opened(ride());
    ASSERT_TRUE(session);
    ASSERT_TRUE(session->play().set("Ego", "throttle", 0.6));
    std::set<std::string> pictures;
    const EyeFrom all[] = {EyeFrom::inside, EyeFrom::behind, EyeFrom::above, EyeFrom::tower,
                           EyeFrom::kerb,   EyeFrom::map,    EyeFrom::free};
    for (const EyeFrom from : all)
    {
        osgSession::Eye eye;
        eye.from = from;
        eye.place = {20.0, -8.0, 6.0};
        ASSERT_TRUE(session->look(eye));
        pictures.insert(bytesOf(session->picture()));
    }
    EXPECT_EQ(pictures.size(), std::size(all)) << "two eyes see the same";
    stepTo(*session, 4.0);
    EXPECT_GT(session->play().entity("Ego")->speedMps, 2.0);
    ASSERT_TRUE(session->look({EyeFrom::behind}));
    EXPECT_EQ(pictures.count(bytesOf(session->picture())), 0U) << "the car has not moved";
    EXPECT_FALSE(session->look({EyeFrom::inside, "Nobody"}));
    const testsupport::TestFolder folder("session");
    EXPECT_TRUE(session->savePicture(folder / "one.png"));
    EXPECT_GT(std::filesystem::file_size(folder / "one.png"), 100U);
    EXPECT_FALSE(session->savePicture(folder / "none/one.png"));
    const std::string out = testing::internal::GetCapturedStdout();
    EXPECT_EQ(out + testing::internal::GetCapturedStderr(), "");
}

TEST(SessionsTogether, HaveThePicturesOfOneAlone)
{
    const auto drive = [](Session& session, double timeS)
    {
        (void)session.play().set("Ego", "throttle", 0.6);
        (void)session.look({EyeFrom::behind});
        stepTo(session, timeS);
        return bytesOf(session.picture());
    };
    const auto alone = opened(ride());
    ASSERT_TRUE(alone);
    const std::string wanted = drive(*alone, 2.0);
    const auto first = opened(ride()), second = opened(ride());
    ASSERT_TRUE(first && second);
    const std::string other = drive(*second, 1.0);
    EXPECT_EQ(drive(*first, 2.0), wanted);
    EXPECT_NE(other, wanted);
}

TEST(SessionPictures, TellWhatCannotBeOpened)
{
    EXPECT_NE(errorOf({}).find("neither"), std::string::npos) << errorOf({});
    SessionSettings wrong = ride();
    wrong.world = "none.xodr";
    EXPECT_NE(errorOf(wrong).find("none.xodr"), std::string::npos) << errorOf(wrong);
    wrong = ride();
    wrong.vehicle = "none.xml";
    EXPECT_NE(errorOf(wrong).find("none.xml"), std::string::npos) << errorOf(wrong);
    wrong = ride();
    wrong.startM = 1e6;
    EXPECT_NE(errorOf(wrong).find("way of the drive"), std::string::npos) << errorOf(wrong);
    wrong = ride();
    wrong.picture.widthPx = 0;
    EXPECT_NE(errorOf(wrong).find("0 x 90"), std::string::npos) << errorOf(wrong);
    wrong = ride();
    wrong.play.stepsPerSecond = 0;
    EXPECT_NE(errorOf(wrong).find("stepsPerSecond"), std::string::npos) << errorOf(wrong);
}

TEST(SessionPictures, ShowAScenarioOverItsRoads)
{
    SessionSettings settings = ride();
    settings.world.clear();
    settings.vehicle.clear();
    settings.play.scenario = OSGTRAINER_SOURCE_DIR "/data/scenarios/physics.xosc";
    const auto session = opened(settings);
    ASSERT_TRUE(session);
    ASSERT_TRUE(session->look({EyeFrom::behind, "aircraft"}));
    const std::string begin = bytesOf(session->picture());
    stepTo(*session, 0.5);
    EXPECT_NE(bytesOf(session->picture()), begin);
    EXPECT_TRUE(session->play().inputs("ego").empty());
}

} // namespace
