// SPDX-License-Identifier: Apache-2.0
// bisection_sheet FOLDER: draws ROAM over coarse meshes into FOLDER/bisection.png. From top to bottom: ground
// with a tower of a TIN in one of its triangles, for an eye near it and for one that is far; a sphere, for an
// eye near it, from there and from aside; a cliff that leans over, the same way. Triangles of the TIN are
// orange. Prints counts of triangles.
#include <cstdio>
#include <filesystem>

#include <osg/Group>
#include <osg/LightModel>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>

#include <osgOffscreen/PngFile>
#include <osgTerrainROAM/BisectionDrawable>

#include "MadeSurfaces.h"
#include "SheetPictures.h"
#include "measurement/view/ContactSheet.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kPictureWidthPx = 960, kPictureHeightPx = 640;
constexpr double kFieldDeg = 45.0;

/// An eye, where it looks, and what error it allows at a distance of one.
struct Stand
{
    glm::dvec3 eye, at, up{0.0, 0.0, 1.0};
};

osg::Vec3 osgOf(const glm::dvec3& v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

osg::ref_ptr<osg::Image> pictureFrom(osg::Node* scene, const Stand& stand)
{
    const auto viewer = sheet::viewerOn(scene, kPictureWidthPx, kPictureHeightPx);
    viewer->camera().setProjectionMatrixAsPerspective(
        kFieldDeg, static_cast<double>(kPictureWidthPx) / kPictureHeightPx, 0.01, 50.0);
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    viewer->camera().setViewMatrixAsLookAt(osgOf(stand.eye), osgOf(stand.at), osgOf(stand.up));
    return viewer->picture();
}

/// What a node has drawn, lit from both sides, with the sides of its triangles.
osg::ref_ptr<osg::Group> withSides(const osg::Geometry& drawn)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const osg::ref_ptr<osg::LightModel> bothSides = new osg::LightModel;
    bothSides->setTwoSided(true);
    const osg::ref_ptr<osg::Geometry> faces = new osg::Geometry(drawn), sides = new osg::Geometry(drawn);
    faces->getOrCreateStateSet()->setAttributeAndModes(bothSides);
    faces->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
    const osg::ref_ptr<osg::Vec4Array> dark = new osg::Vec4Array;
    dark->push_back({0.1F, 0.1F, 0.12F, 1.0F});
    sides->setColorArray(dark, osg::Array::BIND_OVERALL);
    sides->getOrCreateStateSet()->setAttribute(
        new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
    sides->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    scene->addChild(faces);
    scene->addChild(sides);
    return scene;
}

/// Pictures on their way into the sheet.
class Pictures
{
public:
    explicit Pictures(const std::filesystem::path& folder) : _folder(folder)
    {
        std::filesystem::create_directories(folder);
    }

    /// Lets a node draw for one eye, and shows what it has drawn from another.
    void add(const std::shared_ptr<const BisectionModel>& model, const Stand& refined, const Stand& drawn,
             double tolerance, const std::string& name)
    {
        const osg::ref_ptr<osgTerrainROAM::BisectionDrawable> node =
            new osgTerrainROAM::BisectionDrawable(model);
        node->setErrorTolerancePx(tolerance * kPictureHeightPx /
                                  (2.0 * std::tan(osg::DegreesToRadians(0.5 * kFieldDeg))));
        pictureFrom(node, refined);
        BisectionMesh mesh(model->surface, model->patches);
        const BisectionView view{refined.eye, tolerance, 0.02};
        mesh.refine(view);
        if (const auto fault = checkDrawn(mesh.surface(), mesh.drawn())) sheet::endWith(*fault);
        std::printf("%s: %u triangles drawn; %zu for this error, worst %.2f of it\n", name.c_str(),
                    node->statistics().at(0).triangles, mesh.drawn().size(), worstShare(mesh, view));
        sheet::write(*pictureFrom(withSides(*node->latest()), drawn), _folder / (name + ".png"), _files);
    }

    void finish() const
    {
        const auto made = measurement::makeContactSheet(_files, {2, 3, 1600, 4});
        if (!made || !osgOffscreen::writePng(**made, _folder / "bisection.png")) sheet::endWith("no sheet");
    }

private:
    std::filesystem::path _folder;
    std::vector<std::filesystem::path> _files;
};

double heightAt(const glm::dvec3& place)
{
    return 0.06 * testsupport::bumpsAt({0.6 * place.x, 0.6 * place.y, 0.0});
}

/// Ground of 4 by 4, of four squares.
BisectionSurface madeGround()
{
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < 9; ++i)
    {
        points.emplace_back(2.0 * (i % 3), 2.0 * (i / 3), 0.0);
        if (i % 3 < 2 && i < 6) faces.push_back({i, i + 1, i + 4, i + 3});
    }
    auto mesh = CoarseMesh::make(std::move(points), faces, "the ground");
    return {std::move(*mesh), 13, [](const glm::dvec3& p) { return glm::dvec3(p.x, p.y, heightAt(p)); }};
}

/// A round tower whose platform leans out, in the middle of a triangle.
BisectionPatch tower(const BisectionSurface& surface, Bisector carrier)
{
    // Rings: radius in the plane of the weights; radius and height where they are drawn. The first two lie on
    // the ground.
    constexpr double kRings[][3] = {{0.18, 0.18, 0.00}, {0.16, 0.13, 0.00}, {0.14, 0.11, 0.22},
                                    {0.12, 0.15, 0.26}, {0.10, 0.15, 0.30}, {0.08, 0.12, 0.30},
                                    {0.06, 0.11, 0.27}, {0.03, 0.04, 0.27}};
    constexpr int kAround = 28;
    const CornerVertices corners = surface.cornersOf(carrier);
    const glm::dvec3 left = surface.point(corners[0]), toRight = surface.point(corners[1]) - left,
                     toApex = surface.point(corners[2]) - left;
    const glm::dvec3 middle = left + (toRight + toApex) / 3.0;
    const double area = toRight.x * toApex.y - toRight.y * toApex.x;
    std::vector<PatchPoint> inside;
    for (const auto& [inPlane, radius, height] : kRings)
        for (int i = 0; i < kAround; ++i)
        {
            const glm::dvec3 way(std::cos(2.0 * 3.14159265358979 * i / kAround),
                                 std::sin(2.0 * 3.14159265358979 * i / kAround), 0.0);
            const glm::dvec3 at = middle + inPlane * way - left;
            const double right = (at.x * toApex.y - at.y * toApex.x) / area,
                         apex = (toRight.x * at.y - toRight.y * at.x) / area;
            glm::dvec3 place = middle + radius * way;
            place.z = height > 0.0 ? middle.z + height : heightAt(place);
            inside.push_back({{1.0 - right - apex, right, apex}, place});
        }
    return makePatch(surface, carrier, inside);
}

void drawPatch(Pictures& pictures)
{
    const BisectionSurface ground = madeGround();
    const Bisector carrier{1, 5};
    const std::vector<BisectionPatch> patches{tower(ground, carrier)};
    if (const auto fault = checkPatch(ground, patches[0])) sheet::endWith(*fault);
    std::printf("tower: %zu triangles, %zu vertices on its border\n", patches[0].triangles.size(),
                patches[0].border.size());
    const auto model = std::make_shared<const BisectionModel>(ground, patches);
    const CornerVertices corners = ground.cornersOf(carrier);
    const glm::dvec3 middle =
        (ground.point(corners[0]) + ground.point(corners[1]) + ground.point(corners[2])) / 3.0;
    const Stand near{middle + glm::dvec3(-0.7, -0.75, 0.5), middle + glm::dvec3(0.0, 0.0, 0.1)};
    Stand far = near;
    far.eye = middle + glm::dvec3(-0.7, -0.75, 0.5) * 12.0;
    pictures.add(model, near, near, 0.01, "tower for an eye near it");
    pictures.add(model, far, near, 0.04, "the same triangle for an eye far off");
}

void drawSphere(Pictures& pictures)
{
    const auto model =
        std::make_shared<const BisectionModel>(testsupport::madeSphere(13), std::vector<BisectionPatch>{});
    const Stand near{{0.0, -1.2, 0.45}, {0.15, -0.65, 0.8}, {0.0, -0.9, 0.4}}, aside{{3.0, -1.6, 1.0}, {}};
    pictures.add(model, near, near, 0.007, "sphere for an eye near it");
    pictures.add(model, near, aside, 0.007, "that mesh from aside");
}

void drawOverhang(Pictures& pictures)
{
    const auto model =
        std::make_shared<const BisectionModel>(testsupport::madeOverhang(12), std::vector<BisectionPatch>{});
    const Stand near{{-1.3, 0.6, 0.35}, {0.4, 2.4, 0.75}}, aside{{-2.3, -3.2, 1.3}, {0.1, 1.7, 0.6}};
    pictures.add(model, near, near, 0.008, "cliff for an eye below it");
    pictures.add(model, near, aside, 0.008, "that cliff from aside");
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: bisection_sheet FOLDER\n");
        return 2;
    }
    Pictures pictures(argv[1]);
    drawPatch(pictures);
    drawSphere(pictures);
    drawOverhang(pictures);
    pictures.finish();
    return 0;
}
