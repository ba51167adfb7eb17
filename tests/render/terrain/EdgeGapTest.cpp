// SPDX-License-Identifier: Apache-2.0
// The surroundings meet the tile without a hole or a step, at any level of detail. The scene is drawn by a
// program that paints walls red and all other ground white, before a background of magenta. A hole is a
// vertical run of magenta below ground; a step is a run of magenta and red: no more of it may be seen than
// the error of both sides.
#include <algorithm>

#include <gtest/gtest.h>

#include <osg/MatrixTransform>
#include <osg/Program>

#include "RenderedPicture.h"
#include "SyntheticField.h"
#include "SyntheticScene.h"
#include "material/TerrainShader.h"

namespace
{

using namespace osgTerrainROAM;
using namespace syntheticscene;

constexpr int kEdgeSide = 65;
constexpr double kEdgeSpacingM = 30.0;
constexpr double kEdgeViewDeg = 20.0; ///< high, over 180 pixels: 0.1 m at 60 m

const char* const kRedWalls = R"(#version 330 compatibility
in vec3 fromEye;
in vec2 grid;
void main()
{
    vec3 normal = normalize(cross(dFdx(fromEye), dFdy(fromEye)));
    gl_FragColor = abs(normal.z) < 0.05 ? vec4(1.0, 0.0, 0.0, 1.0) : vec4(1.0);
}
)";

/// Gentle hills with surroundings, under the program above. `root` is what is drawn.
struct EdgeScene
{
    osg::ref_ptr<RoamTerrain> terrain;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    std::unique_ptr<osgOffscreen::OffscreenViewer> viewer;

    EdgeScene()
    {
        core::HeightField field = testsupport::hills(kEdgeSide, kEdgeSide, kEdgeSpacingM);
        for (float& height : field.heightsM)
            height = 300.0f + 0.25f * height;
        terrain = dressed(std::make_shared<core::RoamTile>(
                              core::PlacedTile(std::move(field), {.placement = core::Placement::planar})),
                          1.0);
        terrain->showSurroundings(true);
        root->addChild(terrain);
        const osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(terrainVertexShader());
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, kRedWalls));
        root->getOrCreateStateSet()->setAttributeAndModes(program, osg::StateAttribute::ON |
                                                                       osg::StateAttribute::OVERRIDE);
        viewer = viewerOn(root, rendered::backends().front());
        viewer->camera().setClearColor(osg::Vec4(1, 0, 1, 1));
        viewer->camera().setProjectionMatrixAsPerspective(kEdgeViewDeg, 320.0 / 180.0, 0.5, 30000.0);
    }

    /// Moves the surroundings, and nothing else.
    void moveSurroundings(const osg::Vec3d& by)
    {
        const osg::ref_ptr<osg::Node> surroundings = terrain->getChild(1);
        const osg::ref_ptr<osg::MatrixTransform> moved =
            new osg::MatrixTransform(osg::Matrixd::translate(by));
        moved->setCullingActive(false);
        moved->addChild(surroundings);
        terrain->replaceChild(surroundings, moved);
    }
};

/// Points on the middle of each side and near a corner, with the direction that leads out of the data.
struct EdgePoint
{
    int column, row;
    osg::Vec3d outwards;
};

constexpr int kEdgeLast = kEdgeSide - 1;
const EdgePoint kEdgePoints[] = {{kEdgeLast, 20, {1, 0, 0}}, {0, 45, {-1, 0, 0}},
                                 {30, kEdgeLast, {0, 1, 0}}, {11, 0, {0, -1, 0}},
                                 {kEdgeLast, 63, {1, 0, 0}}, {2, 0, {0, -1, 0}}};

/// From outside and inside, low and high, and from above.
std::vector<Viewpoint> viewsOf(const core::PlacedTile& tile, const EdgePoint& point)
{
    const glm::dvec3 p = tile.position(point.column, point.row);
    const osg::Vec3d at(p.x, p.y, p.z), up(0, 0, 1);
    return {{"outside, low", at + point.outwards * 60.0 + up * 25.0, at},
            {"outside, high", at + point.outwards * 700.0 + up * 250.0, at},
            {"inside, low", at - point.outwards * 60.0 + up * 25.0, at},
            {"inside, high", at - point.outwards * 700.0 + up * 250.0, at},
            {"above", at + point.outwards * 20.0 + up * 300.0, at}};
}

/// The longest vertical runs that have ground above them, in pixels.
struct Runs
{
    int hole = 0; ///< of the background
    int step = 0; ///< of background and walls
};

Runs longestRuns(const osg::Image& picture)
{
    Runs longest;
    for (int x = 0; x < picture.s(); ++x)
    {
        Runs run;
        for (int y = 0; y < picture.t(); ++y) // from below
        {
            const unsigned char* const p = picture.data(x, y);
            const bool isWall = p[1] == 0, isHole = isWall && p[2] == 255;
            run.step = isWall ? run.step + 1 : 0;
            run.hole = isHole ? run.hole + 1 : 0;
            // The run is known to be below ground once ground is above it.
            if (y + 1 == picture.t() || picture.data(x, y + 1)[1] == 0) continue;
            longest.hole = std::max(longest.hole, run.hole);
            longest.step = std::max(longest.step, run.step);
        }
    }
    return longest;
}

/// The longest runs over all views.
Runs widestGap(EdgeScene& scene, double tolerancePx)
{
    EXPECT_TRUE(scene.terrain->drawable()->setErrorTolerancePx(tolerancePx));
    Runs widest;
    for (const EdgePoint& point : kEdgePoints)
        for (const Viewpoint& view : viewsOf(scene.terrain->tile()->tile, point))
        {
            look(*scene.viewer, view);
            const Runs runs = longestRuns(*scene.viewer->picture());
            widest.hole = std::max(widest.hole, runs.hole);
            widest.step = std::max(widest.step, runs.step);
        }
    return widest;
}

/// What the error of both sides may show, and a pixel.
int allowedStep(double tolerancePx)
{
    return static_cast<int>(2.0 * tolerancePx) + 1;
}

} // namespace

TEST(EdgeGap, SurroundingsMeetTheTileAtAnyLevelOfDetail)
{
    EdgeScene scene;
    ASSERT_TRUE(scene.viewer);
    for (const double tolerancePx : {0.25, 1.0, 4.0, 16.0})
    {
        const Runs widest = widestGap(scene, tolerancePx);
        EXPECT_EQ(widest.hole, 0) << tolerancePx;
        EXPECT_LE(widest.step, allowedStep(tolerancePx)) << tolerancePx;
    }
}

TEST(EdgeGap, SurroundingsThatAreAMetreTooLowAreSeen)
{
    EdgeScene scene;
    ASSERT_TRUE(scene.viewer);
    scene.moveSurroundings({0, 0, -1});
    EXPECT_GT(widestGap(scene, 1.0).step, allowedStep(1.0));
}

TEST(EdgeGap, SurroundingsThatBeginASampleTooLateAreSeen)
{
    EdgeScene scene;
    ASSERT_TRUE(scene.viewer);
    scene.moveSurroundings({kEdgeSpacingM, 0, 0});
    const Runs widest = widestGap(scene, 1.0);
    EXPECT_GT(widest.hole, 0);
    EXPECT_GT(widest.step, allowedStep(1.0));
}
