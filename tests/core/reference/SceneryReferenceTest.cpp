// SPDX-License-Identifier: Apache-2.0
// docs/reference/scenery-file.md against the members and words that the reader tells in its errors: a heading
// is the JSON pointer of an object, the rows below it are its members.
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "MarkdownTable.h"
#include "scenery/placement/ReadScenery.h"

namespace
{

using nlohmann::json;
using reference::differences;
using reference::Names;
using reference::Page;

/// A description without a mistake.
json sound()
{
    return json::parse(R"({"fields": [{"name": "a", "count": 1, "objects": [{"kind": "oak"}],
        "where": {"circle": {"radiusM": 10}}}]})");
}

/// What the reader says of a description that has one mistake: the names after the colon.
Names told(const json& description)
{
    const auto read = scenery::parseScenery(description.dump(), "probe.json");
    if (read) return {};
    const std::string& remedy = read.error().remedy;
    Names names;
    std::istringstream stream(remedy.substr(remedy.find(' ') + 1));
    for (std::string word; stream >> word;)
    {
        std::erase(word, ',');
        if (word != "of") names.insert(word);
    }
    return names;
}

/// The members that the object at a pointer can have.
Names membersAt(const std::string& pointer)
{
    json description = sound();
    json& object = pointer == "/" ? description : description[json::json_pointer(pointer)];
    if (pointer == "/budget") object["triangles"] = 1;
    if (pointer.ends_with("/alpha")) object = {{"fadeM", 0}, {"goneM", 1}};
    object["nonsense"] = 1;
    return told(description);
}

TEST(SceneryReference, DescribesEveryMemberAndNoOther)
{
    const Page page = Page::read("scenery-file.md");
    const Names pointers = page.headings("/");
    EXPECT_THAT(pointers, testing::Contains("/fields/0/selection/weights"));
    for (const std::string& pointer : pointers)
        EXPECT_EQ(differences(membersAt(pointer), page.column(pointer, 0)), "") << pointer;
    EXPECT_NE(differences(membersAt("/budget"), page.without("ms").column("/budget", 0)), "");
    EXPECT_NE(differences(membersAt("/budget"), page.with("/budget", "invented").column("/budget", 0)), "");
}

TEST(SceneryReference, HasASectionForEveryObject)
{
    const Page page = Page::read("scenery-file.md");
    const std::map<std::string, Names> nested{
        {"/", {"budget"}},
        {"/fields/0", {"where", "rows", "settlement", "selection", "switching"}},
        {"/fields/0/where", {"circle"}},
        {"/fields/0/selection", {"weights", "alpha"}}};
    for (const auto& [pointer, members] : nested)
        for (const std::string& member : members)
        {
            EXPECT_THAT(membersAt(pointer), testing::Contains(member));
            EXPECT_THAT(page.headings("/"),
                        testing::Contains((pointer == "/" ? "" : pointer) + "/" + member));
        }
}

TEST(SceneryReference, NamesTheWordsOfEachChoice)
{
    const Page page = Page::read("scenery-file.md");
    const std::vector<std::pair<std::string, std::string>> choices{{"/fields/0", "arrangement"},
                                                                   {"/fields/0/objects/0", "kind"},
                                                                   {"/fields/0/selection", "method"},
                                                                   {"/fields/0/switching", "method"},
                                                                   {"/fields/0/switching", "profile"}};
    for (const auto& [pointer, member] : choices)
    {
        json description = sound();
        description[json::json_pointer(pointer)][member] = "nonsense";
        const Names words = told(description);
        EXPECT_GE(words.size(), 2u) << pointer << "/" << member;
        for (const std::string& word : words)
            EXPECT_THAT(page.wordsBeside(pointer, member), testing::Contains(word))
                << pointer << "/" << member;
    }
}

} // namespace
