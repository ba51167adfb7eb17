// SPDX-License-Identifier: Apache-2.0
#include "view/ViewFile.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using testing::HasSubstr;
using trainer::parseView;
using trainer::ViewSetup;

namespace
{

const std::string kGood = R"(<View layout="tiled" nearM="0.4" farM="90000">
  <Channel name="left" widthPx="640" heightPx="480" yawDeg="-60" pitchDeg="5" rollDeg="-3" xM="0.5" yM="-1" zM="2"
           fovXDeg="60"/>
  <Channel name="right" widthPx="320" heightPx="480">
    <Frustum leftDeg="-20" rightDeg="35" bottomDeg="-15" topDeg="25"/>
  </Channel>
</View>)";

struct Mutation
{
    const char* from;
    const char* to;
    const char* line; ///< where the error must be
    const char* what; ///< what it must name
};

std::ostream& operator<<(std::ostream& out, const Mutation& mutation)
{
    return out << mutation.from << " -> " << mutation.to;
}

class ViewFileMutation : public testing::TestWithParam<Mutation>
{
};

} // namespace

TEST(ViewFile, EveryValueArrives)
{
    const auto view = parseView(kGood, "good.xml");
    ASSERT_TRUE(view) << view.error().message();
    EXPECT_EQ(view->layout, ViewSetup::Layout::tiled);
    EXPECT_EQ(view->nearM, 0.4);
    EXPECT_EQ(view->farM, 90000.0);
    ASSERT_EQ(view->channels.size(), 2U);
    const trainer::Channel& left = view->channels[0];
    EXPECT_EQ(left.name, "left");
    EXPECT_EQ(left.widthPx, 640);
    EXPECT_EQ(left.heightPx, 480);
    EXPECT_EQ(left.yawDeg, -60.0);
    EXPECT_EQ(left.pitchDeg, 5.0);
    EXPECT_EQ(left.rollDeg, -3.0);
    EXPECT_EQ(left.positionM, glm::dvec3(0.5, -1.0, 2.0));
    EXPECT_DOUBLE_EQ(left.frustum.leftDeg, -30.0);
    EXPECT_DOUBLE_EQ(left.frustum.rightDeg, 30.0);
    EXPECT_NEAR(left.frustum.topDeg, 23.413, 1e-3); // atan(tan 30° · 480 / 640)
    const trainer::Channel& right = view->channels[1];
    EXPECT_EQ(right.frustum.leftDeg, -20.0);
    EXPECT_EQ(right.frustum.rightDeg, 35.0);
    EXPECT_EQ(right.frustum.bottomDeg, -15.0);
    EXPECT_EQ(right.frustum.topDeg, 25.0);
    EXPECT_EQ(right.yawDeg, 0.0);
}

TEST_P(ViewFileMutation, IsExplainedWithItsLine)
{
    std::string text = kGood;
    const std::size_t at = text.find(GetParam().from);
    ASSERT_NE(at, std::string::npos) << "the mutation matches nothing";
    text.replace(at, std::string(GetParam().from).size(), GetParam().to);
    const auto view = parseView(text, "bad.xml");
    ASSERT_FALSE(view) << "was taken for good";
    EXPECT_EQ(view.error().place, std::string("bad.xml:") + GetParam().line) << view.error().message();
    EXPECT_THAT(view.error().what, HasSubstr(GetParam().what));
    EXPECT_FALSE(view.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    OneFault, ViewFileMutation,
    testing::Values(Mutation{"tiled", "stacked", "1", "stacked"},
                    Mutation{"nearM=\"0.4\"", "nearM=\"x\"", "1", "nearM"},
                    Mutation{"nearM=\"0.4\"", "nearM=\"95000\"", "1", "nearM"},
                    Mutation{"layout=", "layuot=", "1", "layuot"},
                    Mutation{"<Channel", "<Chanel", "2", "Chanel"},
                    Mutation{"widthPx=\"640\"", "widthPx=\"0\"", "2", "widthPx"},
                    Mutation{"widthPx=\"640\"", "", "2", "widthPx"},
                    Mutation{"widthPx=\"640\"", "widthPx=\"64.5\"", "2", "widthPx"},
                    Mutation{"heightPx=\"480\"", "heightPx=\"440\"", "1", "height"},
                    Mutation{"yawDeg=\"-60\"", "yawDeg=\"nan\"", "2", "yawDeg"},
                    Mutation{"fovXDeg=\"60\"", "fovXDeg=\"180\"", "2", "fovXDeg"},
                    Mutation{"fovXDeg=\"60\"", "fovXDeg=\"60\" fovYDeg=\"40\"", "2", "field of view"},
                    Mutation{"fovXDeg=\"60\"", "", "2", "field of view"},
                    Mutation{"name=\"right\"", "name=\"left\"", "1", "left"},
                    Mutation{"name=\"right\"", "name=\"../up\"", "4", "../up"},
                    Mutation{"rightDeg=\"35\"", "rightDeg=\"-35\"", "5", "leftDeg"},
                    Mutation{"topDeg=\"25\"", "topDeg=\"-25\"", "5", "bottomDeg"},
                    Mutation{"bottomDeg=\"-15\"", "bottomDeg=\"-95\"", "5", "bottomDeg"}));

TEST(ViewFile, AFieldInRadiansIsTold)
{
    const auto viewOf = [](const std::string& field)
    {
        return parseView("<View>\n<Channel name=\"a\" widthPx=\"64\" heightPx=\"48\" " + field + "/></View>",
                         "small.xml");
    };
    for (const char* field : {"fovXDeg=\"1.05\"", "fovYDeg=\"1.05\""})
    {
        const auto view = viewOf(field);
        ASSERT_TRUE(view) << view.error().message();
        ASSERT_EQ(view->notes.size(), 1u);
        EXPECT_THAT(view->notes[0], HasSubstr("small.xml:2: fov"));
        EXPECT_THAT(view->notes[0], HasSubstr("in radians it would be 60.2 degrees"));
    }
    EXPECT_TRUE(viewOf("fovXDeg=\"4\"")->notes.empty());
    EXPECT_EQ(viewOf("fovxDeg=\"60\"").error().remedy, "did you mean fovXDeg?");
}

TEST(ViewFile, WhatIsNoViewFileIsAnError)
{
    EXPECT_FALSE(parseView("", "empty.xml"));
    EXPECT_FALSE(parseView("<View>", "open.xml"));
    const auto none = parseView("<View/>", "none.xml");
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message(), HasSubstr("none.xml:1"));
    const auto other = parseView("<OpenSCENARIO/>", "other.xml");
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().message(), HasSubstr("OpenSCENARIO"));
    const auto missing = trainer::readView("no/such/file.xml");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message(), HasSubstr("no/such/file.xml"));
}
