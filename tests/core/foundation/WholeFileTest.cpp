// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iterator>

#include <foundation/WholeFile.h>
#include <foundation/WritableFolder.h>
#include <gtest/gtest.h>

namespace foundation
{
namespace
{

namespace fs = std::filesystem;

class WholeFileTest : public testing::Test
{
protected:
    void SetUp() override
    {
        _folder = fs::path(testing::TempDir()) / ("whole_" + std::string(name()));
        fs::remove_all(_folder);
        fs::create_directories(_folder);
    }
    void TearDown() override { fs::remove_all(_folder); }

    static const char* name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
    static std::string textOf(const fs::path& file)
    {
        std::ifstream stream(file);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(_folder), {}); }

    fs::path _folder;
};

TEST_F(WholeFileTest, ReplacesTheOldTextAndLeavesNothingElse)
{
    ASSERT_TRUE(writeWholeFile(_folder / "a", "a longer first text"));
    ASSERT_TRUE(writeWholeFile(_folder / "a", "second"));
    EXPECT_EQ(textOf(_folder / "a"), "second");
    EXPECT_EQ(entries(), 1);
}

TEST_F(WholeFileTest, WithoutCommitTheOldFileStays)
{
    ASSERT_TRUE(writeWholeFile(_folder / "a", "old"));
    {
        const WholeFile file(_folder / "a");
        std::ofstream(file.written()) << "half of the n";
        EXPECT_EQ(entries(), 2);
    }
    EXPECT_EQ(textOf(_folder / "a"), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(WholeFileTest, ALinkStaysALink)
{
    ASSERT_TRUE(writeWholeFile(_folder / "real", "old"));
    fs::create_symlink("real", _folder / "link");
    ASSERT_TRUE(writeWholeFile(_folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(_folder / "link"));
    EXPECT_EQ(textOf(_folder / "real"), "new");
}

TEST_F(WholeFileTest, SaysWhyItCannot)
{
    const Outcome noFolder = writeWholeFile(_folder / "no" / "a", "text");
    ASSERT_FALSE(noFolder);
    EXPECT_EQ(noFolder.error().place, (_folder / "no" / "a").string());
    EXPECT_NE(noFolder.error().what.find("No such file"), std::string::npos);
    EXPECT_FALSE(checkWritable(_folder / "no" / "a"));
    EXPECT_FALSE(checkWritable(_folder));
    EXPECT_FALSE(writeWholeFile(_folder, "text"));
    EXPECT_EQ(entries(), 0);
}

TEST_F(WholeFileTest, AFullDeviceIsAnError)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const Outcome full = writeWholeFile("/dev/full", std::string(100'000, 'x'));
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().what.find("No space left"), std::string::npos);
    EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(WholeFileTest, CheckingLeavesNothing)
{
    EXPECT_TRUE(checkWritable(_folder / "a"));
    EXPECT_TRUE(checkWritable({}));
    EXPECT_EQ(entries(), 0);
}

TEST_F(WholeFileTest, CheckingAFolderLeavesNothingAndKeepsWhatIsThere)
{
    EXPECT_TRUE(checkFolderWritable(_folder / "a" / "b" / "c", "picture.png"));
    EXPECT_TRUE(checkFolderWritable((_folder / "a" / "b").string() + '/', "picture.png"));
    EXPECT_TRUE(checkFolderWritable({}, "picture.png"));
    EXPECT_EQ(entries(), 0);
    fs::create_directory(_folder / "there");
    EXPECT_TRUE(checkFolderWritable(_folder / "there", "picture.png"));
    EXPECT_TRUE(checkFolderWritable(_folder / "there" / "deeper", "picture.png"));
    EXPECT_TRUE(fs::is_directory(_folder / "there"));
    EXPECT_TRUE(fs::is_empty(_folder / "there"));
}

TEST_F(WholeFileTest, AFolderThatTakesNoFilesIsNamed)
{
    ASSERT_TRUE(writeWholeFile(_folder / "file", "text"));
    for (const fs::path& folder : {_folder / "file", _folder / "file" / "below", fs::path("/proc/none")})
    {
        const Outcome checked = checkFolderWritable(folder, "picture.png");
        ASSERT_FALSE(checked) << folder;
        EXPECT_TRUE(checked.error().place.starts_with(folder.string())) << checked.error().message();
    }
    fs::create_directories(_folder / "taken" / "picture.png");
    EXPECT_FALSE(checkFolderWritable(_folder / "taken", "picture.png"));
    EXPECT_TRUE(fs::is_directory(_folder / "taken" / "picture.png"));
}

} // namespace
} // namespace foundation
