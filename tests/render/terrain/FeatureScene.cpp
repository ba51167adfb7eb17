// SPDX-License-Identifier: Apache-2.0
#include "FeatureScene.h"

#include <string>

#include <gtest/gtest.h>

#include <osg/Program>

#include "RenderedPicture.h"
#include "SyntheticField.h"

namespace featurescene
{

using namespace osgTerrainROAM;

osg::ref_ptr<RoamTerrain> plain(const std::vector<core::GroundFeature>& features, bool snow)
{
    core::HeightField field;
    field.name = "plain";
    field.columns = field.rows = 257;
    field.spacingEastM = field.spacingNorthM = 250.0;
    // A millimetre from sample to sample: ground that is exactly level is taken for water.
    for (int i = 0; i < 257 * 257; ++i)
        field.heightsM.push_back(0.001f * static_cast<float>(i % 2));
    const auto tile = testsupport::planarTile(std::move(field));
    core::LandParameters land;
    land.seaLevelM = -100.0;
    if (snow) land.snowLineM = -5000.0;
    const osg::ref_ptr<TerrainMaterial> material =
        new TerrainMaterial(tile->tile, climateOf(tile->tile, land));
    if (!features.empty())
    {
        const auto cells = core::FeatureCells::build(features);
        EXPECT_TRUE(cells) << cells.error().message();
        if (cells) material->setFeatures(*cells);
    }
    osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material);
    osgSky::AtmosphereSettings settings;
    settings.sunDirectionWorld = osgSky::sunDirectionFromAngles(200.0, 60.0);
    settings.visibilityM = 100000.0;
    terrain->setAtmosphere(new osgSky::Atmosphere(settings));
    return terrain;
}

core::GroundFeature line(core::FeatureKind kind, double widthM, const glm::dvec2& a, const glm::dvec2& b)
{
    core::GroundFeature feature;
    feature.style.kind = kind;
    feature.style.widthM = widthM;
    feature.paths = {{a, b}};
    return feature;
}

Camera::Camera(osg::Node* scene, double fieldOfViewDeg)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = rendered::backends().front();
    settings.widthPx = kWidthPx;
    settings.heightPx = kHeightPx;
    settings.samples = 1; // a share of a pixel has to come from the shader
    _viewer = rendered::viewerOf(scene, settings);
    const double aspect = static_cast<double>(kWidthPx) / kHeightPx;
    _viewer->camera().setProjectionMatrixAsPerspective(fieldOfViewDeg, aspect, 0.3, 60000.0);
}

osg::ref_ptr<osg::Image> Camera::picture(const osg::Vec3d& eye, const osg::Vec3d& ahead, const osg::Vec3d& up)
{
    _viewer->camera().setViewMatrixAsLookAt(eye, eye + ahead, up);
    return _viewer->picture();
}

osg::Vec2d Camera::pixelOf(const osg::Vec3d& place) const
{
    const osg::Vec3d clip =
        place * _viewer->camera().getViewMatrix() * _viewer->camera().getProjectionMatrix();
    return {0.5 * (clip.x() + 1.0) * kWidthPx, 0.5 * (clip.y() + 1.0) * kHeightPx};
}

void mutate(RoamTerrain& terrain, const std::string& from, const std::string& to)
{
    auto* program = static_cast<osg::Program*>(
        terrain.material()->stateSet()->getAttribute(osg::StateAttribute::PROGRAM));
    const osg::ref_ptr<osg::Program> changed = new osg::Program;
    bool found = false;
    for (unsigned i = 0; i < program->getNumShaders(); ++i)
    {
        std::string text = program->getShader(i)->getShaderSource();
        if (const std::size_t at = text.find(from); at != std::string::npos)
        {
            text.replace(at, from.size(), to);
            found = true;
        }
        changed->addShader(new osg::Shader(program->getShader(i)->getType(), text));
    }
    ASSERT_TRUE(found) << from;
    terrain.material()->stateSet()->setAttributeAndModes(changed);
}

double level(const osg::Image& picture, int x, int y)
{
    const unsigned char* p = picture.data(x, y);
    return (p[0] + p[1] + p[2]) / 3.0;
}

} // namespace featurescene
