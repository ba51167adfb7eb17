// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimFile.h"

#include <gmock/gmock.h>

#include "simulation/vehicle/jsbsim/JsbsimRow.h"

namespace
{

using namespace simulation;

const std::string kHead = "<jsbsim_aircraft version=\"1\" name=\"A glider\" aircraft=\"glider\"";

TEST(JsbsimFile, IsRead)
{
    const auto data =
        parseJsbsimAircraft(kHead + " root=\"there\" answersWithinS=\"2\">\n<input name=\"hold\" "
                                    "property=\"ap/heading_hold[1]\"/>\n</jsbsim_aircraft>",
                            "f");
    ASSERT_TRUE(data) << data.error().message();
    EXPECT_EQ(data->name, "A glider");
    EXPECT_EQ(data->aircraft, "glider");
    EXPECT_EQ(data->root, "there");
    EXPECT_EQ(data->program, "JSBSim");
    EXPECT_DOUBLE_EQ(data->answersWithinS, 2.0);
    ASSERT_EQ(data->inputs.size(), 1U);
    EXPECT_EQ(data->inputs[0].property, "ap/heading_hold[1]");
}

TEST(JsbsimFile, SaysWhatIsWrong)
{
    const std::string end = "</jsbsim_aircraft>";
    const std::pair<std::string, const char*> wrong[] = {
        {"<aircraft version=\"1\"/>", "f:1: is no <jsbsim_aircraft"},
        {"<jsbsim_aircraft version=\"2\" name=\"a\" aircraft=\"b\"/>", "is no <jsbsim_aircraft"},
        {"<jsbsim_aircraft version=\"1\" aircraft=\"b\"/>", "has no name"},
        {"<jsbsim_aircraft version=\"1\" name=\"a\" aircraft=\"../b\"/>", "names no aircraft"},
        {kHead + " port=\"5\"/>", "unknown attribute 'port'"},
        {kHead + " answersWithinS=\"-1\"/>", "answersWithinS is '-1'"},
        {kHead + " program=\"\"/>", "empty program"},
        {kHead + ">\n<output/>" + end, "f:2: <output> is unknown"},
        {kHead + "><input name=\"a b\" property=\"p\"/>" + end, "is no word"},
        {kHead + "><input name=\"hold\" property=\"p 1\niterate 5\"/>" + end, "is no property"},
        {kHead + "><input name=\"elevator\" property=\"p\"/>" + end, "is there already"},
        {kHead + ">", "f:"}};
    for (const auto& [text, words] : wrong)
    {
        const auto data = parseJsbsimAircraft(text, "f");
        ASSERT_FALSE(data) << text;
        EXPECT_THAT(data.error().message(), testing::HasSubstr(words));
    }
}

TEST(JsbsimFile, OfTheTreeIsRead)
{
    const auto data = readJsbsimAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172x-jsbsim.xml");
    ASSERT_TRUE(data) << data.error().message();
    EXPECT_TRUE(isJsbsimFile(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172x-jsbsim.xml"));
    EXPECT_FALSE(isJsbsimFile(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml"));
}

std::string captions()
{
    std::string text = "Time";
    for (std::size_t i = 1; i <= static_cast<std::size_t>(JsbsimColumn::last); ++i)
        text += ",/fdm/jsbsim/" + std::string(kJsbsimProperties[i]);
    return text;
}

TEST(JsbsimTable, FindsColumnsByTheirNames)
{
    const auto table = JsbsimTable::create(captions() + ",gear/unit[0]/WOW");
    ASSERT_TRUE(table);
    const auto row = table->read("0.5,1,2,3,4,5,6,7,8,9,10,11,12,1e3, 1");
    ASSERT_TRUE(row);
    EXPECT_EQ((*row)[JsbsimColumn::time], 0.5);
    EXPECT_EQ((*row)[JsbsimColumn::earthZ], 3.0);
    EXPECT_EQ((*row)[JsbsimColumn::height], 1000.0);
    EXPECT_EQ((*row)[JsbsimColumn::noseWheel], 1.0);
    EXPECT_EQ((*row)[JsbsimColumn::elevator], 0.0);
    EXPECT_FALSE(table->read("0.5,1,2"));
    EXPECT_FALSE(table->read("0.5,1,2,3,x,5,6,7,8,9,10,11,12,13,1"));
    EXPECT_FALSE(table->read("0.5,1,2,3,nan,5,6,7,8,9,10,11,12,13,1")->isFinite());
    EXPECT_FALSE(JsbsimTable::create("Time,position/h-sl-ft"));
    EXPECT_FALSE(JsbsimTable::create(""));
}

} // namespace
