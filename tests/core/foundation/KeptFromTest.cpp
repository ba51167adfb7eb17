// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include <foundation/KeptFrom.h>
#include <foundation/SoleFile.h>
#include <gtest/gtest.h>

#include "TestFolder.h"

namespace foundation
{
namespace
{

std::optional<std::string> same(std::string_view bytes)
{
    return std::string(bytes);
}

TEST(KeptFrom, IsFoundForTheSameMarkAlone)
{
    const testsupport::TestFolder folder("kept-from");
    const auto results = std::make_shared<const KeptResults>(folder / "made");
    int made = 0;
    const auto ask = [&](const KeptFrom& kept, std::uint64_t more)
    {
        return kept.findOrMake(
            "word", ContentMark().addWord(more), same, [&] { return std::to_string(++made); },
            [](const std::string& word) { return word; });
    };
    const KeptFrom hills(results, ContentMark().add(std::string_view("hills"))),
        plain(results, ContentMark().add(std::string_view("plain")));
    EXPECT_EQ(ask(hills, 1), "1");
    EXPECT_EQ(ask(hills, 1), "1");
    EXPECT_EQ(ask(hills, 2), "2");
    EXPECT_EQ(ask(plain, 1), "3");
    EXPECT_EQ(ask(plain.withoutMark(), 1), "4");
    EXPECT_EQ(ask(hills.withoutMark(), 1), "4");
}

TEST(KeptFrom, WithoutAMarkNothingIsKept)
{
    const testsupport::TestFolder folder("kept-from-none");
    const KeptFrom none(std::make_shared<const KeptResults>(folder / "made"), std::nullopt);
    EXPECT_FALSE(none);
    EXPECT_EQ(
        none.findOrMake(
            "word", {}, same, [] { return std::string("a"); }, [](const std::string& word) { return word; }),
        "a");
    EXPECT_FALSE(std::filesystem::exists(folder / "made"));
}

TEST(KeptFrom, FailuresAreNotKept)
{
    const testsupport::TestFolder folder("kept-from-failure");
    const KeptResults kept(folder / "made");
    const auto write = [](const std::string& word) { return word; };
    const auto fail = []() -> Result<std::string> {
        return Error{"a", "b", "c"};
    };
    EXPECT_FALSE(kept.findOrMake("word", {}, same, fail, write));
    const auto make = []() -> Result<std::string> { return std::string("made"); };
    EXPECT_EQ(*kept.findOrMake("word", {}, same, make, write), "made");
    EXPECT_EQ(*kept.findOrMake("word", {}, same, fail, write), "made"); // found
}

TEST(KeptFrom, WhatIsReadOfAFileFollowsFromItsBytes)
{
    const testsupport::TestFolder folder("kept-from-file");
    const KeptFrom kept(std::make_shared<const KeptResults>(folder / "made"), ContentMark());
    int made = 0;
    const auto ask = [&](const char* name, std::uint64_t more)
    {
        return kept.findOrRead(
            "word", folder / name, ContentMark().addWord(more), same, [&] { return std::to_string(++made); },
            [](const std::string& word) { return word; });
    };
    std::ofstream(folder / "a.gpkg") << "hills";
    EXPECT_EQ(ask("a.gpkg", 1), "1");
    EXPECT_EQ(ask("a.gpkg", 1), "1");
    EXPECT_EQ(ask("a.gpkg", 2), "2");
    std::ofstream(folder / "a.gpkg") << "plain";
    EXPECT_EQ(ask("a.gpkg", 1), "3");
    EXPECT_EQ(ask("none.gpkg", 1), "4") << "it has no mark, and is read each time";
    EXPECT_EQ(ask("none.gpkg", 1), "5");
}

TEST(SoleFile, HasAMarkWhereNothingBesideItCounts)
{
    const testsupport::TestFolder folder("sole-file");
    const auto write = [&](const char* name, const char* text)
    {
        std::ofstream(folder / name) << text;
        return markOfSoleFile(folder / name);
    };
    const auto trees = write("trees.gpkg", "trees"), cover = write("cover.tif", "cover");
    ASSERT_TRUE(trees && cover);
    EXPECT_NE(*trees, *cover);
    EXPECT_EQ(write("wood.gpkg", "trees"), trees);
    EXPECT_EQ(write("trees.edits", "x"), std::nullopt); // of another kind
    EXPECT_EQ(markOfSoleFile(folder / "trees.gpkg"), trees);
    EXPECT_EQ(markOfSoleFile(folder / "none.gpkg"), std::nullopt);
    EXPECT_NE(write("trees.gpkg", "other"), trees);
    write("trees.gpkg-wal", "changes");
    EXPECT_EQ(markOfSoleFile(folder / "trees.gpkg"), std::nullopt);
    write("cover.tfw", "1 0 0 1 0 0");
    EXPECT_EQ(markOfSoleFile(folder / "cover.tif"), std::nullopt);
}

} // namespace
} // namespace foundation
