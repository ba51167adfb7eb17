// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgPMObjects/core/field/CrownGrowth.h>

#include "FieldScenes.h"
#include "Foliage.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

double areaOfRung(const FieldSubject& subject, std::uint32_t rung, const CrownGrowth* growth)
{
    const LevelLadder& ladder = subject.ladder;
    const Mesh& mesh = subject.progressive.mesh;
    double area = 0.0;
    const SlotRange range = ladder.facesOf(rung, 0);
    for (std::uint32_t f = range.first; f < range.first + range.count; ++f)
    {
        const auto at = [&](std::size_t corner)
        {
            const std::uint32_t wedge = ladder.faces[f][corner];
            const glm::dvec3 p = mesh.positions[mesh.wedgePositions[wedge]];
            if (!growth) return p;
            return p + glm::dvec3(growth->offsets[wedge]) * (growth->scales[rung * ladder.groups] - 1.0);
        };
        area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return area;
}

TEST(CrownGrowth, GivesACrownBackItsShareOfTheAreaThatItLoses)
{
    const FieldSubject subject(testsupport::crown(testsupport::LeafKind::quad, 600, 0.12));
    const CrownGrowth growth = CrownGrowth::of(subject.progressive, subject.ladder);
    ASSERT_EQ(growth.offsets.size(), subject.progressive.mesh.wedgeCount());
    const double whole = areaOfRung(subject, 0, nullptr);
    bool hasGrown = false;
    for (std::uint32_t rung = 0; rung < subject.ladder.rungs.size(); ++rung)
    {
        if (subject.ladder.rungs[rung].faces < 16) break;
        const double left = areaOfRung(subject, rung, nullptr), grown = areaOfRung(subject, rung, &growth);
        const double wanted = left * std::pow(whole / left, CrownGrowth::kShare);
        EXPECT_LE(left, grown * (1.0 + 1e-6));
        EXPECT_LE(grown, whole * (1.0 + 1e-6)) << rung;
        EXPECT_NEAR(grown, wanted, 1e-3 * wanted) << rung;
        hasGrown = hasGrown || (left < 0.5 * whole && grown > 1.25 * left);
    }
    EXPECT_TRUE(hasGrown) << "there was something to give back";
}

TEST(CrownGrowth, DoesNotTouchWhatIsNoFoliage)
{
    const FieldSubject& torus = FieldSubject::torus();
    const CrownGrowth growth = CrownGrowth::of(torus.progressive, torus.ladder);
    EXPECT_TRUE(growth.offsets.empty());
    EXPECT_TRUE(growth.scales.empty());
}

} // namespace
