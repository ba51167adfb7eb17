// SPDX-License-Identifier: Apache-2.0
// docs/reference/aircraft-file.md against the elements, attributes and parts that the reader knows.
#include <sstream>

#include <gmock/gmock.h>

#include "SourceNames.h"
#include "simulation/vehicle/flight/AircraftData.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

const std::string& readerSource()
{
    static const std::string source = reference::sourceText("simulation/vehicle/flight/AircraftFile.cpp") +
                                      reference::sourceText("simulation/vehicle/HullFile.cpp");
    return source;
}

/// Attributes are listed by onlyAttributes(node, "several names"), text of adjacent literals.
Names attributes()
{
    Names names{"key", "name"};
    for (const auto& literals : reference::literalsOfCalls(readerSource(), "onlyAttributes"))
        for (const std::string& list : literals)
        {
            std::istringstream words(list);
            for (std::string word; words >> word;)
                names.insert(word);
        }
    for (const char* ofCoefficients : {"part", "over", "across"})
        names.erase(ofCoefficients);
    return names;
}

Names attributesOf(const Page& page)
{
    Names names = page.column("Elements", 1);
    for (const char* heading : {"box", "engine", "propeller"})
        names.merge(page.column(heading, 0));
    for (const char* ofCoefficients : {"part", "over", "across"})
        names.erase(ofCoefficients);
    return names;
}

TEST(AircraftReference, NamesEveryAttributeAndNoOther)
{
    const Page page = Page::read("aircraft-file.md");
    EXPECT_THAT(attributes(), testing::Contains("manifoldLagS"));
    EXPECT_EQ(differences(attributes(), attributesOf(page)), "");
    EXPECT_NE(differences(attributes(), attributesOf(page.without("manifoldLagS"))), "");
    EXPECT_NE(differences(attributes(), attributesOf(page.with("engine", "inventedS"))), "");
}

TEST(AircraftReference, NamesEveryPartAndArgument)
{
    const Page page = Page::read("aircraft-file.md");
    const Names parts(simulation::kPartNames.begin(), simulation::kPartNames.end());
    EXPECT_EQ(differences(parts, page.column("Parts of forces and moments", 0)), "");
    const std::string text = reference::sourceText("docs/reference/aircraft-file.md");
    for (const std::string_view argument : simulation::kArgumentNames)
    {
        if (argument == "none") continue;
        EXPECT_THAT(text, testing::HasSubstr("`" + std::string(argument) + "`"));
    }
}

} // namespace
