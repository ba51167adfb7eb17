// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <foundation/DataFile.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace
{

/// A working folder of its own, left at the end.
class DataFile : public testing::Test
{
protected:
    DataFile()
    {
        fs::create_directories(folder);
        fs::current_path(folder);
    }
    ~DataFile() override
    {
        fs::current_path(before);
        fs::remove_all(folder);
    }

    fs::path before = fs::current_path();
    fs::path folder = fs::path(testing::TempDir()) / "osgtrainer-data-file";
};

} // namespace

TEST_F(DataFile, OfTheProgramsSourceIsFoundFromAnywhere)
{
    const fs::path car = foundation::dataFile("vehicles/car.xml");
    EXPECT_TRUE(car.is_absolute());
    EXPECT_TRUE(fs::exists(car))
        << car; // the test's program lies in build/bin of the source tree, as the others do
}

TEST_F(DataFile, OfTheWorkingFolderComesFirst)
{
    fs::create_directories("data/vehicles");
    std::ofstream("data/vehicles/car.xml") << "mine";
    EXPECT_EQ(foundation::dataFile("vehicles/car.xml"), fs::path("data/vehicles/car.xml"));
}

TEST_F(DataFile, ThatIsNowhereKeepsTheNameThatItWouldHave)
{
    EXPECT_EQ(foundation::dataFile("vehicles/none.xml"), fs::path("data/vehicles/none.xml"));
}
