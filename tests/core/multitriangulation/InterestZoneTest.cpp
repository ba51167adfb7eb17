// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/structure/KeepFragments.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

#include "CheckedForest.h"
#include "HillSurface.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Hills of 120 × 100 points in a file of some rectangles.
struct HillFile
{
    testsupport::TestFolder folder{"zone"};
    SurfaceMesh mesh = testsupport::hillSurface(120, 100);
    std::filesystem::path path = folder / "hills.mt";

    explicit HillFile(std::uint32_t trees = 16)
    {
        ForestOptions options;
        options.treeCount = trees;
        EXPECT_TRUE(buildMtFile(mesh, {}, options, path));
    }
};

const ZoneSettings kSettings{15.0, 60.0, 2'000'000, 0.25};

/// An extent of 120 with levels over 100, so that all trees are there in part.
const ZoneSettings kWide{5.0, 105.0, 30'000'000, 0.25};

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
    const HillFile here(4); // of many sections each
    const auto file = MtFile::open(here.path);
    ZoneSettings none = kWide;
    none.hysteresis = 0.0;
    EXPECT_LT(1.5 * static_cast<double>(fly(*file, kWide)), static_cast<double>(fly(*file, none)));
}

/// Moves a zone along y = 50, with the surface checked and refined at each place.
void moveAlong(InterestZone& zone, const testsupport::CheckedSurface& checked, double from, double to)
{
    for (int step = 0; step <= 40; ++step)
    {
        zone.moveTo(from + (to - from) * step / 40.0, 50.0);
        refineTo(zone.extraction(), 0.2f);
        ASSERT_EQ(checked.fault(zone.extraction()), std::nullopt) << step;
    }
}

TEST(InterestZone, anEyeThatRecedesReadsNothing)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    const testsupport::CheckedSurface checked(here.mesh);
    for (const double threshold : {0.0, 0.25, 0.75})
    {
        ZoneSettings settings = kWide;
        settings.hysteresis = threshold;
        const auto zone = InterestZone::open(*file, settings);
        (*zone)->moveTo(119.0, 50.0);
        const std::uint64_t reads = (*zone)->reads();
        const std::size_t memory = (*zone)->memoryBytes();
        moveAlong(**zone, checked, 119.0, 240.0);
        EXPECT_EQ((*zone)->reads(), reads) << threshold;
        EXPECT_LT((*zone)->memoryBytes(), memory / 2) << threshold;
        moveAlong(**zone, checked, 240.0, 119.0); // the control: coming back has to read
        EXPECT_GT((*zone)->reads(), reads) << threshold;
    }
}

TEST(InterestZone, anEyeThatApproachesReadsEachSectionOnce)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    const testsupport::CheckedSurface checked(here.mesh);
    const auto zone = InterestZone::open(*file, kWide);
    moveAlong(**zone, checked, 240.0, 119.0);
    std::uint64_t atOnce = 0, tables = 0;
    for (const MtEntry& tree : file->info().trees)
    {
        atOnce += tree.bytes;
        tables += sectionTableBytes(tree.fragments);
    }
    EXPECT_GT((*zone)->reads(), file->info().trees.size() / 2);
    EXPECT_LT((*zone)->readBytes(), atOnce + (*zone)->reads() * tables / file->info().trees.size());
}

TEST(InterestZone, anEyeThatSwingsReadsNothingWithinTheThreshold)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    const auto readsOf = [&](double threshold)
    {
        ZoneSettings settings = kWide;
        settings.hysteresis = threshold;
        const auto zone = InterestZone::open(*file, settings);
        std::uint64_t before = 0;
        for (int step = 0; step < 100; ++step)
        {
            if (step == 20) before = (*zone)->reads();
            (*zone)->moveTo(60.0 + 3.0 * std::sin(0.3 * step), 50.0);
        }
        return (*zone)->reads() - before;
    };
    EXPECT_EQ(readsOf(0.25), 0u);
    EXPECT_GT(readsOf(0.0), 0u) << "the control";
}

TEST(InterestZone, treesAreThoseOfTheFileHoweverTheyCameAbout)
{
    const HillFile here;
    const auto file = MtFile::open(here.path);
    std::vector<ReadTree> whole;
    for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
        whole.push_back(*file->read(t, t == 0 ? nullptr : &whole[file->info().trees[t].parent]));
    const auto zone = InterestZone::open(*file, kWide);
    std::size_t inPart = 0;
    for (int step = 0; step < 60; ++step)
    {
        (*zone)->moveTo(60.0 + 90.0 * std::sin(0.4 * step), 50.0 + 60.0 * std::cos(0.23 * step));
        refineTo((*zone)->extraction(), 0.0f);
        for (std::uint32_t t = 1; t < whole.size(); ++t)
        {
            if (!(*zone)->extraction().isAttached(t)) continue;
            const MultiTriangulation& part = (*zone)->extraction().part(t);
            MultiTriangulation wanted = whole[t].tree.part;
            if (part.fragments.size() < wanted.fragments.size()) ++inPart;
            keepFragments(wanted, part.fragments.size());
            ASSERT_EQ(part, wanted) << step << ' ' << t;
        }
    }
    EXPECT_GT(inPart, 100u);
}

TEST(InterestZone, aDamagedSectionLeavesThoseBefore)
{
    const HillFile here;
    std::string bytes = testsupport::bytesOf(here.path);
    const auto whole = MtFile::open(here.path);
    const auto last = static_cast<std::uint32_t>(whole->info().trees.size() - 1);
    const MtEntry tree = whole->info().trees[last];
    bytes[tree.offset + tree.bytes - 200] ^= 1;
    std::ofstream(here.path, std::ios::binary) << bytes;
    const auto file = MtFile::open(here.path);
    const std::uint32_t sound = file->soundFragments(last);
    ASSERT_GT(sound, 0u);
    const testsupport::CheckedSurface checked(here.mesh);
    for (const bool isNearAtOnce : {true, false})
    {
        const auto zone = InterestZone::open(*file, kWide);
        const double x = 0.5 * (tree.low[0] + tree.high[0]), y = 0.5 * (tree.low[1] + tree.high[1]);
        for (int step = isNearAtOnce ? 100 : 0; step <= 100; ++step)
        {
            (*zone)->moveTo(x + 100.0 - step, y);
            refineTo((*zone)->extraction(), 0.1f);
            ASSERT_EQ(checked.fault((*zone)->extraction()), std::nullopt) << step;
        }
        EXPECT_EQ((*zone)->faults().size(), 1u);
        ASSERT_TRUE((*zone)->extraction().isAttached(last));
        EXPECT_EQ((*zone)->extraction().part(last).fragments.size(), sound);
    }
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
