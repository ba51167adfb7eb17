// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "RenderedGolden.h"
#include "RenderedPicture.h"

namespace
{

osgOffscreen::OffscreenSettings settingsOf(osgOffscreen::Backend backend)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = backend;
    settings.widthPx = 192;
    settings.heightPx = 108;
    return settings;
}

} // namespace

TEST(OffscreenGolden, SmallSceneIsAsStored)
{
    for (const auto backend : rendered::backends())
    {
        const auto viewer = rendered::viewerOf(rendered::smallScene(), settingsOf(backend));
        ASSERT_NE(viewer, nullptr);
        EXPECT_TRUE(rendered::matchesGolden(*viewer->picture(), "offscreen-small-scene",
                                            viewer->context().rendererName()));
    }
}

TEST(OffscreenGolden, AMovedTriangleDoesNotMatch)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    rendered::SceneOptions moved;
    moved.triangleShiftM = 0.05F;
    const auto viewer =
        rendered::viewerOf(rendered::smallScene(moved), settingsOf(osgOffscreen::defaultBackend()));
    ASSERT_NE(viewer, nullptr);
    EXPECT_FALSE(rendered::matchesGolden(*viewer->picture(), "offscreen-small-scene",
                                         viewer->context().rendererName()));
}

TEST(OffscreenGolden, AMissingGoldenDoesNotMatch)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    const auto viewer =
        rendered::viewerOf(rendered::smallScene(), settingsOf(osgOffscreen::defaultBackend()));
    ASSERT_NE(viewer, nullptr);
    EXPECT_FALSE(
        rendered::matchesGolden(*viewer->picture(), "no-such-golden", viewer->context().rendererName()));
}
