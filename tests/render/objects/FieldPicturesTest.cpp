// SPDX-License-Identifier: Apache-2.0
// Fields, drawn: their images are those of their objects as separate nodes.
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <osg/Material>
#include <osg/MatrixTransform>

#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgOffscreen/ImageComparison>
#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ObjectShader>
#include <osgPMObjects/ProgressiveField>

#include "ClosedMeshes.h"
#include "Random.h"
#include "RenderedPicture.h"
#include "field/FieldMesh.h"

namespace
{

using namespace osgPMObjects;

/// A torus with normals, in one colour.
osg::ref_ptr<const ProgressiveShape> shape(const osg::Vec4& colour, std::uint32_t around)
{
    core::Mesh mesh = testsupport::torus(around, around / 2);
    mesh.materials.front().attributes |= core::Material::normal;
    for (std::size_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge)
        mesh.normals.push_back(glm::normalize(mesh.positions[mesh.wedgePositions[wedge]]));
    const osg::ref_ptr<osg::Material> paint = new osg::Material;
    paint->setDiffuse(osg::Material::FRONT_AND_BACK, colour);
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(paint);
    return new ProgressiveShape(core::buildProgressiveMesh(mesh, core::simplify(mesh)), {state});
}

std::vector<FieldKind> kinds(core::SwitchSettings switching = {core::SwitchMethod::discrete})
{
    std::vector<FieldKind> made{{shape({0.9F, 0.4F, 0.2F, 1.0F}, 40), {}, switching},
                                {shape({0.3F, 0.7F, 0.4F, 1.0F}, 60), {}, switching}};
    for (FieldKind& kind : made)
        kind.selection.tolerancePx = 2.0;
    return made;
}

std::vector<FieldInstance> instances(double farM = 0.0)
{
    testsupport::Random random(17);
    std::vector<FieldInstance> made(120);
    for (std::size_t i = 0; i < made.size(); ++i)
    {
        FieldInstance& instance = made[i];
        instance.position = {farM + 60.0 * (random.unit() - 0.5), farM + 30.0 + 150.0 * random.unit(),
                             20.0 * (random.unit() - 0.5)};
        instance.attitude.makeRotate(6.0 * random.unit(), osg::Vec3d(random.unit(), random.unit(), 1.0));
        instance.scale = 0.5 + random.unit();
        instance.kind = static_cast<std::uint32_t>(i % 2);
    }
    return made;
}

osg::ref_ptr<ProgressiveField> fieldOf(const std::vector<FieldKind>& of,
                                       const std::vector<FieldInstance>& placed)
{
    osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    const auto outcome = field->setContents(of, placed);
    EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message());
    return field;
}

/// The same instances as baked geometry, each on the rung that `rungOf` gives.
template<class RungOf>
osg::ref_ptr<osg::Group> onePerObject(const std::vector<FieldKind>& of,
                                      const std::vector<FieldInstance>& placed, const RungOf& rungOf)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    addObjectShading(*root->getOrCreateStateSet());
    for (const FieldInstance& instance : placed)
    {
        const ProgressiveShape& shape = *of[instance.kind].shape;
        const core::LevelLadder ladder = core::LevelLadder::of(shape.progressive(), shape.levels());
        const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(
            osg::Matrixd::scale(instance.scale, instance.scale, instance.scale) *
            osg::Matrixd::rotate(instance.attitude) * osg::Matrixd::translate(instance.position));
        transform->addChild(bakeLevel(shape, ladder.steps[rungOf(instance, shape, ladder)]));
        root->addChild(transform);
    }
    return root;
}

/// Returns the rung that screenError chooses at first sight.
std::uint32_t rungAtFirst(const FieldInstance& instance, const ProgressiveShape& shape,
                          const core::LevelLadder& ladder, const viewlod::ViewState& view)
{
    core::SelectionSettings settings;
    settings.tolerancePx = 2.0;
    core::SelectableObject object;
    const osg::Vec3d centre =
        instance.position + instance.attitude * (osg::Vec3d(shape.sphere().centre.x, shape.sphere().centre.y,
                                                            shape.sphere().centre.z) *
                                                 instance.scale);
    object.sphere = {{centre.x(), centre.y(), centre.z()}, shape.sphere().radius * instance.scale};
    object.table = &shape.levels();
    object.settings = &settings;
    object.metresPerUnit = instance.scale;
    core::HeldLevel held;
    const auto eye = core::SelectionView::from(view);
    return ladder.rungOf(core::LevelSelector(eye).select(object, held).steps);
}

/// Counts pixels that show the sky in one image, though all pixels around them are covered in another.
std::size_t holes(const osg::Image& picture, const osg::Image& covered)
{
    const unsigned char* const sky = covered.data(0, static_cast<unsigned>(covered.t()) - 1);
    const auto isSky = [&](const osg::Image& image, int x, int y)
    { return std::equal(sky, sky + 3, image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))); };
    std::size_t count = 0;
    for (int y = 2; y + 2 < covered.t(); ++y)
        for (int x = 2; x + 2 < covered.s(); ++x)
        {
            bool isInside = true;
            for (int i = 0; i < 25; ++i)
                isInside = isInside && !isSky(covered, x + i % 5 - 2, y + i / 5 - 2);
            count += isInside && isSky(picture, x, y);
        }
    return count;
}

class FieldPictures : public testing::Test
{
protected:
    FieldPictures() : _viewer(rendered::viewerOf(new osg::Group, {.widthPx = 480, .heightPx = 360})) {}

    osg::ref_ptr<osg::Image> picture(osg::Node* scene, double farM = 0.0, double timeS = 0.0,
                                     double backM = 0.0)
    {
        look(farM, backM);
        _viewer->viewer().setSceneData(scene);
        return _viewer->picture(timeS);
    }

    void look(double farM, double backM)
    {
        const osg::Vec3d eye(farM, farM - backM, 2.0);
        _viewer->camera().setProjectionMatrixAsPerspective(40.0, 480.0 / 360.0, 0.5, 2000.0);
        _viewer->camera().setViewMatrixAsLookAt(eye, eye + osg::Vec3d(0.0, 1.0, 0.0), {0.0, 0.0, 1.0});
    }

    viewlod::ViewState view() const
    {
        const auto glmOf = [](const osg::Matrixd& m) { return glm::make_mat4(m.ptr()); };
        return viewlod::ViewState::fromMatrices(glmOf(_viewer->camera().getViewMatrix()),
                                                glmOf(_viewer->camera().getProjectionMatrix()), 480, 360);
    }

    /// From the distant view nearer in no time, by less than half of the distance in each frame: an eye that
    /// jumps sees no switch.
    void approach(const osg::ref_ptr<ProgressiveField>& field)
    {
        for (const double backM : {260.0, 160.0, 100.0, 60.0, 35.0, 18.0, 8.0})
            picture(field, 0.0, 0.0, backM);
    }

    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

TEST_F(FieldPictures, AreThoseOfEveryObjectOnItsOwn)
{
    const auto of = kinds();
    const auto placed = instances();
    const osg::ref_ptr<ProgressiveField> field = fieldOf(of, placed);
    look(0.0, 0.0);
    const auto expected = onePerObject(
        of, placed,
        [&](const FieldInstance& instance, const ProgressiveShape& shape, const core::LevelLadder& ladder)
        { return rungAtFirst(instance, shape, ladder, view()); });
    const auto alone = picture(expected), drawn = picture(field);
    const auto difference = osgOffscreen::compareImages(*alone, *drawn);
    EXPECT_TRUE(difference.sameShape);
    EXPECT_LE(difference.differingPixels, 200u) << difference.message() << ": edges that round another way";
    const auto statistics = field->statistics().at(0);
    EXPECT_GT(statistics.visible, 40u);
    EXPECT_EQ(statistics.drawn, statistics.visible);
    EXPECT_LT(statistics.drawCalls, 24u);

    auto moved = placed;
    for (FieldInstance& instance : moved)
        instance.attitude = osg::Quat(0.3, osg::Vec3d(1.0, 0.0, 0.0)) * instance.attitude;
    const auto wrong = picture(fieldOf(of, moved));
    EXPECT_GT(osgOffscreen::compareImages(*alone, *wrong).differingPixels, 2000u) << "would not be noticed";
}

/// A million metres from the origin, where floats have a step of 6 cm.
TEST_F(FieldPictures, AreTheSameFarFromTheOrigin)
{
    constexpr double kFarM = 1e6;
    const auto of = kinds();
    const auto near = picture(fieldOf(of, instances()));
    const auto far = picture(fieldOf(of, instances(kFarM)), kFarM);
    EXPECT_LE(osgOffscreen::compareImages(*near, *far).differingPixels, 200u)
        << osgOffscreen::compareImages(*near, *far).message();
}

TEST_F(FieldPictures, AreTheSameForASecondContextAndAfterRelease)
{
    const osg::ref_ptr<ProgressiveField> field = fieldOf(kinds(), instances());
    const auto first = picture(field);
    field->releaseGLObjects();
    EXPECT_TRUE(osgOffscreen::compareImages(*first, *picture(field)).identical());
    _viewer = rendered::viewerOf(new osg::Group, {.widthPx = 480, .heightPx = 360});
    const osg::ref_ptr<ProgressiveField> again = fieldOf(field->kinds(), instances());
    EXPECT_TRUE(osgOffscreen::compareImages(*first, *picture(again)).identical());
}

/// Each pixel of a screen door is that of one level or of the other.
TEST_F(FieldPictures, OfAScreenDoorHaveEveryPixelFromOneOfBothLevels)
{
    const core::SwitchSettings blend{core::SwitchMethod::blend, core::BlendProfile::cross, 1.0F, 0.0F};
    const osg::ref_ptr<ProgressiveField> blending = fieldOf(kinds(blend), instances());
    const osg::ref_ptr<ProgressiveField> hard = fieldOf(kinds(), instances());
    // First the distant view, at rest; then a step back to where levels are finer.
    approach(blending);
    picture(blending, 0.0, 0.01, 0.0); // the next frame, in which the switch begins
    const auto half = picture(blending, 0.0, 0.51, 0.0);
    EXPECT_GT(blending->statistics().at(0).switching, 20u);
    for (double timeS = 0.7; timeS < 4.0; timeS += 0.2)
        picture(blending, 0.0, timeS, 0.0);
    const auto settled = picture(blending, 0.0, 4.0, 0.0);
    EXPECT_EQ(blending->statistics().at(0).switching, 0u);
    approach(hard); // levels depend on the way, so it has to be the same
    EXPECT_LE(osgOffscreen::compareImages(*settled, *picture(hard)).differingPixels, 16u);
    EXPECT_GT(osgOffscreen::compareImages(*half, *settled).differingPixels, 100u) << "nothing was switched";
    // The outlines of both levels differ by some pixels.
    EXPECT_LE(holes(*half, *settled), 100u);

    std::vector<FieldKind> faded = kinds(blend);
    for (FieldKind& kind : faded)
        kind.selection.alpha = {0.0, 400.0};
    EXPECT_GT(holes(*picture(fieldOf(faded, instances())), *settled), 500u) << "would not be noticed";
}

/// A morph that has just begun has hardly moved, though all instances are drawn on a finer rung.
TEST_F(FieldPictures, OfAMorphBeginWhereTheCoarserLevelIs)
{
    const osg::ref_ptr<ProgressiveField> morphing =
        fieldOf(kinds({core::SwitchMethod::geomorph, core::BlendProfile::over, 1.0F, 0.0F}), instances());
    const osg::ref_ptr<ProgressiveField> hard = fieldOf(kinds(), instances());
    approach(morphing);
    const auto coarse = picture(morphing, 0.0, 0.001); // the next frame, in which the morph begins
    const auto begun = picture(morphing, 0.0, 0.0011);
    EXPECT_GT(morphing->statistics().at(0).switching, 20u);
    for (double timeS = 0.2; timeS < 6.0; timeS += 0.2)
        picture(morphing, 0.0, timeS);
    EXPECT_EQ(morphing->statistics().at(0).switching, 0u);
    const auto arrived = picture(morphing, 0.0, 6.2);

    approach(hard);
    const auto fine = picture(hard);
    const auto switched = osgOffscreen::compareImages(*coarse, *fine);
    EXPECT_GT(switched.differingPixels, 1000u) << "there is something to switch";
    EXPECT_LT(osgOffscreen::compareImages(*coarse, *begun).differingPixels, switched.differingPixels / 4);
    EXPECT_LE(osgOffscreen::compareImages(*arrived, *fine).differingPixels, 16u);
}

} // namespace
