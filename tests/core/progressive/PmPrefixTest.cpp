// SPDX-License-Identifier: Apache-2.0
// The beginning of a `.pm` file: what it holds, and how much of the file that is.
#include <algorithm>
#include <array>
#include <sstream>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "PmCheckSums.h"
#include "Random.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// Leaf cards all around: most of their corners are in no face of a coarse level.
Mesh crown(std::uint32_t cards)
{
    testsupport::Random random(11);
    Mesh mesh;
    mesh.materials.emplace_back();
    mesh.materials.back().attributes = Material::texCoord0;
    mesh.parts.emplace_back();
    for (std::uint32_t card = 0; card < cards; ++card)
    {
        const auto direction = [&]
        { return glm::dvec3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5); };
        const glm::dvec3 middle = 4.0 * direction(), along = glm::normalize(direction()) * 0.2;
        const glm::dvec3 across = glm::normalize(glm::cross(along, direction())) * 0.2;
        for (int corner = 0; corner < 4; ++corner)
        {
            const double s = corner == 1 || corner == 2 ? 1.0 : 0.0, t = corner >= 2 ? 1.0 : 0.0;
            mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(middle + s * along + t * across);
            mesh.texCoords[0].push_back({s, t});
        }
        const std::uint32_t first = 4 * card;
        mesh.faces.push_back({{first, first + 1, first + 2}, 0, 0});
        mesh.faces.push_back({{first, first + 2, first + 3}, 0, 0});
    }
    return mesh;
}

ProgressiveMesh crownLevels()
{
    const Mesh mesh = crown(600);
    return buildProgressiveMesh(mesh, simplify(mesh), {.blockFaces = 64});
}

/// Returns letters and size of each section.
std::vector<std::pair<std::string, std::size_t>> sectionsOf(const std::string& bytes)
{
    std::vector<std::pair<std::string, std::size_t>> sections;
    for (std::size_t at = 12; at + 16 <= bytes.size();)
    {
        std::uint64_t length = 0;
        for (int i = 7; i >= 0; --i)
            length = length << 8 | static_cast<unsigned char>(bytes[at + 4 + static_cast<std::size_t>(i)]);
        sections.emplace_back(bytes.substr(at, 4), length);
        at += 16 + length;
    }
    return sections;
}

/// The faces of a level as positions in space.
std::vector<std::array<glm::dvec3, 3>> cornersAfter(const ProgressiveMesh& mesh, std::uint32_t steps)
{
    const Mesh level = meshAfter(mesh, steps);
    std::vector<std::array<glm::dvec3, 3>> corners;
    for (const Face& face : level.faces)
        corners.push_back({level.at(face, 0), level.at(face, 1), level.at(face, 2)});
    return corners;
}

TEST(PmPrefix, HasTheVerticesThatItsFacesNeedAndNoOthers)
{
    const ProgressiveMesh mesh = crownLevels();
    const std::size_t left = mesh.mesh.positions.size() - mesh.stepCount;
    ASSERT_GT(left, mesh.mesh.positions.size() / 5) << "a fifth of the crown is removed by no step";
    const std::string bytes = pmBytes(mesh);
    const auto sections = sectionsOf(bytes);
    ASSERT_EQ(sections[4].first, "BASE");
    EXPECT_LT(sections[4].second, 2 * left) << "of 36 bytes a position with its wedge";

    std::istringstream stream(bytes);
    PmReader reader(stream, "crown.pm");
    auto more = reader.readMore();
    for (; more && *more; more = reader.readMore())
    {
        const auto soFar = reader.mesh();
        ASSERT_TRUE(soFar) << soFar.error().message();
        ASSERT_TRUE(isValid(*soFar));
        const std::uint32_t missing = mesh.stepCount - soFar->stepCount;
        for (std::uint32_t steps = 0; steps <= soFar->stepCount; steps += 97)
            ASSERT_EQ(cornersAfter(*soFar, steps), cornersAfter(mesh, steps + missing)) << steps;
    }
    ASSERT_TRUE(more) << more.error().message();
    EXPECT_EQ(reader.mesh()->mesh.positions, mesh.mesh.positions);
    EXPECT_EQ(reader.mesh()->mesh.texCoords, mesh.mesh.texCoords);
}

TEST(PmPrefix, SaysThatItIsOne)
{
    const std::string bytes = pmBytes(crownLevels());
    for (const std::size_t size : {bytes.size() - 3, bytes.size() / 2, std::size_t{20}})
    {
        std::istringstream stream(bytes.substr(0, size));
        PmReader reader(stream, "crown.pm");
        auto more = reader.readMore();
        const bool hasLevel = static_cast<bool>(more);
        while (more && *more)
            more = reader.readMore();
        EXPECT_FALSE(more);
        EXPECT_TRUE(reader.isCutOff());
        EXPECT_TRUE(!hasLevel || reader.mesh());
        EXPECT_EQ(hasLevel, size > 20);
    }
    std::string damaged = bytes;
    damaged[bytes.size() / 2] ^= 1;
    std::istringstream stream(damaged);
    PmReader reader(stream, "crown.pm");
    auto more = reader.readMore();
    while (more && *more)
        more = reader.readMore();
    EXPECT_FALSE(more);
    EXPECT_FALSE(reader.isCutOff()) << "a byte in the middle is another fault";
}

TEST(PmPrefix, ImagesLieBehindTheCoarsestLevelAndLargeOnesLast)
{
    PmSettings settings;
    settings.images = {{"a.png", "png", false, std::string(10, 'a')},
                       {"b.jpg", "jpg", true, std::string(5000, 'b')},
                       {"", "png", false, std::string(1 << 20, 'c')}};
    const std::string bytes = pmBytes(crownLevels(), settings);
    std::vector<std::string> letters;
    std::vector<std::size_t> sizes;
    for (const auto& [name, size] : sectionsOf(bytes))
    {
        letters.push_back(name);
        sizes.push_back(size);
    }
    const auto imageAt = [&](int number)
    {
        auto at = letters.begin();
        for (int i = 0; i <= number; ++i)
            at = std::find(at + (i > 0), letters.end(), "IMAG");
        return at - letters.begin();
    };
    EXPECT_EQ(letters[static_cast<std::size_t>(imageAt(0)) - 1], "BASE");
    EXPECT_GT(imageAt(1), imageAt(0));
    EXPECT_GT(sizes[static_cast<std::size_t>(imageAt(1)) + 1], 5000u)
        << "before the first steps that are larger";
    EXPECT_EQ(letters[static_cast<std::size_t>(imageAt(2)) + 1], "DONE");

    std::istringstream stream(bytes);
    PmReader reader(stream, "images.pm");
    auto more = reader.readMore();
    EXPECT_TRUE(reader.images().empty());
    while (more && *more)
        more = reader.readMore();
    EXPECT_EQ(reader.images(), settings.images);
}

TEST(PmPrefix, VersionOneIsReadAsBefore)
{
    const auto old = readPm(OSGTRAINER_FUZZ_CORPUS "/waves.pm");
    ASSERT_TRUE(old) << old.error().message();
    const std::string again = pmBytes(*old);
    EXPECT_EQ(again[8], 4);
    std::istringstream stream(again);
    PmReader reader(stream, "again.pm");
    auto more = reader.readMore();
    while (more && *more)
        more = reader.readMore();
    ASSERT_TRUE(more) << more.error().message();
    EXPECT_EQ(reader.mesh()->mesh.positions, old->mesh.positions);
    EXPECT_EQ(reader.mesh()->records, old->records);
}

TEST(PmPrefix, RunsOfLaterVerticesAskForNoMoreThanTheFileCanHold)
{
    std::string bytes = pmBytes(crownLevels());
    const std::size_t run = bytes.find("BASE") + 12 + 4; // behind the count of positions
    ASSERT_EQ(static_cast<unsigned char>(bytes[run + 3]), 0x80) << "the first is a run";
    for (const std::string& code : {std::string("\xff\xff\xff\xff"), std::string("\xff\xff\x01\x80", 4),
                                    std::string("\0\0\x01\x80", 4), std::string("\x01\0\0\x80", 4)})
    {
        std::string damaged = bytes;
        damaged.replace(run, 4, code);
        testsupport::renewCheckSums(damaged);
        std::istringstream stream(damaged);
        PmReader reader(stream, "crown.pm");
        EXPECT_FALSE(reader.readMore());
    }
}

} // namespace
