// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/field/FieldLevels.h>

#include "FieldScenes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

const FieldSubject& subject()
{
    static const FieldSubject made(testsupport::torus(22, 18));
    return made;
}

TEST(FieldLevels, ComeBackFromTheirBytes)
{
    const FieldSubject& of = subject();
    const FieldLevels levels = FieldLevels::of(of.progressive, of.table);
    EXPECT_EQ(levels.ladder.faces, of.ladder.faces);
    const std::string bytes = bytesOf(levels);
    const auto read = fieldLevelsIn(bytes, of.progressive);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(*read), bytes);
    EXPECT_EQ(read->ladder.faces, levels.ladder.faces);
}

TEST(FieldLevels, CutOrLongerBytesAreNone)
{
    const FieldSubject& of = subject();
    const std::string bytes = bytesOf(FieldLevels::of(of.progressive, of.table));
    for (std::size_t size = 0; size < bytes.size(); size += 7)
        EXPECT_FALSE(fieldLevelsIn(bytes.substr(0, size), of.progressive)) << size;
    EXPECT_FALSE(fieldLevelsIn(bytes + "x", of.progressive));
}

TEST(FieldLevels, ThoseThatCannotBeDrawnAreNone)
{
    const FieldSubject& of = subject();
    const FieldLevels sound = FieldLevels::of(of.progressive, of.table);
    const auto isRead = [&](const FieldLevels& levels)
    { return fieldLevelsIn(bytesOf(levels), of.progressive).has_value(); };
    ASSERT_TRUE(isRead(sound));
    FieldLevels spoiled = sound;
    spoiled.ladder.faces.front()[1] = 1U << 30; // a wedge that is not there
    EXPECT_FALSE(isRead(spoiled));
    spoiled = sound;
    spoiled.ladder.rungs.front().wedges = static_cast<std::uint32_t>(of.progressive.mesh.wedgeCount()) + 1;
    EXPECT_FALSE(isRead(spoiled));
    spoiled = sound;
    spoiled.ladder.groups = 2;
    EXPECT_FALSE(isRead(spoiled));
    spoiled = sound;
    spoiled.growth.offsets.resize(1);
    EXPECT_FALSE(isRead(spoiled));
    spoiled = sound;
    spoiled.growth.scales.resize(1);
    EXPECT_FALSE(isRead(spoiled));
}

} // namespace
