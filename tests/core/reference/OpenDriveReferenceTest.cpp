// SPDX-License-Identifier: Apache-2.0
// docs/reference/opendrive.md against the names that the sources of the reader ask for, and the words of its
// enumerations.
#include <string>

#include <gmock/gmock.h>

#include <osgRoads/core/network/Lane.h>
#include <osgRoads/core/network/Road.h>

#include "SourceNames.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

std::string readerSources()
{
    return reference::sourceTexts("osgRoads/src/core/read", "NodeReader"); // which asks for any name
}

Names readElements(const std::string& source)
{
    Names names = reference::literalsOfCalls(source, {"each", "profile", "readLink", "readRules"}, true);
    std::erase_if(names, [](const std::string& name) { return name.find(' ') != std::string::npos; });
    names.insert("OpenDRIVE"); // the root, which is not asked for as a child
    return names;
}

Names readAttributes(const std::string& source)
{
    Names names = reference::literalsOfCalls(
        source,
        {"text", "id", "number", "numberOr", "optionalNumber", "integer", "flag", "choice", "has", "cubic"},
        true);
    for (const auto& literals : reference::literalsOfCalls(source, "profile"))
        names.insert(literals.back());
    names.merge(reference::literalsOfCalls(source, {"coefficients"}, false));
    for (const char* name : {"north", "south", "east", "west"}) // asked for in a loop
        names.insert(name);
    return names;
}

TEST(OpenDriveReference, DescribesEveryElementAndNoOther)
{
    const Page page = Page::read("opendrive.md");
    const Names names = readElements(readerSources());
    EXPECT_THAT(names, testing::Contains("paramPoly3"));
    EXPECT_EQ(differences(names, page.column("Elements", 0)), "");
    EXPECT_NE(differences(names, page.without("spiral").column("Elements", 0)), "");
    EXPECT_NE(differences(names, page.with("Elements", "station").column("Elements", 0)), "");
}

TEST(OpenDriveReference, NamesEveryAttributeAndNoOther)
{
    const Page page = Page::read("opendrive.md");
    const Names names = readAttributes(readerSources());
    EXPECT_THAT(names, testing::Contains("curvature"));
    EXPECT_EQ(differences(names, page.column("Elements", 1)), "");
    EXPECT_NE(differences(names, page.without("spiral").column("Elements", 1)), "");
}

template<class Keywords>
Names wordsOf(const Keywords& keywords)
{
    Names names;
    for (const auto& [word, value] : keywords)
        names.emplace(word);
    return names;
}

TEST(OpenDriveReference, NamesTheWordsOfEachChoice)
{
    using namespace osgRoads::core;
    const Page page = Page::read("opendrive.md");
    EXPECT_EQ(differences(wordsOf(kLaneTypes), page.wordsBeside("Words", "lane/type")), "");
    EXPECT_EQ(differences(wordsOf(kLaneDirections), page.wordsBeside("Words", "lane/direction")), "");
    EXPECT_EQ(differences(wordsOf(kMarkTypes), page.wordsBeside("Words", "roadMark/type")), "");
    EXPECT_EQ(differences(wordsOf(kMarkColours), page.wordsBeside("Words", "roadMark/color")), "");
    EXPECT_EQ(differences(wordsOf(kMarkWeights), page.wordsBeside("Words", "roadMark/weight")), "");
    EXPECT_EQ(differences(wordsOf(kLaneChanges), page.wordsBeside("Words", "roadMark/laneChange")), "");
    EXPECT_EQ(differences(wordsOf(kContactPoints), page.wordsBeside("Words", "contactPoint")), "");
    EXPECT_EQ(differences(wordsOf(kJunctionTypes), page.wordsBeside("Words", "junction/type")), "");
}

} // namespace
