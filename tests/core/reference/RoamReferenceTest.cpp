// SPDX-License-Identifier: Apache-2.0
// docs/reference/roam-file.md against the keys and words that the reader tells in its errors.
#include <sstream>

#include <gmock/gmock.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/cover/CoverTable.h>

#include "MarkdownTable.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

/// The names after the colon of a remedy: "known keys: a, b".
Names listed(const std::string& remedy)
{
    Names names;
    std::istringstream stream(remedy.substr(remedy.find(": ") + 2));
    for (std::string name; std::getline(stream, name, ',');)
        names.insert(name.substr(name.find_first_not_of(' ')));
    return names;
}

Names roamWords(const std::string& text)
{
    const auto parsed = osgTerrainROAM::core::parseRoamFile(text, "probe.roam");
    return parsed ? Names{} : listed(parsed.error().remedy);
}

Names groundKinds()
{
    const auto table = osgTerrainROAM::core::parseCoverTable("1 = nonsense", "probe.txt");
    return table ? Names{} : listed(table.error().remedy);
}

TEST(RoamReference, DescribesEveryKeyAndNoOther)
{
    const Page page = Page::read("roam-file.md");
    const Names keys = roamWords("nonsense = 1");
    EXPECT_EQ(differences(keys, page.column("Keys", 0)), "");
    EXPECT_NE(differences(keys, page.without("aridity").column("Keys", 0)), "");
    EXPECT_NE(differences(keys, page.with("Keys", "invented").column("Keys", 0)), "");
}

TEST(RoamReference, NamesTheWordsOfEachKey)
{
    const Page page = Page::read("roam-file.md");
    for (const char* key : {"voids", "placement", "vertical_datum"})
    {
        const Names words = roamWords(std::string(key) + " = nonsense");
        EXPECT_FALSE(words.empty()) << key;
        for (const std::string& word : words)
            EXPECT_THAT(page.wordsBeside("Keys", key), testing::Contains(word)) << key;
    }
}

TEST(RoamReference, NamesTheKindsOfLandCover)
{
    const Page page = Page::read("roam-file.md");
    EXPECT_EQ(differences(groundKinds(), page.column("A table of classes", 0)), "");
    EXPECT_NE(differences(groundKinds(), page.without("crop").column("A table of classes", 0)), "");
}

} // namespace
