// SPDX-License-Identifier: Apache-2.0
// docs/reference/openscenario.md against the names that the sources of the parser ask for, and the words of
// its keywords.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "SourceNames.h"
#include "simulation/parser/Coverage.h"
#include "simulation/scenario/ControllerKinds.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

const std::filesystem::path kParser = "simulation/parser";

std::string parserSources()
{
    return reference::sourceTexts(kParser, "ElementReader"); // which asks for any name
}

bool isElement(const std::string& name)
{
    return name.front() >= 'A' && name.front() <= 'Z' && name.find(' ') == std::string::npos;
}

Names elements(const std::string& source)
{
    Names names = reference::literalsOfCalls(
        source, {"allowChildren", "child", "children", "is", "parseOptionalTrigger"}, false);
    std::erase_if(names, [](const std::string& name) { return !isElement(name); });
    return names;
}

Names attributes(const std::string& source)
{
    Names names =
        reference::literalsOfCalls(source,
                                   {"text", "textOr", "textAssumed", "number", "numberOr", "numberAssumed",
                                    "optionalNumber", "notNegative", "bound", "optionalBound", "count",
                                    "flagOr", "choice", "choiceOr", "choiceAssumed", "has", "attribute"},
                                   true);
    names.merge(reference::literalsOfCalls(
        source,
        {"parseAngleDeg", "parseSimpleObject", "parseEntityRef", "parseSetValue", "parseDeclaredName"},
        false));
    return names;
}

TEST(OpenScenarioReference, DescribesEveryElementAndNoOther)
{
    const Page page = Page::read("openscenario.md");
    const Names names = elements(parserSources());
    EXPECT_THAT(names, testing::Contains("FollowTrajectoryAction"));
    EXPECT_EQ(differences(names, page.column("Elements", 0)), "");
    EXPECT_NE(differences(names, page.without("Wind").column("Elements", 0)), "");
    EXPECT_NE(differences(names, page.with("Elements", "SensorReferenceSet").column("Elements", 0)), "");
}

TEST(OpenScenarioReference, NamesEveryAttributeAndNoOther)
{
    const Page page = Page::read("openscenario.md");
    const Names names = attributes(parserSources());
    EXPECT_THAT(names, testing::Contains("pedestrianCategory"));
    EXPECT_EQ(differences(names, page.column("Elements", 1)), "");
    EXPECT_NE(differences(names, page.without("GeoPosition").column("Elements", 1)), "");
}

TEST(OpenScenarioReference, NamesTheWordsOfTheLanguage)
{
    const std::string keywords = reference::sourceText(kParser / "Keywords.h");
    const Names described = Page::read("openscenario.md").column("Elements", 2);
    std::size_t words = 0;
    for (std::size_t at = keywords.find("{\""); at != std::string::npos; at = keywords.find("{\"", at + 1))
    {
        const std::size_t begin = at + 2;
        EXPECT_THAT(described, testing::Contains(keywords.substr(begin, keywords.find('"', begin) - begin)));
        ++words;
    }
    EXPECT_GT(words, 30u);
}

TEST(OpenScenarioReference, NamesEveryControllerAndNoOther)
{
    const Page page = Page::read("openscenario.md");
    Names names, others;
    for (const simulation::ControllerKind& kind : simulation::controllerKinds())
    {
        names.insert(std::string(kind.name));
        for (const std::string_view other : kind.otherNames)
            if (!other.empty()) others.insert(std::string(other));
    }
    EXPECT_EQ(differences(names, page.column("Controllers", 0)), "");
    EXPECT_EQ(differences(others, page.column("Controllers", 1)), "");
    EXPECT_NE(differences(names, page.without("Driver").column("Controllers", 0)), "");
    EXPECT_NE(differences(names, page.with("Controllers", "SumoController").column("Controllers", 0)), "");
}

TEST(OpenScenarioReference, HasTheCoveragePageOfTheTable)
{
    const std::string page = reference::sourceText("docs/reference/openscenario-coverage.md");
    EXPECT_EQ(page, simulation::coveragePage()) << "write it with `trainer check --coverage`";
    EXPECT_NE(page.substr(1), simulation::coveragePage());
}

TEST(SourceNames, FindsLiteralsOfCallsAlone)
{
    const std::string source =
        R"(child("A").number("b"); grandchild("C"); allow(f(x), {"d", "e"}); make<T>(r, "g"))";
    EXPECT_EQ(reference::literalsOfCalls(source, {"child"}, true), Names{"A"});
    EXPECT_EQ(reference::literalsOfCalls(source, {"allow"}, false), (Names{"d", "e"}));
    EXPECT_EQ(reference::literalsOfCalls(source, {"make"}, false), Names{"g"});
}

} // namespace
