// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "measurement/SvgPlot.h"
#include "view/HtmlReport.h"
#include "view/StatisticsFile.h"

using trainer::FrameStatistics;
using trainer::summaryOf;

namespace
{

std::vector<FrameStatistics> someFrames(std::uint32_t count)
{
    std::vector<FrameStatistics> frames;
    for (std::uint32_t i = 0; i < count; ++i)
        frames.push_back({i, i / 24.0, 1000 + i, 2 * i, i, 50.5 + i, 1.25, 7.5, 0.75, {}});
    return frames;
}

std::size_t countOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

} // namespace

TEST(Statistics, MedianAndNinetyNinthByHand)
{
    EXPECT_EQ(summaryOf(std::vector<double>{5.0, 1.0, 3.0}).median, 3.0);
    EXPECT_EQ(summaryOf(std::vector<double>{4.0, 1.0, 3.0, 2.0}).median, 2.5);
    std::vector<double> values;
    for (int i = 200; i >= 1; --i)
        values.push_back(i);
    EXPECT_EQ(summaryOf(values).p99, 198.0); // 198 of 200 are 99 %
    EXPECT_EQ(summaryOf(values).largest, 200.0);
    EXPECT_EQ(summaryOf(std::vector<double>{7.0}).p99, 7.0);
    EXPECT_EQ(summaryOf(std::vector<double>{}).median, 0.0);
}

TEST(Statistics, OneSlowFrameIsSeenByTheNinetyNinthOfFewFramesOnly)
{
    std::vector<double> values(99, 1.0);
    values.push_back(50.0);
    EXPECT_EQ(summaryOf(values).p99, 1.0);
    values.pop_back();
    values.back() = 50.0;
    EXPECT_EQ(summaryOf(values).p99, 50.0);
}

TEST(Statistics, JsonHasTheStagesOfTheOpening)
{
    trainer::OpeningClock clock;
    clock.end("ground");
    clock.end("first picture");
    const auto frames = someFrames(2);
    const auto json = nlohmann::json::parse(trainer::statisticsJson(frames, true, clock.stages()));
    ASSERT_EQ(json["opening"].size(), 2U);
    EXPECT_EQ(json["opening"][0]["stage"], "ground");
    EXPECT_EQ(json["opening"][1]["stage"], "first picture");
    for (const auto& stage : json["opening"])
        for (const char* key : {"wallS", "processorS"})
            EXPECT_GE(stage[key].get<double>(), 0.0) << key;
    EXPECT_EQ(trainer::statisticsJson(frames, false, clock.stages()),
              trainer::statisticsJson(frames, false)); // times are not the same in two runs
    EXPECT_FALSE(nlohmann::json::parse(trainer::statisticsJson(frames)).contains("opening"));
}

TEST(Statistics, JsonHasEveryKeyOfEveryFrame)
{
    const auto json = nlohmann::json::parse(trainer::statisticsJson(someFrames(5)));
    ASSERT_EQ(json["frames"].size(), 5U);
    for (const char* key : {"frame", "timeS", "triangles", "splits", "merges", "adaptUs", "cullMs", "drawMs",
                            "maxErrorPx", "wallMs", "processorMs", "uploadBytes", "residentMb"})
        for (const auto& frame : json["frames"])
            EXPECT_TRUE(frame.contains(key)) << key;
    EXPECT_EQ(json["frames"][3]["triangles"], 1003);
    EXPECT_EQ(json["frames"][3]["splits"], 6);
    EXPECT_EQ(json["frames"][3]["adaptUs"], 53.5);
    EXPECT_EQ(json["frames"][3]["frame"], 3);
    EXPECT_EQ(json["summary"]["frames"], 5);
    EXPECT_EQ(json["summary"]["triangles"]["first"], 1000.0);
    EXPECT_EQ(json["summary"]["triangles"]["median"], 1002.5);
    EXPECT_EQ(json["summary"]["triangles"]["max"], 1004.0);
    EXPECT_EQ(json["summary"]["drawMs"]["p99"], 7.5);
}

TEST(Statistics, TheFirstFrameStandsApart)
{
    auto frames = someFrames(5);
    const auto drawMs = [&]
    { return nlohmann::json::parse(trainer::statisticsJson(frames))["summary"]["drawMs"]; };
    frames.front().drawMs = 900.0;
    EXPECT_EQ(drawMs()["first"], 900.0);
    EXPECT_EQ(drawMs()["max"], 7.5);
    frames.back().drawMs = 900.0; // any other frame counts
    EXPECT_EQ(drawMs()["max"], 900.0);
    frames.resize(1);
    EXPECT_EQ(drawMs()["max"], 900.0);
}

TEST(Statistics, WithoutTimingsOnlyWhatTheMachineCannotChangeIsLeft)
{
    auto slower = someFrames(5);
    for (FrameStatistics& frame : slower)
        frame.adaptUs = frame.cullMs = frame.drawMs = 1e6;
    EXPECT_EQ(trainer::statisticsJson(someFrames(5), false), trainer::statisticsJson(slower, false));
    EXPECT_NE(trainer::statisticsJson(someFrames(5)), trainer::statisticsJson(slower));
    slower[2].triangles += 1;
    EXPECT_NE(trainer::statisticsJson(someFrames(5), false), trainer::statisticsJson(slower, false));
}

TEST(Statistics, HasObjectsAndMethodsWhereThereAreSome)
{
    using osgPMObjects::core::SelectionMethod;
    auto frames = someFrames(3);
    EXPECT_FALSE(
        nlohmann::json::parse(trainer::statisticsJson(frames))["frames"][0].contains("objectsDrawn"));
    for (FrameStatistics& frame : frames)
    {
        frame.objects = trainer::ObjectFigures{50, 40, 3, 12345, 0.25, {}};
        frame.objects->selection.of(SelectionMethod::screenError).objects = 40;
        frame.objects->selection.of(SelectionMethod::screenError).triangles = 12345;
    }
    const auto json = nlohmann::json::parse(trainer::statisticsJson(frames));
    const auto& frame = json["frames"][1];
    EXPECT_EQ(frame["objectsVisible"], 50);
    EXPECT_EQ(frame["objectsDrawn"], 40);
    EXPECT_EQ(frame["objectsSwitching"], 3);
    EXPECT_EQ(frame["objectTriangles"], 12345);
    EXPECT_EQ(frame["objectCullMs"], 0.25);
    EXPECT_EQ(frame["objectMethods"].size(), 1U); // the others have no objects
    EXPECT_EQ(frame["objectMethods"]["screen-error"]["triangles"], 12345);
    EXPECT_EQ(json["summary"]["objectTriangles"]["median"], 12345.0);
    EXPECT_FALSE(
        nlohmann::json::parse(trainer::statisticsJson(frames, false))["frames"][0].contains("objectCullMs"));
    EXPECT_THAT(trainer::reportHtml({}, frames), testing::HasSubstr("<td>screen-error</td>"));
    EXPECT_THAT(trainer::reportHtml({}, someFrames(3)), testing::Not(testing::HasSubstr("Selection, all")));
}

TEST(Statistics, AFileThatCannotBeWrittenIsAnError)
{
    const auto written = trainer::writeStatistics(someFrames(2), {}, "/no/such/folder/stats.json");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message(), testing::HasSubstr("/no/such/folder/stats.json"));
}

TEST(SvgPlot, KeepsEveryPeakHoweverManyFrames)
{
    measurement::Plot plot{"p", "x", {}, {{"s", "#000", {}}, {"fixes the axis", "#000", {200.0}}}};
    for (int i = 0; i < 100'000; ++i)
    {
        plot.x.push_back(i);
        plot.series[0].values.push_back(i == 77'777 ? 100.0 : 1.0);
    }
    const std::string svg = measurement::svgPlot(plot);
    EXPECT_LT(svg.size(), 60'000U);
    // The peak lies where the axis has 100 of 210: 186 − 158·100/210.
    EXPECT_THAT(svg, testing::HasSubstr(",110.8 "));
    plot.series[0].values[77'777] = 1.0;
    EXPECT_THAT(measurement::svgPlot(plot), testing::Not(testing::HasSubstr(",110.8 ")));
}

TEST(SvgPlot, DrawsWhatHasNoExtentOrNoPoints)
{
    EXPECT_THAT(measurement::svgPlot({"empty", "x", {}, {{"s", "#000", {}}}}), testing::HasSubstr("</svg>"));
    const std::string flat = measurement::svgPlot({"flat", "x", {2.0}, {{"s", "#000", {0.0}}}});
    EXPECT_EQ(flat.find("nan"), std::string::npos);
    EXPECT_EQ(flat.find("inf"), std::string::npos);
}

TEST(SvgPlot, LeavesOutWhatIsNoFiniteNumber)
{
    const double none = std::numeric_limits<double>::infinity();
    const auto drawn = [](std::vector<double> x, std::vector<double> values) {
        return measurement::svgPlot({"bound", "x", std::move(x), {{"s", "#000", std::move(values)}}});
    };
    const std::string svg = drawn({0.0, 1.0, 2.0, 3.0}, {none, 4.0, none, 2.0});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    const std::string without = drawn({0.0, 1.0, 3.0}, {0.0, 4.0, 2.0});
    const auto lineEnd = [](const std::string& text) { return text.substr(text.rfind("<polyline")); };
    EXPECT_THAT(lineEnd(without), testing::HasSubstr(lineEnd(svg).substr(lineEnd(svg).find("points=") + 8)))
        << "the rest lies where it lay";
}

TEST(SvgPlot, StepsAreOneTwoFive)
{
    EXPECT_DOUBLE_EQ(measurement::niceStep(100.0, 4), 20.0);
    EXPECT_DOUBLE_EQ(measurement::niceStep(7.0, 6), 1.0);
    EXPECT_DOUBLE_EQ(measurement::niceStep(0.3, 5), 0.05);
}

TEST(HtmlReport, HoldsFactsPicturesTableAndPlotsAndNothingFromTheNetwork)
{
    trainer::ReportContent content;
    content.title = "A <flight> & more";
    content.facts = {{"scenario", "\"x\".xosc"}};
    content.contactSheet = "contact-sheet.png";
    content.video = "demo.mp4";
    const std::string html = trainer::reportHtml(content, someFrames(48));
    EXPECT_THAT(html, testing::HasSubstr("A &lt;flight&gt; &amp; more"));
    EXPECT_THAT(html, testing::HasSubstr("&quot;x&quot;.xosc"));
    EXPECT_THAT(html, testing::HasSubstr("src=\"contact-sheet.png\""));
    EXPECT_THAT(html, testing::HasSubstr("src=\"demo.mp4\""));
    EXPECT_THAT(html, testing::HasSubstr("maxErrorPx"));
    EXPECT_EQ(countOf(html, "<svg "), 5U);
    EXPECT_EQ(countOf(html, "</svg>"), 5U);
    EXPECT_EQ(html.find("http"), std::string::npos);
}
