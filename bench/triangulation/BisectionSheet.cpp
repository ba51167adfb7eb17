// SPDX-License-Identifier: Apache-2.0
// bisection_sheet FOLDER: draws ROAM over coarse meshes into FOLDER/bisection.png. From top to bottom: ground with a tower of a TIN in one of
// its triangles, for an eye near it and for one that is far; a sphere, for an eye near it, from there and from aside; a cliff that leans over,
// the same way. Triangles of the TIN are orange. Prints counts of triangles.
#include <cstdio>
#include <filesystem>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>

#include <osgOffscreen/PngFile>

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

osg::ref_ptr<osg::Image> pictureFrom(const BisectionMesh& mesh, const Stand& stand)
{
    sheet::Soup soup;
    for (const DrawnBisector& t : mesh.drawn())
    {
        soup.addLit(osgOf(mesh.point(t.vertices[0])), osgOf(mesh.point(t.vertices[1])),
                    osgOf(mesh.point(t.vertices[2])));
        if (t.patch == kNoSide) continue;
        for (std::size_t corner = soup.colours->size() - 3; corner < soup.colours->size(); ++corner)
        {
            osg::Vec4& colour = (*soup.colours)[corner];
            colour.set(colour.r(), 0.7F * colour.g(), 0.35F * colour.b(), 1.0F);
        }
    }
    const auto viewer = sheet::viewerOn(measurement::drawnTriangles(soup), kPictureWidthPx, kPictureHeightPx);
    viewer->camera().setProjectionMatrixAsPerspective(
        kFieldDeg, static_cast<double>(kPictureWidthPx) / kPictureHeightPx, 0.01, 50.0);
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    viewer->camera().setViewMatrixAsLookAt(osgOf(stand.eye), osgOf(stand.at), osgOf(stand.up));
    return viewer->picture();
}

/// Pictures on their way into the sheet.
class Pictures
{
public:
    explicit Pictures(const std::filesystem::path& folder) : _folder(folder)
    {
        std::filesystem::create_directories(folder);
    }

    /// Refines for one eye and draws from another.
    void add(BisectionMesh& mesh, const Stand& refined, const Stand& drawn, double tolerance,
             const std::string& name)
    {
        const BisectionView view{refined.eye, tolerance, 0.02};
        mesh.refine(view);
        const auto triangles = mesh.drawn();
        if (const auto fault = checkDrawn(mesh.surface(), triangles)) sheet::endWith(*fault);
        std::printf("%s: %zu triangles, worst %.2f of the tolerance\n", name.c_str(), triangles.size(),
                    worstShare(mesh, view));
        sheet::write(*pictureFrom(mesh, drawn), _folder / (name + ".png"), _files);
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
    // Rings: radius in the plane of the weights; radius and height where they are drawn. The first two lie on the ground.
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
    BisectionMesh mesh(ground, patches);
    const CornerVertices corners = ground.cornersOf(carrier);
    const glm::dvec3 middle =
        (ground.point(corners[0]) + ground.point(corners[1]) + ground.point(corners[2])) / 3.0;
    const Stand near{middle + glm::dvec3(-0.7, -0.75, 0.5), middle + glm::dvec3(0.0, 0.0, 0.1)};
    Stand far = near;
    far.eye = middle + glm::dvec3(-0.7, -0.75, 0.5) * 12.0;
    pictures.add(mesh, near, near, 0.01, "tower for an eye near it");
    pictures.add(mesh, far, near, 0.03, "the same triangle for an eye far off");
}

void drawSphere(Pictures& pictures)
{
    const BisectionSurface sphere = testsupport::madeSphere(13);
    BisectionMesh mesh(sphere);
    const Stand near{{0.0, -1.2, 0.45}, {0.15, -0.65, 0.8}, {0.0, -0.9, 0.4}}, aside{{3.0, -1.6, 1.0}, {}};
    pictures.add(mesh, near, near, 0.007, "sphere for an eye near it");
    pictures.add(mesh, near, aside, 0.007, "that mesh from aside");
}

void drawOverhang(Pictures& pictures)
{
    const BisectionSurface cliff = testsupport::madeOverhang(12);
    BisectionMesh mesh(cliff);
    const Stand near{{-1.3, 0.6, 0.35}, {0.4, 2.4, 0.75}}, aside{{-2.3, -3.2, 1.3}, {0.1, 1.7, 0.6}};
    pictures.add(mesh, near, near, 0.008, "cliff for an eye below it");
    pictures.add(mesh, near, aside, 0.008, "that cliff from aside");
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
