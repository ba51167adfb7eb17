// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "PmCheckSums.h"
#include "Random.h"
#include "SimplifyMeshes.h"
#include "TestFolder.h"

namespace
{

using namespace osgPMObjects::core;

/// A mesh with all vertex attributes and two materials.
ProgressiveMesh subject(std::uint32_t side = 22)
{
    Mesh mesh = testsupport::together(testsupport::texturedInHalves(side, side), testsupport::waves(7, 9),
                                      {40.0, 0.0, 3.0});
    for (std::uint32_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge)
    {
        const double x = 0.37 * wedge;
        mesh.normals.push_back(glm::vec3(glm::normalize(glm::dvec3(std::sin(x), std::cos(2 * x), 0.4))));
        mesh.colours.push_back({0.5 + 0.5 * std::sin(x), 0.25, 0.75, 1.0});
    }
    mesh.materials[1].isTwoSided = true;
    return buildProgressiveMesh(mesh, simplify(mesh), {.blockFaces = 64});
}

foundation::Result<ProgressiveMesh> parsed(const std::string& bytes)
{
    std::istringstream stream(bytes);
    PmReader reader(stream, "test.pm");
    while (true)
    {
        const auto more = reader.readMore();
        if (!more) return more.error();
        if (!*more) return reader.mesh();
    }
}

std::vector<Triangle> drawnAfter(const ProgressiveMesh& mesh, std::uint32_t steps)
{
    ProgressiveLevel level(mesh);
    level.moveTo(steps);
    std::vector<SlotRange> ranges;
    for (std::uint32_t group = 0; group < mesh.groups.size(); ++group)
        level.appendRanges(group, ranges);
    std::vector<Triangle> faces;
    for (const SlotRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            faces.push_back(level.face(slot));
    return faces;
}

TEST(PmFile, BringsEverythingBack)
{
    const ProgressiveMesh mesh = subject();
    const std::string bytes = pmBytes(mesh);
    const auto back = parsed(bytes);
    ASSERT_TRUE(back) << back.error().what;
    EXPECT_EQ(back->mesh.positions, mesh.mesh.positions);
    EXPECT_EQ(back->mesh.wedgePositions, mesh.mesh.wedgePositions);
    EXPECT_EQ(back->mesh.normals, mesh.mesh.normals);
    EXPECT_EQ(back->mesh.texCoords, mesh.mesh.texCoords);
    EXPECT_EQ(back->mesh.colours, mesh.mesh.colours);
    EXPECT_EQ(back->mesh.materials, mesh.mesh.materials);
    EXPECT_EQ(back->parents, mesh.parents);
    EXPECT_EQ(back->groups, mesh.groups);
    EXPECT_EQ(back->blocks, mesh.blocks);
    EXPECT_EQ(back->base, mesh.base);
    EXPECT_EQ(back->records, mesh.records);
    EXPECT_EQ(back->errors, mesh.errors);
    EXPECT_EQ(back->stepCount, mesh.stepCount);
    EXPECT_EQ(pmBytes(*back), bytes);
}

TEST(PmFile, IsACoarserMeshAfterEverySection)
{
    const ProgressiveMesh mesh = subject();
    std::istringstream stream(pmBytes(mesh));
    PmReader reader(stream, "test.pm");
    std::uint32_t last = ~0u, sections = 0;
    while (true)
    {
        const auto more = reader.readMore();
        ASSERT_TRUE(more) << more.error().what;
        if (!*more) break;
        const auto soFar = reader.mesh();
        ASSERT_TRUE(soFar) << soFar.error().what;
        ASSERT_TRUE(isValid(*soFar));
        EXPECT_EQ(reader.totalSteps(), mesh.stepCount);
        const std::uint32_t missing = mesh.stepCount - soFar->stepCount;
        EXPECT_LT(missing, last);
        last = missing;
        ++sections;
        for (std::uint32_t steps = 0; steps <= soFar->stepCount; steps += 17)
        {
            EXPECT_EQ(drawnAfter(*soFar, steps), drawnAfter(mesh, steps + missing));
            EXPECT_EQ(errorAfter(*soFar, steps), errorAfter(mesh, steps + missing));
        }
    }
    EXPECT_EQ(last, 0u);
    EXPECT_GT(sections, 3u);
}

TEST(PmFile, CarriesWhatIsAttached)
{
    PmSettings settings;
    settings.attachment = std::string("a\0b", 3);
    std::istringstream stream(pmBytes(subject(7), settings));
    PmReader reader(stream, "test.pm");
    ASSERT_TRUE(reader.readMore());
    EXPECT_EQ(reader.attachment(), std::string("a\0b", 3));
}

TEST(PmFile, QuantisedIsSmallerAndNearEnough)
{
    const ProgressiveMesh mesh = subject();
    PmSettings quantised;
    quantised.quantised = true;
    const std::string bytes = pmBytes(mesh, quantised);
    EXPECT_LT(bytes.size(), 0.6 * pmBytes(mesh).size());
    const auto back = parsed(bytes);
    ASSERT_TRUE(back) << back.error().what;
    EXPECT_EQ(back->records, mesh.records);
    for (std::size_t p = 0; p < mesh.mesh.positions.size(); ++p)
        EXPECT_LT(glm::distance(back->mesh.positions[p], mesh.mesh.positions[p]), 50.0 / 65535.0);
    for (std::size_t w = 0; w < mesh.mesh.wedgeCount(); ++w)
    {
        EXPECT_GT(glm::dot(back->mesh.normals[w], mesh.mesh.normals[w]), 1.0f - 1e-6f);
        EXPECT_LT(glm::distance(back->mesh.texCoords[0][w], mesh.mesh.texCoords[0][w]), 2.0f / 65535.0f);
        EXPECT_LT(glm::distance(back->mesh.colours[w], mesh.mesh.colours[w]), 2.0f / 255.0f);
    }
}

TEST(PmFile, TellsEveryDamagedByteAndEveryCut)
{
    const std::string whole = pmBytes(subject(7));
    for (std::size_t at = 0; at < whole.size(); ++at)
    {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        const auto read = parsed(damaged);
        ASSERT_FALSE(read) << "byte " << at;
        EXPECT_THAT(read.error().place, testing::StartsWith("test.pm"));
    }
    for (std::size_t length = 0; length < whole.size(); length += 7)
        ASSERT_FALSE(parsed(whole.substr(0, length))) << "cut to " << length;
}

TEST(PmFile, RefusesNonsenseThatHasTheRightCheckSum)
{
    const std::string whole = pmBytes(subject(7));
    testsupport::Random random(5);
    std::size_t refused = 0;
    constexpr std::size_t kTries = 3000;
    for (std::size_t i = 0; i < kTries; ++i)
    {
        std::string damaged = whole;
        for (std::uint32_t change = 0; change < 1 + i % 3; ++change)
            damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] =
                static_cast<char>(random.below(256));
        testsupport::renewCheckSums(damaged);
        const auto read = parsed(damaged);
        refused += !read;
        EXPECT_TRUE(!read || isValid(*read)); // other vertices, for instance
    }
    EXPECT_GT(refused, kTries / 10);
}

TEST(PmFile, DoesNotAskForMemoryThatItsFacesCannotNeed)
{
    std::string bytes = pmBytes(subject(7));
    constexpr std::size_t kSlotCount =
        12 + 12 + 3 * 4;          // behind the magic, and in the head three counts before it
    bytes[kSlotCount + 3] = 0x3f; // a billion
    testsupport::renewCheckSums(bytes);
    const auto read = parsed(bytes);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, testing::HasSubstr("head"));
}

TEST(PmFile, WhatIsNoMeshIsAnError)
{
    EXPECT_THAT(parsed("solid cube").error().what, testing::HasSubstr("not a progressive mesh"));
    const auto missing = readPm("no/such/file.pm");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().place, "no/such/file.pm");
}

TEST(ProgressiveMesh, OfWhichAStepIsWrongIsNotValid)
{
    const ProgressiveMesh mesh = subject(7);
    ASSERT_TRUE(isValid(mesh));
    std::size_t told = 0, tries = 0;
    for (std::size_t at = 0; at + 4 < mesh.records.size(); ++at)
    {
        ProgressiveMesh wrong = mesh;
        wrong.records[at] ^= std::byte{1};
        told += !isValid(wrong);
        ++tries;
    }
    EXPECT_GT(told, tries / 3); // the others lead up to another mesh, and back: no index leaves its array
    ProgressiveMesh wrong = mesh;
    wrong.parents[wrong.parents.size() - 1] = wrong.parents.size();
    EXPECT_FALSE(isValid(wrong));
    wrong = mesh;
    wrong.blocks[0].extent += 1;
    EXPECT_FALSE(isValid(wrong));
    wrong = mesh;
    wrong.stepCount -= 1;
    EXPECT_FALSE(isValid(wrong));
    wrong = mesh;
    wrong.mostSlotsMoved = 1;
    EXPECT_FALSE(isValid(wrong));
}

} // namespace
