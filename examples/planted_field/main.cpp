// SPDX-License-Identifier: Apache-2.0
// Draws ten thousand copies of a model, each at the level of detail that the view needs, in a few draw calls:
//   planted_field FOLDER [MODEL]      writes among.png, above.png; without MODEL: firs made of a cone and a
//                                     trunk
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Material>
#include <osg/ShapeDrawable>
#include <osgDB/ReadFile>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>
#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ProgressiveField>

namespace
{

using namespace osgPMObjects;

constexpr double kPlantedM = 1000.0; ///< side of the square
constexpr int kInstances = 10000;

int failed(const foundation::Error& error)
{
    std::fprintf(stderr, "planted_field: %s\n", error.message().c_str());
    return 1;
}

void paint(osg::Drawable& drawable, const osg::Vec4& colour)
{
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, colour);
    material->setAmbient(osg::Material::FRONT_AND_BACK, colour);
    drawable.getOrCreateStateSet()->setAttributeAndModes(material);
}

osg::ref_ptr<osg::Drawable> painted(osg::Shape* shape, const osg::Vec4& colour)
{
    const osg::ref_ptr<osg::TessellationHints> fine = new osg::TessellationHints;
    fine->setDetailRatio(2.0F);
    const osg::ref_ptr<osg::ShapeDrawable> drawable = new osg::ShapeDrawable(shape, fine);
    paint(*drawable, colour);
    return drawable;
}

osg::ref_ptr<osg::Node> meadow()
{
    constexpr float kSide = 10000.0F;
    const osg::ref_ptr<osg::Geometry> ground = osg::createTexturedQuadGeometry(
        {-0.5F * kSide, -0.5F * kSide, 0.0F}, {kSide, 0.0F, 0.0F}, {0.0F, kSide, 0.0F});
    const osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
    colour->front().set(0.36F, 0.45F, 0.23F, 1.0F);
    ground->setColorArray(colour);
    ground->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return ground;
}

osg::ref_ptr<osg::Node> fir()
{
    const osg::ref_ptr<osg::Geode> tree = new osg::Geode;
    tree->addDrawable(
        painted(new osg::Cylinder({0.0F, 0.0F, 1.0F}, 0.25F, 2.0F), {0.33F, 0.24F, 0.16F, 1.0F}));
    tree->addDrawable(painted(new osg::Cone({0.0F, 0.0F, 3.5F}, 2.0F, 8.0F), {0.13F, 0.3F, 0.16F, 1.0F}));
    return tree;
}

/// Places instances at random, each with its own rotation and size.
std::vector<FieldInstance> planted(double modelRadiusM)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<FieldInstance> instances(kInstances);
    for (FieldInstance& instance : instances)
    {
        instance.position.set((share(random) - 0.5) * kPlantedM, (share(random) - 0.5) * kPlantedM, 0.0);
        instance.attitude.makeRotate(2.0 * osg::PI * share(random), osg::Z_AXIS);
        instance.scale = (4.0 + 2.0 * share(random)) / modelRadiusM;
    }
    return instances;
}

void sayWhatIsInTheMiddle(osg::Node& scene, const osg::Vec3d& eye)
{
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(eye, eye + osg::Vec3d(0.0, 2.0 * kPlantedM, 0.0));
    osgUtil::IntersectionVisitor visitor(ray);
    scene.accept(visitor);
    if (!ray->containsIntersections()) return;
    const auto hit = ray->getFirstIntersection();
    const auto instance = ProgressiveField::instanceOf(hit.nodePath);
    std::printf("straight ahead: instance %u, %.1f m away\n", instance.value_or(0),
                (hit.getWorldIntersectPoint() - eye).length());
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) return std::fprintf(stderr, "usage: planted_field FOLDER [MODEL]\n"), 2;
    const osg::ref_ptr<osg::Node> model = argc > 2 ? osgDB::readRefNodeFile(argv[2]) : fir();
    if (!model) return std::fprintf(stderr, "planted_field: '%s' cannot be read\n", argv[2]), 1;
    const auto progressive = makeProgressive(*model);
    if (!progressive) return failed(progressive.error());
    const osg::ref_ptr<const ProgressiveShape> shape = progressive->node->shape();

    FieldKind kind{shape};
    kind.selection.method = core::SelectionMethod::screenError; // an error of half a pixel is not visible
    kind.selection.tolerancePx = 0.5;
    kind.switching = {core::SwitchMethod::blend, core::BlendProfile::cross, 0.3F, 0.0F};
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    if (const auto set = field->setContents({kind}, planted(shape->sphere().radius)); !set)
        return failed(set.error());

    auto viewer = osgOffscreen::OffscreenViewer::create({.widthPx = 960, .heightPx = 540});
    if (!viewer) return failed(viewer.error());
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(meadow());
    scene->addChild(field);
    (*viewer)->viewer().setSceneData(scene);
    osg::Camera& camera = (*viewer)->camera();
    camera.setProjectionMatrixAsPerspective(45.0, 16.0 / 9.0, 0.5, 5000.0);
    camera.setClearColor({0.66F, 0.75F, 0.84F, 1.0F});
    const auto take = [&](const char* name, const osg::Vec3d& eye, const osg::Vec3d& at)
    {
        camera.setViewMatrixAsLookAt(eye, at, osg::Z_AXIS);
        const auto written =
            osgOffscreen::writePng(*(*viewer)->picture(), std::filesystem::path(argv[1]) / name);
        const FieldViewStatistics seen = field->statistics().at(0);
        std::printf("%s: %u of %d in sight, %llu triangles in %u draws\n", name, seen.visible, kInstances,
                    static_cast<unsigned long long>(seen.triangles), seen.drawCalls);
        return written;
    };
    const osg::Vec3d eye(0.0, -0.5 * kPlantedM - 20.0, 3.0);
    if (const auto done = take("among.png", eye, {0.0, 0.0, 3.0}); !done) return failed(done.error());
    if (const auto done = take("above.png", {0.0, -1.1 * kPlantedM, 350.0}, {}); !done)
        return failed(done.error());
    sayWhatIsInTheMiddle(*field, eye);
    return 0;
}
