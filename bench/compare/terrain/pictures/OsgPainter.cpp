// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <vector>

#include <osg/Geode>
#include <osgDB/Options>
#include <osgDB/WriteFile>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>
#include <osgTerrainROAM/Climate>
#include <osgTerrainROAM/RoamDrawable>
#include <osgTerrainROAM/TerrainMaterial>

#include "compare/terrain/methods/MeshPainter.h"
#include "measurement/Percentile.h"
#include "measurement/ProcessorTime.h"
#include "measurement/view/OutlinedTriangles.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
using measurement::processorMs;
using osgOffscreen::OffscreenViewer;

constexpr int kWidthPx = 640, kHeightPx = 512;           // of measured pictures
constexpr int kSmallWidthPx = 400, kSmallHeightPx = 320; // of those that are written

osg::Matrixd toOsg(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]);
}

/// Sets a camera as a view was made: its rows are those of the matrix from the world to the clip space, but
/// for their lengths.
void place(osg::Camera& camera, const viewlod::ViewState& view)
{
    const glm::dmat4 rows = glm::transpose(view.clipFromWorld);
    glm::dmat4 turned(1.0);
    turned[0] = glm::dvec4(glm::normalize(glm::dvec3(rows[0])), 0.0);
    turned[1] = glm::dvec4(glm::normalize(glm::dvec3(rows[1])), 0.0);
    turned[2] = glm::dvec4(-glm::normalize(glm::dvec3(rows[3])), 0.0);
    glm::dmat4 fromEye(1.0);
    fromEye[3] = glm::dvec4(-view.eyeWorld, 1.0);
    const glm::dmat4 eyeFromWorld = glm::transpose(turned) * fromEye;
    camera.setViewMatrix(toOsg(eyeFromWorld));
    camera.setProjectionMatrix(toOsg(view.clipFromWorld * glm::inverse(eyeFromWorld)));
}

osg::Vec3 toOsg(const glm::dvec3& v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

class OsgPainter final : public MeshPainter
{
public:
    OsgPainter(std::unique_ptr<OffscreenViewer> measured, std::unique_ptr<OffscreenViewer> written)
        : _measured(std::move(measured)), _written(std::move(written))
    {
        _written->camera().setClearColor({0.82F, 0.87F, 0.92F, 1.0F});
    }

    std::string rendererName() const override { return _measured->context().rendererName(); }

    foundation::Result<double> pictureMs(const PaintedTerrain& terrain, double tolerancePx,
                                         std::span<const viewlod::ViewState> views) override
    {
        constexpr std::size_t kWarmUp = 2;
        const osg::ref_ptr<osgTerrainROAM::RoamDrawable> ground =
            new osgTerrainROAM::RoamDrawable(terrain.tile, terrain.method, terrain.prepared);
        // Views are 1280 pixels wide; the picture is smaller, so the same mesh has fewer pixels of error in
        // it.
        const double scale = static_cast<double>(kWidthPx) / views.front().widthPx;
        osgTerrainROAM::RoamDrawableSettings settings = ground->settings();
        settings.errorTolerancePx = scale * tolerancePx;
        if (const auto set = ground->setSettings(settings); !set) return set.error();
        _measured->viewer().setSceneData(sceneOf(*terrain.tile, ground));
        std::vector<double> ms;
        for (std::size_t i = 0; i < views.size(); ++i)
        {
            place(_measured->camera(), views[i]);
            const double begin = processorMs();
            if (!_measured->picture()) return foundation::Error{"picture", "cannot be read", "use OSMesa"};
            if (i >= kWarmUp) ms.push_back(processorMs() - begin);
        }
        _measured->viewer().setSceneData(nullptr);
        if (ms.empty())
            return foundation::Error{"flight", "has fewer than three frames", "let it last longer"};
        return measurement::percentile(ms, 0.5);
    }

    foundation::Outcome write(const DrawnMesh& mesh, const viewlod::ViewState& view,
                              const std::filesystem::path& file) override
    {
        measurement::Soup soup;
        for (const LeafTriangle& t : mesh.triangles)
            soup.addLit(toOsg(mesh.position(t.vertices[0])), toOsg(mesh.position(t.vertices[1])),
                        toOsg(mesh.position(t.vertices[2])));
        place(_written->camera(), view);
        const osg::ref_ptr<osg::Image> both = new osg::Image;
        both->allocateImage(kSmallWidthPx, 2 * kSmallHeightPx, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
        for (const bool hasSides : {true, false})
        {
            _written->viewer().setSceneData(measurement::drawnTriangles(soup, hasSides));
            const osg::ref_ptr<osg::Image> one = _written->picture();
            if (!one) return foundation::Error{file.string(), "cannot be drawn", "use OSMesa"};
            both->copySubImage(0, hasSides ? 0 : kSmallHeightPx, 0, one);
        }
        const osg::ref_ptr<osgDB::Options> quality = new osgDB::Options("JPEG_QUALITY 80");
        if (!osgDB::writeImageFile(*both, file.string(), quality))
            return foundation::Error{file.string(), "cannot be written", "check the folder and its space"};
        return foundation::success();
    }

private:
    osg::ref_ptr<osg::Group> sceneOf(const RoamTile& tile, osg::Drawable* ground)
    {
        const osg::ref_ptr<osgSky::Atmosphere> atmosphere = new osgSky::Atmosphere;
        const osg::ref_ptr<osgTerrainROAM::TerrainMaterial> material =
            new osgTerrainROAM::TerrainMaterial(tile.tile, osgTerrainROAM::climateOf(tile.tile, {}));
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->setStateSet(new osg::StateSet(*material->stateSet()));
        atmosphere->addUniformsTo(*scene->getStateSet());
        _measured->viewer().setLightingMode(osg::View::SKY_LIGHT);
        atmosphere->applyTo(*_measured->viewer().getLight());
        const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(ground);
        scene->addChild(geode);
        return scene;
    }

    std::unique_ptr<OffscreenViewer> _measured, _written;
};

} // namespace

foundation::Result<std::unique_ptr<MeshPainter>> makePainter()
{
    auto measured = OffscreenViewer::create({.widthPx = kWidthPx, .heightPx = kHeightPx});
    if (!measured) return measured.error();
    auto written =
        OffscreenViewer::create({.widthPx = kSmallWidthPx, .heightPx = kSmallHeightPx, .samples = 4});
    if (!written) return written.error();
    return std::unique_ptr<MeshPainter>(
        std::make_unique<OsgPainter>(std::move(*measured), std::move(*written)));
}

} // namespace terraintool
