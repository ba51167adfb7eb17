// SPDX-License-Identifier: Apache-2.0
#include <foundation/ReadableFile.h>
#include <gtest/gtest.h>

#include "TestFolder.h"

namespace
{

std::string whyNot(const std::filesystem::path& file)
{
    const auto readable = foundation::checkReadable(file);
    return readable ? "" : readable.error().what;
}

TEST(ReadableFile, IsOneWithBytes)
{
    const testsupport::TestFolder folder("readable");
    EXPECT_EQ(whyNot(folder.write("a.obj", "v 0 0 0\n")), "");
}

TEST(ReadableFile, TellsWhatIsInTheWay)
{
    const testsupport::TestFolder folder("readable");
    EXPECT_EQ(whyNot(folder / "none.obj"), "there is no such file");
    EXPECT_EQ(whyNot(folder / ""), "is a folder");
    EXPECT_EQ(whyNot(folder.write("empty.obj", "")), "is empty");
    EXPECT_EQ(whyNot(std::string(5000, 'x')).find("cannot be opened: "), 0u);
    EXPECT_EQ(whyNot("/dev/null"), "is a device or a pipe");
    EXPECT_EQ(whyNot("/proc/self/mem").find("cannot be read: "), 0u) << whyNot("/proc/self/mem");
}

} // namespace
