// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/structure/KeepFragments.h>

#include "HillSurface.h"
#include "MtCheckSums.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

void writeBytes(const std::filesystem::path& file, const std::string& bytes)
{
    std::ofstream(file, std::ios::binary) << bytes;
}

ForestOptions sevenRectangles()
{
    ForestOptions options;
    options.treeCount = 7;
    return options;
}

/// All trees of a file that can be read, and how many cannot.
struct WholeRead
{
    Forest forest;
    std::vector<std::string> complaints;
};

WholeRead readAll(const MtFile& file)
{
    WholeRead all;
    std::vector<std::optional<ReadTree>> read(file.info().trees.size());
    for (std::uint32_t t = 0; t < read.size(); ++t)
    {
        const std::uint32_t parent = file.info().trees[t].parent;
        if (parent != kNone && !read[parent]) continue; // below a damaged one
        auto tree = file.read(t, parent == kNone ? nullptr : &*read[parent]);
        if (tree)
            read[t] = std::move(*tree);
        else
            all.complaints.push_back(tree.error().message());
    }
    for (auto& tree : read)
        if (tree) all.forest.trees.push_back(tree->tree);
    return all;
}

TEST(MtFile, holdsTheForestThatWasBuilt)
{
    const testsupport::TestFolder folder("mt-file");
    for (const double roughness : {4.0, 4.1}) // heights in steps of 1/64 m; and of nothing
    {
        SurfaceMesh mesh = testsupport::hillSurface(60, 50, roughness);
        if (roughness != 4.0)
            for (SurfacePoint& p : mesh.points)
                p.height *= 0.1;
        const std::filesystem::path file = folder / "hills.mt";
        const PlanFrame frame{1000.5, -20.25, 30.0, 30.0};
        const auto report = buildMtFile(mesh, frame, sevenRectangles(), file);
        ASSERT_TRUE(report) << report.error().message();
        EXPECT_FALSE(std::filesystem::exists(folder / "hills.mt.parts"));
        const auto opened = MtFile::open(file);
        ASSERT_TRUE(opened) << opened.error().message();
        EXPECT_EQ(opened->info().frame, frame);
        EXPECT_EQ(opened->info().points, mesh.points.size());
        const WholeRead read = readAll(*opened);
        EXPECT_TRUE(read.complaints.empty());
        EXPECT_EQ(read.forest.trees, buildForest(mesh, sevenRectangles())->forest.trees);
        EXPECT_EQ(checkStructure(read.forest), std::nullopt);
    }
}

/// A plan that lies somewhere in a reference system.
PlanFrame placedFrame()
{
    PlanFrame frame{0.0, 0.0, 30.0, 30.0};
    frame.reference = PlanReference{"GEOGCS[\"WGS 84\",DATUM[…]]", 7.5, 46.25, 1.0 / 3600.0, 1.0 / 3600.0};
    return frame;
}

TEST(MtFile, keepsThePlaceOfThePlanInItsReferenceSystem)
{
    const testsupport::TestFolder folder("mt-file");
    const SurfaceMesh mesh = testsupport::hillSurface(60, 50);
    ASSERT_TRUE(buildMtFile(mesh, placedFrame(), sevenRectangles(), folder / "placed.mt"));
    ASSERT_TRUE(buildMtFile(mesh, {0.0, 0.0, 30.0, 30.0}, sevenRectangles(), folder / "plain.mt"));
    const auto placed = MtFile::open(folder / "placed.mt"), plain = MtFile::open(folder / "plain.mt");
    ASSERT_TRUE(placed) << placed.error().message();
    EXPECT_EQ(placed->info().frame, placedFrame());
    EXPECT_EQ(nameOf(*placed->info().frame.reference), "WGS 84");
    EXPECT_EQ(placed->version(), 3u);
    EXPECT_EQ(plain->version(), 2u) << "older programs read what has none";
    EXPECT_FALSE(plain->info().frame.reference);
    const WholeRead read = readAll(*placed);
    EXPECT_TRUE(read.complaints.empty());
    EXPECT_EQ(read.forest.trees, readAll(*plain).forest.trees);
}

TEST(MtFile, aDamagedOrCutReferenceSystemIsTold)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path file = folder / "placed.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), placedFrame(), sevenRectangles(), file));
    const std::string bytes = testsupport::bytesOf(file);
    const std::size_t end = MtFile::open(file)->info().trees[0].offset;
    const std::size_t first = end - 40 - placedFrame().reference->system.size();
    for (std::size_t at = first; at < end; ++at)
    {
        std::string damaged = bytes;
        damaged[at] ^= 0x40;
        writeBytes(file, damaged);
        const auto opened = MtFile::open(file);
        ASSERT_FALSE(opened) << at;
        EXPECT_NE(opened.error().message().find("reference system"), std::string::npos)
            << opened.error().message();
        writeBytes(file, bytes.substr(0, at));
        EXPECT_FALSE(MtFile::open(file)) << at;
    }
    writeBytes(file, bytes.substr(0, end)); // the control: whole, and no tree behind it
    EXPECT_TRUE(MtFile::open(file));
    std::string moved = bytes;
    moved[first + 4 + 6] ^= 0x01; // of the place of the first sample
    testsupport::renewMtCheckSums(moved);
    writeBytes(file, moved);
    const auto opened = MtFile::open(file);
    ASSERT_TRUE(opened) << "its sum was not made right: " << opened.error().message();
    EXPECT_NE(opened->info().frame.reference->firstX, placedFrame().reference->firstX);
}

TEST(MtFile, aPrefixOfATreeIsATree)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path file = folder / "hills.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, sevenRectangles(), file));
    const auto opened = MtFile::open(file);
    ASSERT_TRUE(opened);
    const std::uint32_t all = opened->info().trees[0].fragments;
    ASSERT_GT(all, 2 * kSectionFragments);
    for (const std::uint32_t fragments : {0u, 1u, 128u, 200u, 256u, all})
    {
        const auto read = opened->read(0, nullptr, fragments);
        ASSERT_TRUE(read);
        EXPECT_EQ(read->tree.part.fragments.size(), wholeSections(all, fragments));
        EXPECT_EQ(checkStructure(read->tree.part), std::nullopt);
        EXPECT_EQ(read->readBytes == opened->info().trees[0].bytes, fragments == all);
    }
}

TEST(MtFile, aTreeReadInPartsAndCutInMemoryIsThatOfTheFile)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path file = folder / "hills.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, sevenRectangles(), file));
    const auto opened = MtFile::open(file);
    ASSERT_TRUE(opened);
    const std::size_t all = opened->info().trees[0].fragments;
    auto read = opened->read(0, nullptr, 0);
    ASSERT_TRUE(read);
    testsupport::Random random(4);
    for (int i = 0; i < 60; ++i)
    {
        const std::size_t wanted =
            i % 7 == 6 ? all : wholeSections(all, random.below(static_cast<std::uint32_t>(all)));
        if (wanted > read->tree.part.fragments.size())
        {
            ASSERT_TRUE(opened->readMore(0, *read, wanted));
        }
        else
        {
            keepFragments(read->tree.part, wanted);
            if (wanted < all) read->childRoots = {};
        }
        const auto fresh = opened->read(0, nullptr, wanted);
        ASSERT_EQ(read->tree, fresh->tree) << wanted;
        ASSERT_EQ(read->childRoots, fresh->childRoots);
    }
}

/// Writes a file anew as version 1 had it: no tables of sections, a checksum for each tree.
void writeVersion1(const MtFile& file, const std::filesystem::path& path)
{
    const std::string bytes = testsupport::bytesOf(file.path());
    std::string head = bytes.substr(0, 80 + 56 * file.info().trees.size()), trees;
    const auto put = [&](std::size_t at, auto value) { std::memcpy(head.data() + at, &value, sizeof value); };
    put(8, std::uint32_t{1});
    for (std::size_t t = 0; t < file.info().trees.size(); ++t)
    {
        const MtEntry& entry = file.info().trees[t];
        const std::size_t table = sectionTableBytes(entry.fragments);
        const std::string tree = bytes.substr(entry.offset + table, entry.bytes - table);
        put(80 + 56 * t, std::uint64_t{head.size() + trees.size()});
        put(80 + 56 * t + 8, static_cast<std::uint32_t>(tree.size()));
        put(80 + 56 * t + 12, testsupport::sumOf(tree));
        trees += tree;
    }
    put(72, testsupport::sumOf(head.substr(80)));
    put(76, testsupport::sumOf(head.substr(0, 76)));
    writeBytes(path, head + trees);
}

TEST(MtFile, aFileOfVersion1IsRead)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path file = folder / "hills.mt", old = folder / "old.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, sevenRectangles(), file));
    const auto opened = MtFile::open(file);
    writeVersion1(*opened, old);
    const auto first = MtFile::open(old);
    ASSERT_TRUE(first) << first.error().message();
    EXPECT_EQ(first->version(), 1u);
    EXPECT_EQ(opened->version(), 2u);
    const WholeRead read = readAll(*first);
    EXPECT_TRUE(read.complaints.empty());
    EXPECT_EQ(read.forest.trees, readAll(*opened).forest.trees);
    auto part = first->read(0, nullptr, kSectionFragments);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->tree, opened->read(0, nullptr, kSectionFragments)->tree);
    ASSERT_TRUE(first->readMore(0, *part, opened->info().trees[0].fragments));
    EXPECT_EQ(part->tree, opened->read(0, nullptr)->tree);
    std::string next = testsupport::bytesOf(file);
    next[8] = 4;
    writeBytes(old, next);
    EXPECT_NE(MtFile::open(old).error().message().find("is of version 4"), std::string::npos);
}

TEST(MtFile, damageLateInATreeLeavesWhatIsBefore)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path file = folder / "hills.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, sevenRectangles(), file));
    std::string bytes = testsupport::bytesOf(file);
    const MtEntry entry = MtFile::open(file)->info().trees[0];
    bytes[entry.offset + entry.bytes / 2] ^= 1;
    writeBytes(file, bytes);
    const auto opened = MtFile::open(file);
    const auto fault = opened->read(0, nullptr);
    ASSERT_FALSE(fault);
    EXPECT_NE(fault.error().message().find("tree 0 is damaged"), std::string::npos);
    const std::uint32_t sound = opened->soundFragments(0);
    EXPECT_GE(sound, kSectionFragments);
    EXPECT_LT(sound, entry.fragments);
    auto read = opened->read(0, nullptr, sound);
    ASSERT_TRUE(read);
    EXPECT_FALSE(opened->readMore(0, *read, entry.fragments));
    EXPECT_EQ(read->tree.part.fragments.size(), sound);
    EXPECT_EQ(checkStructure(read->tree.part), std::nullopt);
}

TEST(MtFile, aBuildThatWasStoppedAnywhereGoesOnToTheSameBytes)
{
    const testsupport::TestFolder folder("mt-file");
    const SurfaceMesh mesh = testsupport::hillSurface(60, 50);
    const std::filesystem::path whole = folder / "whole.mt", file = folder / "hills.mt";
    const auto report = buildMtFile(mesh, {}, sevenRectangles(), whole);
    ASSERT_TRUE(report);
    for (std::uint32_t stop = 1; stop < report->trees; ++stop)
    {
        ForestOptions options = sevenRectangles();
        std::uint32_t built = 0;
        options.progress = [&](std::uint32_t, std::uint32_t) { return ++built < stop; };
        EXPECT_FALSE(buildMtFile(mesh, {}, options, file));
        EXPECT_FALSE(std::filesystem::exists(file));
        if (stop % 3 == 0) // a part that was being written
            writeBytes(folder / "hills.mt.parts" / "0.tree", "half");
        if (stop % 3 == 1) // one that was damaged
            for (const auto& entry : std::filesystem::directory_iterator(folder / "hills.mt.parts"))
                if (entry.path().extension() == ".rest")
                    writeBytes(entry.path(), testsupport::bytesOf(entry.path()).substr(1));
        built = 0;
        options.progress = [&](std::uint32_t, std::uint32_t) { return ++built > 0; };
        ASSERT_TRUE(buildMtFile(mesh, {}, options, file));
        if (stop % 3 == 2)
        {
            EXPECT_LT(built, report->trees) << "nothing was taken over";
        }
        EXPECT_EQ(testsupport::bytesOf(file), testsupport::bytesOf(whole)) << stop;
        std::filesystem::remove(file);
    }
}

TEST(MtFile, partsOfAnotherInputAreNotTaken)
{
    const testsupport::TestFolder folder("mt-file");
    SurfaceMesh mesh = testsupport::hillSurface(40, 40);
    const std::filesystem::path whole = folder / "whole.mt", file = folder / "hills.mt";
    ForestOptions options = sevenRectangles();
    options.progress = [](std::uint32_t done, std::uint32_t) { return done < 5; };
    ASSERT_FALSE(buildMtFile(mesh, {}, options, file));
    mesh.points[17].height += 1.0;
    ASSERT_TRUE(buildMtFile(mesh, {}, sevenRectangles(), whole));
    ASSERT_TRUE(buildMtFile(mesh, {}, sevenRectangles(), file));
    EXPECT_EQ(testsupport::bytesOf(file), testsupport::bytesOf(whole));
}

TEST(MtFile, damageIsToldForEachTreeAndTheOthersStay)
{
    const testsupport::TestFolder folder("mt-file");
    const std::filesystem::path good = folder / "good.mt", bad = folder / "bad.mt";
    ASSERT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, sevenRectangles(), good));
    const std::string bytes = testsupport::bytesOf(good);
    const auto opened = MtFile::open(good);
    ASSERT_TRUE(opened);
    const std::size_t trees = opened->info().trees.size();
    const std::uint32_t last = static_cast<std::uint32_t>(trees) - 1;
    std::string flipped = bytes;
    flipped[opened->info().trees[last].offset + 40] ^= 4;
    writeBytes(bad, flipped);
    WholeRead read = readAll(*MtFile::open(bad));
    ASSERT_EQ(read.complaints.size(), 1u);
    EXPECT_NE(read.complaints[0].find("tree " + std::to_string(last) + " is damaged"), std::string::npos)
        << read.complaints[0];
    EXPECT_EQ(read.forest.trees.size(), trees - 1);
    writeBytes(bad, bytes.substr(0, opened->info().trees[2].offset + 10));
    read = readAll(*MtFile::open(bad));
    EXPECT_GE(read.forest.trees.size(), 1u);
    EXPECT_FALSE(read.complaints.empty());
    EXPECT_NE(read.complaints[0].find("ends before"), std::string::npos) << read.complaints[0];
    for (std::size_t at = 0; at < 80 + 56 * trees; ++at) // header and directory
    {
        flipped = bytes;
        flipped[at] ^= 16;
        writeBytes(bad, flipped);
        EXPECT_FALSE(MtFile::open(bad)) << at;
    }
}

TEST(MtFile, bytesThatAreNoTreeAreRefused) // behind the checksum
{
    const BuiltForest built = *buildForest(testsupport::hillSurface(30, 30), sevenRectangles());
    TreeRecord record{built.forest.trees[0].part,
                      {built.forest.trees[1].parentTriangles, built.forest.trees[2].parentTriangles}};
    const double step = 1.0 / 64.0;
    const std::vector<std::byte> good = encodeTree(record, step);
    ASSERT_EQ(decodeTree(good, step), record);
    testsupport::Random random(5);
    for (int i = 0; i < 20000; ++i)
    {
        std::vector<std::byte> bad = good;
        for (std::uint32_t n = 1 + random.below(3); n > 0; --n)
            bad[random.below(static_cast<std::uint32_t>(bad.size()))] =
                static_cast<std::byte>(random.below(256));
        if (random.below(4) == 0) bad.resize(random.below(static_cast<std::uint32_t>(bad.size())));
        if (const auto decoded = decodeTree(bad, step))
        {
            EXPECT_EQ(checkStructure(decoded->part), std::nullopt);
        }
    }
}

TEST(MtFile, missingAndForeignFilesAreTold)
{
    const testsupport::TestFolder folder("mt-file");
    EXPECT_NE(MtFile::open(folder / "none.mt").error().message().find("cannot be opened"), std::string::npos);
    writeBytes(folder / "text.mt", "hello");
    EXPECT_NE(MtFile::open(folder / "text.mt").error().message().find("not a .mt file"), std::string::npos);
    const auto report =
        buildMtFile(testsupport::hillSurface(20, 20), {}, {}, folder / "no" / "such" / "x.mt");
    EXPECT_TRUE(report) << "folders of the parts are made, and with them that of the file";
}

} // namespace

} // namespace osgMultiTriangulation::core
