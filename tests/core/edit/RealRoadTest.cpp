// SPDX-License-Identifier: Apache-2.0
// Roads through real ground: exact over their width, and drawn within the error target from the driver's eye
// and from 500 m.
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "DesignedRoad.h"
#include "RealData.h"

namespace
{

using namespace osgTerrainROAM::core;

struct Course
{
    const char* file;
    double lengthM;
    int exponent; ///< of the grid, the raster's spacing / 2^exponent is half a metre or less
};

class RealRoad : public testing::TestWithParam<Course>
{
};

Ribbon ribbon(double lengthM)
{
    Ribbon road{.smoothM = 200.0};
    for (int i = 0; i <= 200; ++i)
    {
        const double t = i / 200.0;
        road.points.emplace_back((t - 0.5) * lengthM, 0.06 * lengthM * std::sin(6.0 * t));
    }
    return road;
}

} // namespace

TEST_P(RealRoad, IsExactToACentimetreAndDrawnWithinTheTarget)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    RoamFile description;
    description.dems = {file};
    description.finestSpacingM = 0.5;
    auto placed = loadTile(description);
    ASSERT_TRUE(placed) << placed.error().message();
    const auto tile = std::make_shared<RoamTile>(std::move(*placed));
    ASSERT_EQ(tile->tile.grid().exponent(), GetParam().exponent);

    RoamMesh mesh{SplitBounds(tile)};
    GroundEditor editor(tile);
    const DesignedRoad road(ribbon(GetParam().lengthM), editor);
    const PlanLine& line = road.line();
    ASSERT_TRUE(editor.conform(road.ribbon()));
    const double worstM = road.worstM(*tile, 4.3, std::array{-3.45, -1.7, 0.0, 1.0, 3.45});
    EXPECT_LT(worstM, 0.01);
    RecordProperty("worstMillimetres", static_cast<int>(worstM * 1000.0));

    for (const double aboveM : {1.5, 500.0})
        for (const double tolerancePx : {0.5, 2.0, 16.0})
        {
            const glm::dvec2 here = line.at(0.4 * line.lengthM()),
                             there = line.at(0.4 * line.lengthM() + 120.0);
            const glm::dvec3 eye =
                groundAt(tile->tile, here.x, here.y)->position + glm::dvec3(0.0, 0.0, aboveM);
            const glm::dvec3 target = groundAt(tile->tile, there.x, there.y)->position;
            const auto view = viewlod::ViewState::fromMatrices(
                glm::lookAt(eye, target, {0.0, 0.01, 1.0}), glm::perspective(0.8, 1.6, 0.5, 1e5), 1280, 800);
            mesh.refine(view, {.errorTolerancePx = tolerancePx});
            const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), &view);
            EXPECT_EQ(report.tJunctions + report.cracks, 0u) << aboveM << " m, " << tolerancePx << " px";
            EXPECT_LE(report.maxErrorPx, tolerancePx) << aboveM << " m";
        }
}

INSTANTIATE_TEST_SUITE_P(Dem, RealRoad,
                         testing::Values(Course{"dem/greenriver.tif", 1500.0, 1},
                                         Course{"dem/N44W072.hgt", 800.0, 8}),
                         [](const auto& given) {
                             return given.param.exponent == 1 ? std::string("greenriver")
                                                              : std::string("N44W072");
                         });
