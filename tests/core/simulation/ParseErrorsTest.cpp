// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is said with its line; nothing wrong with a file may crash or hang.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"

namespace simulation
{
namespace
{

struct Fault
{
    const char* name;
    const char* replaced; ///< in the good text
    const char* by;
    const char* expected; ///< part of the message
};

std::string goodText()
{
    ScenarioText text;
    text.declarations = "<ParameterDeclarations><ParameterDeclaration name=\"p\" parameterType=\"double\" "
                        "value=\"1\"/></ParameterDeclarations>";
    text.privates = teleport("<WorldPosition x=\"1\" y=\"2\"/>") + "\n" +
                    followTrajectory(vertex("<WorldPosition x=\"0\" y=\"0\"/>", "0") +
                                         vertex("<GeoPosition latitudeDeg=\"46\" longitudeDeg=\"8\"/>", "1"),
                                     kTiming);
    text.globals = "<GlobalAction><EnvironmentAction><Environment name=\"e\"><TimeOfDay animation=\"true\" "
                   "dateTime=\"2025-06-13T06:00:00Z\"/></Environment></EnvironmentAction></GlobalAction>\n";
    text.stories = story(event("a", speedAction(1.0), timeCondition(2.0)));
    text.stop = stopAt(9.0);
    return text.text();
}

class ParseFault : public testing::TestWithParam<Fault>
{
};

TEST_P(ParseFault, IsSaidWithItsLine)
{
    std::string text = goodText();
    const std::size_t at = text.find(GetParam().replaced);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(GetParam().replaced).size(), GetParam().by);
    const auto strict = parseScenario(text, "test.xosc");
    ASSERT_FALSE(strict);
    EXPECT_NE(strict.error().message().find(GetParam().expected), std::string::npos)
        << strict.error().message();
    ASSERT_TRUE(strict.error().place.starts_with("test.xosc:")) << strict.error().place;
    EXPECT_FALSE(strict.error().remedy.empty());
    const int line = std::stoi(strict.error().place.substr(10));
    const auto wanted = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_LE(std::abs(line - wanted), 1) << strict.error().message();
}

INSTANTIATE_TEST_SUITE_P(
    Table, ParseFault,
    testing::Values(
        Fault{"missingAttribute", "x=\"1\" y=\"2\"", "x=\"1\"", "WorldPosition has no attribute y"},
        Fault{"badNumber", "x=\"1\" y=\"2\"", "x=\"1\" y=\"two\"",
              "WorldPosition/y is not a finite number: \"two\""},
        Fault{"notANumber", "x=\"1\" y=\"2\"", "x=\"nan\" y=\"2\"", "not a finite number"},
        Fault{"infinite", "x=\"1\" y=\"2\"", "x=\"1e999\" y=\"2\"", "not a finite number"},
        Fault{"hugeNumber", "x=\"1\" y=\"2\"", "x=\"1e10\" y=\"2\"", "WorldPosition/x is beyond 1e9"},
        Fault{"undeclared", "x=\"1\" y=\"2\"", "x=\"$q\" y=\"2\"",
              "the parameter $q in WorldPosition/x is not declared"},
        Fault{"expression", "x=\"1\" y=\"2\"", "x=\"${1/0}\" y=\"2\"", "division by zero"},
        Fault{"openExpression", "x=\"1\" y=\"2\"", "x=\"${1\" y=\"2\"", "does not end with }"},
        Fault{"selfReference", "value=\"1\"/></Par", "value=\"$p\"/></Par", "the parameter $p"},
        Fault{"unknownPosition", "<WorldPosition x=\"1\" y=\"2\"/>", "<MoonPosition roadId=\"1\"/>",
              "the position MoonPosition is no element of OpenSCENARIO"},
        Fault{"unknownAction", "<TeleportAction>", "<X/>\n<TeleportAction>",
              "the element X is no element of OpenSCENARIO"},
        Fault{"unknownEntity", "<Private entityRef=\"Ego\"", "<Private entityRef=\"Egon\"",
              "the entity Egon does not exist"},
        Fault{"unknownActor", "<EntityRef entityRef=\"Ego\"", "<EntityRef entityRef=\"You\"",
              "the entity You does not exist"},
        Fault{"latitude", "latitudeDeg=\"46\"", "latitudeDeg=\"96\"",
              "GeoPosition/latitudeDeg is out of range"},
        Fault{"degreesAsRadians", "latitudeDeg=\"46\"", "latitude=\"46\"", "latitude counts radians"},
        Fault{"timeOrder", "time=\"1\"", "time=\"0\"", "is not later than the one before"},
        Fault{"missingTime", " time=\"1\"", "", "vertex 2"},
        Fault{"scale", "scale=\"1\"", "scale=\"0\"", "Timing/scale is not within"},
        Fault{"word", "followingMode=\"position\"", "followingMode=\"fly\"", "has the unknown value \"fly\""},
        Fault{"dateTime", "dateTime=\"2025-06-13T06:00:00Z\"", "dateTime=\"noon\"", "is not a date and time"},
        Fault{"count", "maximumExecutionCount=\"1\"", "maximumExecutionCount=\"1.5\"", "is not a count"},
        Fault{"delay", "delay=\"0.000000\"", "delay=\"-1\"", "is negative"},
        Fault{"condition", "<SimulationTimeCondition", "<MoonPhaseCondition/><SimulationTimeCondition",
              "the element MoonPhaseCondition is no element of OpenSCENARIO"},
        Fault{"unknownElement", "<RoadNetwork/>", "<RoadNetwork><UsedArea/></RoadNetwork>",
              "the element UsedArea is not supported; instead: "},
        Fault{"twice", "<Entities>", "<Entities><ScenarioObject name=\"Ego\"><Vehicle/></ScenarioObject>",
              "Vehicle has no attribute name"},
        Fault{"revision", "revMajor=\"1\"", "revMajor=\"2\"", "OpenSCENARIO XML 2 is unknown"},
        Fault{"malformed", "</Storyboard>", "</Storybord>", "not well-formed XML"}),
    [](const testing::TestParamInfo<Fault>& fault) { return std::string(fault.param.name); });

TEST(ParseErrors, GoodTextIsGood)
{
    const auto good = parseScenario(goodText(), "test.xosc");
    EXPECT_TRUE(good) << good.error().message();
}

TEST(ParseErrors, TolerantReadingListsThemAll)
{
    std::string text = goodText();
    for (const char* name : {"<Init>", "<StopTrigger>"})
        text.insert(text.find(name), "<Strange/>");
    text.replace(text.find("x=\"1\""), 5, "x=\"one\"");
    const auto tolerant = parseScenario(text, "t", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(tolerant);
    EXPECT_EQ(tolerant->problems.size(), 3u);
    EXPECT_EQ(std::count_if(tolerant->problems.begin(), tolerant->problems.end(),
                            [](const Problem& problem) { return problem.kind == Problem::Kind::invalid; }),
              1);
}

TEST(ParseErrors, DeepHugeAndForeignTextsAreRefused)
{
    std::string deep;
    for (int i = 0; i < 200'000; ++i)
        deep += "<a>";
    EXPECT_FALSE(parseScenario(deep, "deep"));
    for (int i = 0; i < 200'000; ++i)
        deep += "</a>";
    const auto nested = parseScenario(deep, "deep");
    ASSERT_FALSE(nested);
    EXPECT_NE(nested.error().what.find("nested deeper"), std::string::npos);
    ParseOptions small;
    small.maximumBytes = 100;
    EXPECT_NE(parseScenario(goodText(), "huge", small).error().what.find("larger"), std::string::npos);
    EXPECT_FALSE(parseScenario("", "empty"));
    EXPECT_FALSE(parseScenario("hello", "text"));
    EXPECT_FALSE(parseScenario("<osm/>", "osm"));
    EXPECT_FALSE(parseScenario(std::string("\xFF\xFE<\0a\0", 6), "utf16"));
    EXPECT_FALSE(
        parseScenario("<!DOCTYPE x [<!ENTITY a \"&a;&a;\">]><OpenSCENARIO>&a;</OpenSCENARIO>", "bomb"));
}

TEST(ParseErrors, FilesThatAreNoFilesAreRefused)
{
    EXPECT_NE(readScenario("no/such/file.xosc").error().what.find("no such file"), std::string::npos);
    EXPECT_NE(readScenario(testing::TempDir()).error().what.find("not a regular file"), std::string::npos);
    EXPECT_NE(readScenario("/dev/zero").error().what.find("not a regular file"), std::string::npos);
}

TEST(ParseErrors, ACatalogueThatContainsItselfIsRefused)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cycle_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "C.xosc")
        << R"(<OpenSCENARIO><Catalog name="C"><CatalogReference name="x" catalogName="C" entryName="x"/></Catalog></OpenSCENARIO>)";
    ScenarioText text;
    text.catalogs =
        R"(<CatalogLocations><VehicleCatalog><Directory path="."/></VehicleCatalog></CatalogLocations>)";
    text.entities =
        R"(<ScenarioObject name="Ego"><CatalogReference catalogName="C" entryName="x"/></ScenarioObject>)";
    std::ofstream(folder / "test.xosc") << text.text();
    const auto result = readScenario(folder / "test.xosc");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().what.find("contains itself"), std::string::npos) << result.error().message();
    std::filesystem::remove_all(folder);
}

TEST(ParseErrors, MemoryHasNoCatalogues)
{
    ScenarioText text;
    text.catalogs =
        R"(<CatalogLocations><VehicleCatalog><Directory path="/etc"/></VehicleCatalog></CatalogLocations>)";
    EXPECT_FALSE(parseScenario(text.text(), "memory"));
}

} // namespace
} // namespace simulation
