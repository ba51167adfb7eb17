// SPDX-License-Identifier: Apache-2.0
// triangulation_sheet FILE.mt FOLDER: draws pictures of a multi-triangulation. FOLDER/ground.png: the ground
// by it and by ROAM at the same tolerance, as it looks and as triangles. From above, the triangles coloured
// by their trees: FOLDER/states.png, as figure 2 of the paper has it, the main part, the main part with one
// tree, the root and the drain; FOLDER/zone.png, the zone around two eyes. Prints counts of triangles.
// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), figure 2.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <osg/TriangleFunctor>

#include <osgMultiTriangulation/core/extract/EyeCriterion.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

#include <osgMultiTriangulation/OpenMultiTriangulation>
#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>

#include "SheetPictures.h"
#include "measurement/view/ContactSheet.h"

namespace
{

using namespace osgMultiTriangulation;

constexpr double kTolerancePx = 2.0;
constexpr double kHeightDeg = 45.0;

using measurement::drawnTriangles;
using sheet::endWith, sheet::Soup, sheet::viewerOn, sheet::write;

/// Collects the triangles of a drawable, lighter the flatter they are.
struct Shaded
{
    Soup* soup = nullptr;

    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false) const
    {
        soup->addLit(a, b, c);
    }
};

Soup soupOf(const osg::Drawable& drawable)
{
    Soup soup;
    osg::TriangleFunctor<Shaded> functor;
    functor.soup = &soup;
    drawable.accept(functor);
    return soup;
}

/// A camera over the south-western corner, which looks across the ground.
osg::ref_ptr<osg::Image> groundPicture(osg::Node* scene, const osg::BoundingBox& box)
{
    const auto viewer = viewerOn(scene, 960, 540);
    viewer->camera().setProjectionMatrixAsPerspective(kHeightDeg, 960.0 / 540.0, 5.0, 4.0 * box.radius());
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    const double side = box.xMax() - box.xMin(), relief = box.zMax() - box.zMin();
    const osg::Vec3d eye(box.xMin() + 0.3 * side, box.yMin() + 0.3 * side, box.zMin() + 0.9 * relief);
    viewer->camera().setViewMatrixAsLookAt(
        eye, eye + osg::Vec3d(0.5 * side, 0.5 * side, -0.5 * relief - 0.12 * side), {0.0, 0.0, 1.0});
    return viewer->picture();
}

void drawGround(const std::filesystem::path& path, const std::filesystem::path& folder)
{
    auto opened = openMultiTriangulation(path, {.waits = true});
    if (!opened) endWith(opened.error().message());
    osgTerrainROAM::RoamDrawable& roam = *opened->terrain->drawable();
    if (!roam.setErrorTolerancePx(kTolerancePx)) endWith("the tolerance is refused");
    const osg::BoundingBox box = opened->drawable->getBoundingBox();
    std::vector<std::filesystem::path> files;
    std::vector<osg::ref_ptr<osg::Image>> wires;
    for (osg::Drawable* const drawn :
         {static_cast<osg::Drawable*>(opened->drawable.get()), static_cast<osg::Drawable*>(&roam)})
    {
        opened->drawable->setNodeMask(drawn == opened->drawable ? ~0u : 0u);
        roam.setNodeMask(drawn == &roam ? ~0u : 0u);
        const char* const name = drawn == &roam ? "roam" : "mt";
        write(*groundPicture(opened->terrain, box), folder / (std::string(name) + ".png"), files);
        const Soup soup = soupOf(*drawn);
        std::printf("%s: %zu triangles at %g px\n", name, soup.corners->size() / 3, kTolerancePx);
        wires.push_back(groundPicture(drawnTriangles(soup), box));
    }
    write(*wires[0], folder / "mt-wires.png", files);
    write(*wires[1], folder / "roam-wires.png", files);
    const auto sheet = measurement::makeContactSheet(files, {2, 2, 1600, 4});
    if (!sheet || !osgOffscreen::writePng(**sheet, folder / "ground.png")) endWith("no sheet");
}

osg::Vec4 colourOf(std::uint32_t tree)
{
    const std::uint32_t mixed = tree * 2654435761u;
    const auto part = [&](int shift)
    { return 0.55F + 0.4F * static_cast<float>(mixed >> shift & 255u) / 255.0F; };
    return tree == 0 ? osg::Vec4(0.9F, 0.9F, 0.88F, 1.0F) : osg::Vec4(part(24), part(16), part(8), 1.0F);
}

Soup planOf(const core::Extraction& extraction)
{
    Soup soup;
    for (const core::InTree& at : extraction.active())
    {
        const core::MultiTriangulation& tree = extraction.part(at.tree);
        osg::Vec3 places[3];
        for (int c = 0; c < 3; ++c)
        {
            const core::SurfacePoint& p = tree.points[tree.corners[at.number][c]];
            places[c].set(static_cast<float>(p.x), static_cast<float>(p.y), 0.0F);
        }
        soup.add(places[0], places[1], places[2], colourOf(at.tree));
    }
    return soup;
}

osg::ref_ptr<osg::Image> planPicture(const core::Extraction& extraction, const char* name)
{
    const Soup soup = planOf(extraction);
    std::printf("%s: %zu triangles\n", name, soup.corners->size() / 3);
    const osg::ref_ptr<osg::Group> scene = drawnTriangles(soup);
    const osg::BoundingSphere bound = scene->getBound();
    const auto viewer = viewerOn(scene, 800, 800);
    osg::BoundingBox box;
    for (const osg::Vec3& corner : *soup.corners)
        box.expandBy(corner);
    const double margin = 0.02 * bound.radius();
    viewer->camera().setViewMatrixAsLookAt({0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
    viewer->camera().setProjectionMatrixAsOrtho(box.xMin() - margin, box.xMax() + margin, box.yMin() - margin,
                                                box.yMax() + margin, 1.0, 20.0);
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    return viewer->picture();
}

/// The trees of a file that are needed for one of them, and the extraction of all their triangles.
void drawStates(const core::MtFile& file, const std::filesystem::path& folder,
                std::vector<std::filesystem::path>& files)
{
    const auto everything = [](const core::MultiTriangulation&, std::uint32_t) { return true; };
    std::vector<core::ReadTree> trees;
    for (std::uint32_t t = 0; t < file.info().trees.size(); ++t)
    {
        auto read = file.read(t, t == 0 ? nullptr : &trees[file.info().trees[t].parent]);
        if (!read) endWith(read.error().message());
        trees.push_back(std::move(*read));
    }
    core::Extraction extraction(trees[0].tree);
    const auto root = planPicture(extraction, "root");
    extraction.refine(everything);
    write(*planPicture(extraction, "main part"), folder / "main.png", files);
    std::set<std::uint32_t> chain;
    for (auto t = static_cast<std::uint32_t>(trees.size() - 1); t != 0; t = file.info().trees[t].parent)
        chain.insert(t);
    for (const std::uint32_t t : chain)
        extraction.attach(t, trees[t].tree);
    extraction.refine(everything);
    write(*planPicture(extraction, "main part and a tree, with those above it"), folder / "tree.png", files);
    write(*root, folder / "root.png", files);
    for (std::uint32_t t = 1; t < trees.size(); ++t)
        if (!extraction.isAttached(t)) extraction.attach(t, trees[t].tree);
    extraction.refine(everything);
    write(*planPicture(extraction, "drain"), folder / "drain.png", files);
}

/// Around eyes on the way from the south-west to the north-east, with nothing loaded beyond a quarter of the
/// extent.
void drawZone(const core::MtFile& file, const std::filesystem::path& folder,
              std::vector<std::filesystem::path>& files)
{
    const core::MtEntry& main = file.info().trees[0];
    const core::PlanFrame& frame = file.info().frame;
    const double width = (double(main.high[0]) - main.low[0]) * frame.stepX;
    for (const double share : {0.3, 0.62})
    {
        core::ZoneSettings settings;
        settings.completeWithin = 0.05 * width;
        settings.nothingBeyond = 0.25 * width;
        settings.memoryBytes = std::size_t{1} << 30;
        const auto zone = core::InterestZone::open(file, settings);
        if (!zone) endWith(zone.error().message());
        const double x = main.low[0] + share * (double(main.high[0]) - main.low[0]);
        const double y = main.low[1] + share * (double(main.high[1]) - main.low[1]);
        (*zone)->moveTo(x, y);
        core::EyeCriterion criterion;
        criterion.step = {frame.stepX, frame.stepY};
        criterion.eye = {x * frame.stepX, y * frame.stepY, 0.0};
        criterion.errorPerDistance = 0.1 * main.rootError / width;
        (*zone)->extraction().update(criterion);
        const std::string name = "zone at " + std::to_string(share);
        write(*planPicture((*zone)->extraction(), name.c_str()),
              folder / ("zone" + std::to_string(files.size()) + ".png"), files);
        std::printf("  %zu of %zu trees, %zu bytes\n", (*zone)->loadedTrees(), file.info().trees.size(),
                    (*zone)->memoryBytes());
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::fprintf(stderr, "usage: triangulation_sheet FILE.mt FOLDER\n");
        return 2;
    }
    const std::filesystem::path path = argv[1], folder = argv[2];
    std::filesystem::create_directories(folder);
    drawGround(path, folder);
    const auto file = core::MtFile::open(path);
    if (!file) endWith(file.error().message());
    for (const auto& [draw, name] : {std::pair{&drawStates, "states.png"}, {&drawZone, "zone.png"}})
    {
        std::vector<std::filesystem::path> plans;
        draw(*file, folder, plans);
        const auto sheet = measurement::makeContactSheet(plans, {2, 2, 1600, 4});
        if (!sheet || !osgOffscreen::writePng(**sheet, folder / name)) endWith("no sheet");
    }
    return 0;
}
