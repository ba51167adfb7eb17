// SPDX-License-Identifier: Apache-2.0
// docs/reference/road-vehicle-file.md against the elements and attributes that the reader knows.
#include <sstream>

#include <gmock/gmock.h>

#include "SourceNames.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

const std::string& roadReaderSource()
{
    static const std::string source = reference::sourceText("simulation/vehicle/road/RoadVehicleFile.cpp") +
                                      reference::sourceText("simulation/vehicle/HullFile.cpp");
    return source;
}

Names roadWordsOf(const std::string& function)
{
    Names names;
    for (const auto& literals : reference::literalsOfCalls(roadReaderSource(), function))
        for (const std::string& list : literals)
        {
            std::istringstream words(list);
            for (std::string word; words >> word;)
                names.insert(word);
        }
    return names;
}

Names roadAttributesOf(const Page& page)
{
    Names names = page.column("Elements", 1);
    for (const char* heading : {"roadVehicle", "box", "tyre", "axle", "engine", "gearbox", "converter"})
        names.merge(page.column(heading, 0));
    names.erase("key");
    names.erase("name");
    return names;
}

TEST(RoadVehicleReference, NamesEveryAttributeAndNoOther)
{
    const Page page = Page::read("road-vehicle-file.md");
    const Names attributes = []
    {
        Names names = roadWordsOf("onlyAttributes");
        names.erase("<box>");
        return names;
    }();
    EXPECT_THAT(attributes, testing::Contains("slidingShare"));
    Names onPage = roadAttributesOf(page);
    onPage.erase("<box>");
    EXPECT_EQ(differences(attributes, onPage), "");
    EXPECT_NE(differences(attributes, roadAttributesOf(page.without("slidingShare"))), "");
    EXPECT_NE(differences(attributes, roadAttributesOf(page.with("engine", "inventedS"))), "");
}

TEST(RoadVehicleReference, NamesEveryElement)
{
    Names elements = roadWordsOf("onlyElements");
    elements.insert("source");
    EXPECT_EQ(differences(elements, Page::read("road-vehicle-file.md").column("Elements", 0)), "");
}

} // namespace
