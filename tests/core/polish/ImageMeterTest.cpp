// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/polish/ImageMeter.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::cube;
using testsupport::lit;
using testsupport::together;

Mesh scaled(Mesh mesh, double scale)
{
    for (glm::dvec3& p : mesh.positions)
        p = glm::dvec3(0.5) + scale * (p - glm::dvec3(0.5));
    return mesh;
}

TEST(ImageMeter, FindsNoDifferenceBetweenAMeshAndItself)
{
    const Mesh mesh = lit(cube());
    const ImageDifference same = ImageMeter(mesh).measure(mesh);
    EXPECT_EQ(same.areaRatio, 1.0);
    EXPECT_EQ(same.leastAreaRatio, 1.0);
    EXPECT_EQ(same.mostAreaRatio, 1.0);
    EXPECT_EQ(same.covered, 1.0);
    EXPECT_EQ(same.luminance, 0.0);
}

TEST(ImageMeter, MeasuresTheAreaOfASmallerBody)
{
    const ImageDifference half = ImageMeter(lit(cube())).measure(lit(scaled(cube(), 0.5)));
    EXPECT_NEAR(half.areaRatio, 0.25, 0.01);
    EXPECT_NEAR(half.covered, half.areaRatio, 1e-12) << "the smaller one is inside";
    EXPECT_GT(half.luminance, 0.1);
}

TEST(ImageMeter, TellsAreaThatIsElsewhereFromAreaThatIsCovered)
{
    const Mesh two = together(cube(), cube(), {9, 0, 0});
    Mesh moved = two;
    for (std::size_t i = 0; i < 8; ++i)
        moved.positions[i].x += 3.0;
    const ImageDifference difference = ImageMeter(two).measure(moved);
    EXPECT_NEAR(difference.areaRatio, 1.0, 0.1);
    EXPECT_NEAR(difference.covered, 0.5, 0.15);
    EXPECT_LT(difference.leastAreaRatio, difference.mostAreaRatio);
}

TEST(ImageMeter, SeesAnotherShadeOfTheSameSilhouette)
{
    Mesh mesh = lit(cube());
    mesh.materials.push_back(mesh.materials[0]);
    Mesh other = mesh;
    for (Face& face : other.faces)
        face.material = 1;
    std::vector<MaterialLook> looks(2);
    looks[0].luminance = 0.9f;
    looks[1].luminance = 0.2f;
    const ImageDifference difference = ImageMeter(mesh, looks).measure(other);
    EXPECT_EQ(difference.covered, 1.0);
    EXPECT_GT(difference.luminance, 0.2);
}

TEST(ImageMeter, DrawsBacksAndSaysThatNothingCoversNothing)
{
    const Mesh mesh = cube();
    Mesh turned = mesh;
    for (Face& face : turned.faces)
        std::swap(face.wedges[0], face.wedges[1]);
    Mesh none = mesh;
    none.faces.clear();
    const ImageMeter meter(mesh);
    EXPECT_EQ(meter.measure(turned).covered, 1.0);
    EXPECT_EQ(meter.measure(none).covered, 0.0);
    EXPECT_EQ(meter.measure(none).areaRatio, 0.0);
    EXPECT_EQ(ImageMeter(none).measure(none).areaRatio, 1.0);
}

TEST(ImageMeter, ShowsTheImagesThatItCompares)
{
    const Mesh mesh = lit(cube());
    const ImageMeter meter(mesh, {}, {.views = 4, .sizePx = 32});
    const std::vector<std::uint8_t> image = meter.image(mesh, 2);
    ASSERT_EQ(image.size(), 32u * 32u);
    EXPECT_EQ(image[0], 115) << "the background";
    EXPECT_NE(image[16 * 32 + 16], 115);
}

} // namespace
