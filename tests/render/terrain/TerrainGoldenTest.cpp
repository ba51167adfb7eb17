// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <osg/Texture2D>
#include <osgUtil/CullVisitor>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RenderedGolden.h"
#include "RenderedPicture.h"
#include "SyntheticScene.h"
#include "view/TileBounds.h"
#include "view/ViewPart.h"

namespace
{

using namespace osgTerrainROAM;
using namespace syntheticscene;
using osgOffscreen::Backend;

std::string goldenOf(const Viewpoint& viewpoint)
{
    return "terrain-" + viewpoint.name;
}

/// Pictures from all three viewpoints of a terrain that `change` has been at.
std::vector<osg::ref_ptr<osg::Image>> picturesOf(const std::function<void(RoamTerrain&)>& change)
{
    const auto terrain = islandTerrain();
    change(*terrain);
    const auto viewer = viewerOn(terrain, rendered::backends().front());
    std::vector<osg::ref_ptr<osg::Image>> pictures;
    for (const Viewpoint& viewpoint : viewpoints(terrain->tile()->tile))
    {
        look(*viewer, viewpoint);
        pictures.push_back(viewer->picture());
    }
    return pictures;
}

/// Every one of the pictures must differ from the right ones by more than a golden lets pass.
void expectNoneMatches(const std::function<void(RoamTerrain&)>& mutation)
{
    const auto right = picturesOf([](RoamTerrain&) {});
    const auto wrong = picturesOf(mutation);
    for (std::size_t i = 0; i < right.size(); ++i)
    {
        const auto difference = osgOffscreen::compareImages(*wrong[i], *right[i]);
        EXPECT_FALSE(difference.within(rendered::kOtherClassPixels, rendered::kOtherClassLevels)) << i;
    }
}

/// Draws what RoamDrawable draws, less one range: the nearest (0) … the farthest (1).
class HoleyDrawable : public osg::Drawable
{
public:
    HoleyDrawable(std::shared_ptr<const core::RoamTile> tile, int rank)
        : _bounds(tileBounds(tile->tile)),
          _group(std::make_shared<ViewGroup>(std::make_unique<core::RoamMesh>(std::move(tile)))),
          _rank(rank)
    {
    }

    osg::BoundingBox computeBoundingBox() const override { return _bounds; }

    using osg::Drawable::accept;
    void accept(osg::NodeVisitor& visitor) override
    {
        auto* const cull = visitor.asCullVisitor();
        if (!cull) return osg::Drawable::accept(visitor);
        RefineTarget target;
        target.view =
            viewlod::ViewState::fromMatrices(glm::make_mat4(cull->getModelViewMatrix()->ptr()),
                                             glm::make_mat4(cull->getProjectionMatrix()->ptr()), 320, 180);
        ViewAnswer answer = _group->answer(visitor.getFrameStamp()->getFrameNumber(), target,
                                           target.view.frustum, cull->getState()->getContextID());
        // The largest ranges lie in the picture; small ones may be there for their bounds alone.
        std::sort(answer.ranges.begin(), answer.ranges.end(),
                  [](const auto& a, const auto& b) { return a.count > b.count; });
        answer.ranges.erase(answer.ranges.begin() + _rank);
        cull->pushStateSet(getStateSet());
        cull->addDrawableAndDepth(new ViewPart(_group, answer, target.view.frustum, _bounds),
                                  cull->getModelViewMatrix(), 1.0f);
        cull->popStateSet();
    }

private:
    osg::BoundingBox _bounds;
    std::shared_ptr<ViewGroup> _group;
    int _rank; ///< of the range that is left out, by size
};

} // namespace

TEST(TerrainGolden, LooksAsItDidFromEveryHeight)
{
    for (const Backend backend : rendered::backends())
    {
        const auto terrain = islandTerrain();
        const auto viewer = viewerOn(terrain, backend);
        ASSERT_TRUE(viewer);
        for (const Viewpoint& viewpoint : viewpoints(terrain->tile()->tile))
        {
            look(*viewer, viewpoint);
            EXPECT_TRUE(rendered::matchesGolden(*viewer->picture(), goldenOf(viewpoint),
                                                viewer->context().rendererName()))
                << osgOffscreen::backendName(backend);
        }
    }
}

TEST(TerrainGolden, AFlippedNormalIsCaught)
{
    expectNoneMatches(
        [](RoamTerrain& terrain)
        {
            auto* texture = static_cast<osg::Texture2D*>(terrain.material()->stateSet()->getTextureAttribute(
                TerrainMaterial::normals, osg::StateAttribute::TEXTURE));
            auto* tilt = reinterpret_cast<unsigned short*>(texture->getImage()->data());
            for (int i = 0; i < 2 * texture->getImage()->s() * texture->getImage()->t(); ++i)
                tilt[i] = static_cast<unsigned short>(65535 - tilt[i]);
        });
}

TEST(TerrainGolden, TwentyPercentMoreHazeIsCaught)
{
    expectNoneMatches(
        [](RoamTerrain& terrain)
        {
            osgSky::AtmosphereSettings settings = terrain.atmosphere()->settings();
            settings.visibilityM /= 1.2;
            ASSERT_TRUE(terrain.atmosphere()->setSettings(settings));
        });
}

TEST(TerrainGolden, AMissingRangeIsCaught)
{
    const Viewpoint high = viewpoints(islandTile()->tile).back();
    const auto right = picturesOf([](RoamTerrain&) {}).back();
    int caught = 0;
    for (int missing = 0; missing < 8; ++missing)
    {
        const auto terrain = islandTerrain();
        const osg::ref_ptr<HoleyDrawable> holey = new HoleyDrawable(terrain->tile(), missing);
        holey->setStateSet(terrain->material()->stateSet());
        terrain->replaceChild(terrain->drawable(), holey);
        const auto viewer = viewerOn(terrain, rendered::backends().front());
        look(*viewer, high);
        const auto difference = osgOffscreen::compareImages(*viewer->picture(), *right);
        caught += difference.within(rendered::kOtherClassPixels, rendered::kOtherClassLevels) ? 0 : 1;
    }
    // Bounds are conservative: a large range may still lie beside the picture or behind a hill.
    EXPECT_GE(caught, 5);
}
