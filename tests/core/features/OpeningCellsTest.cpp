// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/features/OpeningCells.h>

using namespace osgTerrainROAM::core;

namespace
{

/// From (0, 0, 10) to (100, 0, 15), 4 m wide to each side, from 1 m below to 6 m above the line.
GroundOpening pipe()
{
    GroundOpening opening;
    opening.line = {{{0.0, 0.0, 10.0}, 4.0}, {{100.0, 0.0, 15.0}, 4.0}};
    opening.lowM = -1.0;
    opening.wallM = 4.0;
    opening.kneeM = 5.0;
    opening.crownM = 6.0;
    return opening;
}

GroundOpening moved(GroundOpening opening, const glm::dvec3& by)
{
    for (auto& section : opening.line)
        section.middle += by;
    return opening;
}

OpeningCells built(const std::vector<GroundOpening>& openings)
{
    const auto cells = OpeningCells::build(openings);
    EXPECT_TRUE(cells) << (cells ? "" : cells.error().message());
    return cells ? *cells : OpeningCells{};
}

void expectPipe(const OpeningCells& cells, const glm::dvec3& by)
{
    const auto isOpen = [&](double x, double y, double z) { return cells.isOpen(by + glm::dvec3(x, y, z)); };
    EXPECT_TRUE(isOpen(50.0, 0.0, 18.4)) << "below the crown: 12.5 + 6";
    EXPECT_FALSE(isOpen(50.0, 0.0, 18.6));
    EXPECT_TRUE(isOpen(50.0, 2.4, 17.4)) << "below the knee: 12.5 + 5";
    EXPECT_FALSE(isOpen(50.0, 2.4, 17.6));
    EXPECT_TRUE(isOpen(50.0, -3.2, 16.9)) << "half-way from the knee to the wall: 12.5 + 4.5";
    EXPECT_FALSE(isOpen(50.0, -3.2, 17.1));
    EXPECT_TRUE(isOpen(50.0, 3.9, 12.0));
    EXPECT_FALSE(isOpen(50.0, 4.1, 12.0));
    EXPECT_FALSE(isOpen(50.0, 0.0, 11.4)) << "below the floor: 12.5 - 1";
    EXPECT_TRUE(isOpen(0.1, 0.0, 12.0));
    EXPECT_FALSE(isOpen(-0.1, 0.0, 12.0));
    EXPECT_FALSE(isOpen(100.1, 0.0, 17.0));
    EXPECT_FALSE(isOpen(5000.0, 5000.0, 12.0));
}

} // namespace

TEST(OpeningCells, AnOpeningIsItsCrossSectionAlongItsLine)
{
    expectPipe(built({pipe()}), {});
}

TEST(OpeningCells, FarFromTheOriginItIsTheSame)
{
    const glm::dvec3 far(-654321.0, 123456.0, 2000.0);
    expectPipe(built({moved(pipe(), far)}), far);
}

TEST(OpeningCells, CellsGrowWithTheExtent)
{
    const glm::dvec3 far(60000.0, 0.0, 0.0);
    const OpeningCells cells = built({pipe(), moved(pipe(), far)});
    EXPECT_EQ(cells.cellM, 128.0);
    EXPECT_LE(cells.columns, 512);
    expectPipe(cells, far);
}

TEST(OpeningCells, PiecesOfABendMeetAtItsOuterSide)
{
    GroundOpening bend = pipe();
    bend.line = {{{0.0, 0.0, 0.0}, 4.0}, {{20.0, 0.0, 0.0}, 4.0}, {{40.0, 10.0, 0.0}, 4.0}};
    const OpeningCells cells = built({bend});
    for (double angle = 0.0; angle < std::atan2(10.0, 20.0); angle += 0.02) // about the joint, below the bend
        EXPECT_TRUE(cells.isOpen({20.0 + 3.9 * std::sin(angle), -3.9 * std::cos(angle), 1.0})) << angle;
    EXPECT_FALSE(cells.isOpen({20.0, -4.2, 1.0}));
}

TEST(OpeningCells, WithoutOpeningsNothingIsOpen)
{
    const OpeningCells cells = built({});
    EXPECT_TRUE(cells.isEmpty());
    EXPECT_FALSE(cells.isOpen({0.0, 0.0, 0.0}));
}

TEST(OpeningCells, LinesWithoutExtentOrNumbersAreRefused)
{
    GroundOpening one = pipe(), wild = pipe();
    one.line.pop_back();
    wild.line.back().middle.y = NAN;
    EXPECT_FALSE(OpeningCells::build({one}));
    EXPECT_FALSE(OpeningCells::build({wild}));
}
