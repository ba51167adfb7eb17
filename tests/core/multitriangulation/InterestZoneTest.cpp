// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

#include "CheckedForest.h"
#include "HillSurface.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Hills of 120 × 100 points in a file of 16 rectangles.
struct HillFile
{
    testsupport::TestFolder folder{"zone"};
    SurfaceMesh mesh = testsupport::hillSurface(120, 100);
    std::filesystem::path path = folder / "hills.mt";

    HillFile()
    {
        ForestOptions options;
        options.treeCount = 16;
        EXPECT_TRUE(buildMtFile(mesh, {}, options, path));
    }
};

const ZoneSettings kSettings{15.0, 60.0, 2'000'000, 0.25};

void refineTo(Extraction& extraction, float toleranceM)
{
    extraction.update([toleranceM](const MultiTriangulation& tree, std::uint32_t t)
                      { return tree.errors[t] > toleranceM; });
}

/// Flies along a curve; returns the number of reads.
std::uint64_t fly(const MtFile& file, const ZoneSettings& settings)
{
    const auto zone = InterestZone::open(file, settings);
    for (int step = 0; step < 200; ++step)
        (*zone)->moveTo(60.0 + 55.0 * std::sin(0.031 * step), 50.0 + 45.0 * std::cos(0.023 * step));
    return (*zone)->reads();
}

TEST(TreeIndex, findsWhatALinearScanFinds)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    ASSERT_TRUE(file);
    const TreeIndex index(file->info().trees);
    testsupport::Random random(2);
    for (int i = 0; i < 500; ++i)
    {
        const double x = 140.0 * random.unit() - 10.0, y = 120.0 * random.unit() - 10.0,
                     half = 40.0 * random.unit();
        std::vector<std::uint32_t> scanned;
        for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
        {
            const MtEntry& tree = file->info().trees[t];
            if (tree.low[0] <= x + half && tree.high[0] >= x - half && tree.low[1] <= y + half &&
                tree.high[1] >= y - half)
                scanned.push_back(t);
        }
        ASSERT_EQ(index.near(x, y, half, half), scanned);
    }
}

TEST(InterestZone, isASurfaceWithinItsBoundsAndItsMemoryAllTheWay)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    const testsupport::CheckedSurface checked(here.mesh);
    for (const std::size_t memory : {450'000u, 700'000u, 3'000'000u})
    {
        ZoneSettings settings = kSettings;
        settings.memoryBytes = memory;
        const auto zone = InterestZone::open(*file, settings);
        ASSERT_TRUE(zone) << zone.error().message();
        std::size_t most = 0;
        for (int step = 0; step < 25; ++step) // there and, with an about-face, back
        {
            (*zone)->moveTo(5.0 * (step < 13 ? step : 25 - step), 4.0 * step);
            ASSERT_LE((*zone)->memoryBytes(), memory);
            most = std::max(most, (*zone)->loadedTrees());
            refineTo((*zone)->extraction(), 1.0f);
            ASSERT_EQ(checked.fault((*zone)->extraction()), std::nullopt) << memory << ' ' << step;
        }
        EXPECT_GE(most, 2u);
        EXPECT_TRUE((*zone)->faults().empty());
    }
}

template<class T>
std::size_t takenBy(const std::vector<T>& list)
{
    return list.capacity() * sizeof(T);
}

TEST(InterestZone, noTreeTakesMoreThanItIsCountedWith)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    std::vector<ReadTree> trees;
    for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
    {
        const MtEntry& entry = file->info().trees[t];
        trees.push_back(*file->read(t, t == 0 ? nullptr : &trees[entry.parent]));
        const ReadTree& read = trees.back();
        const MultiTriangulation& part = read.tree.part;
        std::size_t taken = takenBy(part.points) + takenBy(part.corners) + takenBy(part.errors) +
                            takenBy(part.lower) + takenBy(part.upper) + takenBy(part.fragments) +
                            takenBy(part.floors) + takenBy(read.tree.parentTriangles);
        for (const auto& roots : read.childRoots)
            taken += takenBy(roots);
        taken += 12 * std::size_t(part.triangleCount()) + part.fragments.size() / 8; // of the extraction
        EXPECT_LE(taken, InterestZone::bytesOf(entry, entry.fragments)) << t;
    }
}

TEST(InterestZone, nearTheEyeTheSurfaceIsComplete)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    const auto zone = InterestZone::open(*file, kSettings);
    (*zone)->moveTo(30.0, 30.0);
    refineTo((*zone)->extraction(), 0.0f);
    for (const InTree& at : (*zone)->extraction().active())
    {
        const MultiTriangulation& tree = (*zone)->extraction().part(at.tree);
        const SurfacePoint& p = tree.points[tree.corners[at.number][0]];
        if (std::hypot(p.x - 30.0, p.y - 30.0) >= 10.0) continue;
        EXPECT_EQ(tree.errors[at.number], 0.0f);
    }
}

TEST(InterestZone, hysteresisSavesReads)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    ZoneSettings none = kSettings;
    none.hysteresis = 0.0;
    EXPECT_LT(1.5 * static_cast<double>(fly(*file, kSettings)), static_cast<double>(fly(*file, none)));
}

TEST(InterestZone, aDamagedTreeIsToldOnceAndTheSurfaceGoesOnCoarser)
{
    const HillFile here;
    std::string bytes = testsupport::bytesOf(here.path);
    const std::size_t last = MtFile::open(here.path)->info().trees.back().offset + 30;
    bytes[last] = static_cast<char>(bytes[last] ^ 1);
    std::ofstream(here.path, std::ios::binary) << bytes;
    const auto file = MtFile::open(here.path);
    const MtEntry& tree = file->info().trees.back();
    const testsupport::CheckedSurface checked(here.mesh);
    const auto zone = InterestZone::open(*file, kSettings);
    for (int step = 0; step < 5; ++step)
    {
        (*zone)->moveTo(tree.low[0] + step, tree.low[1]);
        refineTo((*zone)->extraction(), 0.5f);
        ASSERT_EQ(checked.fault((*zone)->extraction()), std::nullopt);
    }
    ASSERT_EQ((*zone)->faults().size(), 1u);
    EXPECT_NE((*zone)->faults()[0].find("damaged"), std::string::npos);
    ZoneSettings little = kSettings;
    little.memoryBytes = 1000;
    EXPECT_FALSE(InterestZone::open(*file, little));
}

} // namespace

} // namespace osgMultiTriangulation::core
