// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/CarModel.h"

#include <algorithm>
#include <cmath>

#include <osg/Geode>
#include <osg/Group>
#include <osg/Math>

#include "scenery/nodes/ContactShadow.h"
#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/Pose.h"

namespace scenery
{

namespace
{

constexpr float kWheelbaseM = 2.65F;
constexpr float kWheelRadiusM = 0.32F;
constexpr float kHalfTrackM = 0.76F;
constexpr float kWellRadiusM = 0.39F;
constexpr float kWellInnerYM = 0.52F;
constexpr double kMostTravelM = 0.15;
constexpr int kRingPoints = 32;
const osg::Vec4f kWindow(0.07F, 0.09F, 0.11F, 1.0F);
const osg::Vec4f kBlack(0.10F, 0.10F, 0.11F, 1.0F);
const osg::Vec4f kRubber(0.15F, 0.15F, 0.16F, 1.0F);
const osg::Vec4f kAlloy(0.68F, 0.69F, 0.72F, 1.0F);
const osg::Vec4f kLamp(0.95F, 0.95F, 0.90F, 1.0F);
const osg::Vec4f kTailLamp(0.45F, 0.02F, 0.03F, 1.0F);

/// A cross section: a rounded rectangle (superellipse) that leans inwards towards its top.
struct BodySection
{
    float xM, halfWidthM, bottomM, topM, lean;
};

Ring ringOf(const BodySection& s)
{
    Ring ring;
    const float middle = 0.5F * (s.topM + s.bottomM);
    const float half = 0.5F * (s.topM - s.bottomM);
    for (int i = 0; i < kRingPoints; ++i)
    {
        const double angle = 2.0 * osg::PI * i / kRingPoints;
        const auto rounded = [](double c)
        { return static_cast<float>(std::copysign(std::pow(std::abs(c), 0.42), c)); };
        const float up = rounded(std::sin(angle));
        ring.emplace_back(s.xM,
                          s.halfWidthM * rounded(std::cos(angle)) * (1.0F - s.lean * 0.5F * (up + 1.0F)),
                          middle + half * up);
    }
    return ring;
}

template<std::size_t N>
std::vector<Ring> ringsOf(const BodySection (&sections)[N])
{
    std::vector<Ring> rings;
    for (const BodySection& section : sections)
        rings.push_back(ringOf(section));
    return rings;
}

void addBody(ModelMesh& mesh, const osg::Vec4f& paint)
{
    const BodySection sections[] = {
        {-0.86F, 0.70F, 0.36F, 0.80F, 0.05F}, {-0.82F, 0.79F, 0.30F, 0.91F, 0.05F},
        {-0.65F, 0.85F, 0.24F, 0.97F, 0.06F}, {-0.20F, 0.88F, 0.20F, 0.98F, 0.07F},
        {0.50F, 0.89F, 0.18F, 0.97F, 0.07F},  {1.30F, 0.89F, 0.18F, 0.96F, 0.07F},
        {2.00F, 0.89F, 0.18F, 0.94F, 0.07F},  {2.60F, 0.88F, 0.19F, 0.87F, 0.07F},
        {3.05F, 0.85F, 0.21F, 0.79F, 0.06F},  {3.36F, 0.79F, 0.23F, 0.71F, 0.05F},
        {3.50F, 0.71F, 0.27F, 0.65F, 0.05F},  {3.55F, 0.62F, 0.33F, 0.58F, 0.05F}};
    const std::vector<Ring> rings = ringsOf(sections);
    mesh.addLoft(rings, paint);
    // Ring points run from the left side (0) over the top (8) to the right side (16).
    for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{1, 4}, {12, 15}})
    {
        mesh.addPatch(rings, {8, 10, from, to, 0.005F}, kLamp);
    }
    mesh.addBox({0.35F, -0.86F, 0.155F}, {2.30F, 0.86F, 0.24F}, kBlack);  // sills
    mesh.addBox({3.30F, -0.46F, 0.36F}, {3.56F, 0.46F, 0.52F}, kBlack);   // grille
    mesh.addBox({-0.875F, -0.26F, 0.44F}, {-0.80F, 0.26F, 0.55F}, kLamp); // number plate
}

void addCabin(ModelMesh& mesh, const osg::Vec4f& paint)
{
    const BodySection sections[] = {
        {-0.55F, 0.74F, 0.80F, 0.97F, 0.10F}, {-0.12F, 0.77F, 0.80F, 1.34F, 0.24F},
        {0.15F, 0.79F, 0.80F, 1.43F, 0.27F},  {0.66F, 0.80F, 0.80F, 1.46F, 0.28F},
        {0.74F, 0.80F, 0.80F, 1.46F, 0.28F},  {1.14F, 0.80F, 0.80F, 1.435F, 0.27F},
        {1.24F, 0.80F, 0.80F, 1.40F, 0.26F},  {1.62F, 0.79F, 0.80F, 1.18F, 0.17F},
        {2.02F, 0.77F, 0.80F, 0.95F, 0.08F}};
    const std::vector<Ring> rings = ringsOf(sections);
    mesh.addLoft(rings, kWindow);
    mesh.addPatch(rings, {1, 6, 4, 12, 0.006F}, paint); // roof
    for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 4}, {12, 16}})
    {
        mesh.addPatch(rings, {0, 1, from, to, 0.005F}, paint); // rear pillar
        mesh.addPatch(rings, {3, 4, from, to, 0.005F}, paint); // middle pillar
    }
    for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{3, 4}, {12, 13}})
        mesh.addPatch(rings, {5, 8, from, to, 0.006F}, paint); // front pillars
}

void addFittings(ModelMesh& mesh, const osg::Vec4f& paint)
{
    const std::size_t since = mesh.triangles();
    mesh.addBox({1.62F, 0.84F, 0.94F}, {1.76F, 1.00F, 1.06F}, paint); // mirror
    mesh.addBox({-0.872F, 0.44F, 0.66F}, {-0.78F, 0.66F, 0.80F}, kTailLamp);
    mesh.addBox({0.30F, 0.872F, 0.78F}, {0.48F, 0.892F, 0.81F}, kBlack); // door handles
    mesh.addBox({1.10F, 0.872F, 0.77F}, {1.28F, 0.892F, 0.80F}, kBlack);
    mesh.mirrorSince(since);
}

/// The lining of a wheel well: an inner wall and a roof, open to the outside and below.
void addWheelWell(ModelMesh& mesh, float xM)
{
    constexpr int kSides = 24;
    const auto rim = [xM](int i, float yM)
    {
        const double angle = osg::PI * (-0.07 + 1.14 * i / kSides);
        return osg::Vec3f(xM + kWellRadiusM * static_cast<float>(std::cos(angle)), yM,
                          kWheelRadiusM + kWellRadiusM * static_cast<float>(std::sin(angle)));
    };
    const osg::Vec3f hub(xM, kWellInnerYM, kWheelRadiusM);
    for (int i = 0; i < kSides; ++i)
    {
        mesh.addFace({hub, rim(i, kWellInnerYM), rim(i + 1, kWellInnerYM)}, {0.0F, 1.0F, 0.0F}, kBlack);
        const osg::Vec3f inwards = hub - (rim(i, kWellInnerYM) + rim(i + 1, kWellInnerYM)) * 0.5F;
        mesh.addFace({rim(i, kWellInnerYM), rim(i + 1, kWellInnerYM), rim(i + 1, 0.865F)}, inwards, kBlack);
        mesh.addFace({rim(i, kWellInnerYM), rim(i + 1, 0.865F), rim(i, 0.865F)}, inwards, kBlack);
    }
}

/// About its own hub, outwards along y.
osg::ref_ptr<osg::Geometry> makeWheel()
{
    ModelMesh mesh;
    const osg::Vec3f hub(0.0F, 0.0F, 0.0F);
    const osg::Vec3f outwards(0.0F, 1.0F, 0.0F);
    const float r = kWheelRadiusM;
    mesh.addTurned({hub,
                    outwards,
                    {{-0.11F, 0.85F * r}, {-0.09F, r}, {0.09F, r}, {0.125F, 0.87F * r}, {0.125F, 0.68F * r}}},
                   kRubber);
    mesh.addTurned(
        {hub, outwards, {{0.10F, 0.68F * r}, {0.128F, 0.66F * r}, {0.132F, 0.10F}, {0.137F, 0.05F}}}, kAlloy);
    for (int spoke = 0; spoke < 5; ++spoke)
    {
        // Dark gaps between the spokes.
        const double angle = osg::PI * 2.0 * (spoke + 0.5) / 5.0;
        const osg::Vec3f around(static_cast<float>(std::cos(angle)), 0.0F,
                                static_cast<float>(std::sin(angle)));
        mesh.addTurned({around * (0.43F * r), outwards, {{0.11F, 0.055F}, {0.1345F, 0.05F}}, 10}, kBlack);
    }
    return mesh.geometry();
}

osg::ref_ptr<osg::Geode> makeShell(const osg::Vec4f& paint)
{
    ModelMesh mesh;
    addBody(mesh, paint);
    addCabin(mesh, paint);
    addFittings(mesh, paint);
    osg::ref_ptr<osg::Geode> shell = new osg::Geode;
    shell->addDrawable(mesh.geometry());
    setObjectShading(*shell, Finish::lacquered,
                     {{0.0F, kWheelRadiusM}, {kWheelbaseM, kWheelRadiusM}, kWellRadiusM, kWellInnerYM});
    return shell;
}

osg::ref_ptr<osg::Geode> makeWheelWells()
{
    ModelMesh mesh;
    for (const float xM : {0.0F, kWheelbaseM})
        addWheelWell(mesh, xM);
    mesh.mirrorSince(0);
    osg::ref_ptr<osg::Geode> wells = new osg::Geode;
    wells->addDrawable(mesh.geometry());
    return wells;
}

} // namespace

CarModel::CarModel(const osg::Vec4f& paint) : _placed(new osg::MatrixTransform)
{
    _placed->setName("car");
    _placed->setDataVariance(osg::Object::DYNAMIC);
    _placed->addChild(makeShell(paint));
    const osg::ref_ptr<osg::Group> dull = new osg::Group;
    setObjectShading(*dull, Finish::matt);
    dull->addChild(makeWheelWells());
    const osg::ref_ptr<osg::Geode> wheel = new osg::Geode;
    wheel->addDrawable(makeWheel());
    for (auto& place : _wheels)
    {
        place = new osg::MatrixTransform;
        place->setDataVariance(osg::Object::DYNAMIC);
        place->addChild(wheel);
        dull->addChild(place);
    }
    _placed->addChild(dull);
    _placed->addChild(makeContactShadow({1.34F, 0.0F}, 2.3F, 0.95F));
    setState({});
}

void CarModel::setState(const simulation::EntityState& state)
{
    const glm::dmat4 placed = worldFromModel(poseOf(state));
    _placed->setMatrix(osg::Matrixd(&placed[0][0]));
    for (std::size_t i = 0; i < _wheels.size(); ++i)
    {
        const bool isLeft = i % 2 == 0;
        const bool isFront = i < 2;
        const double travelM = std::clamp(state.wheelTravelM[i], -kMostTravelM, kMostTravelM);
        // The wheel is made for the left side; on the right it is turned about, so that its outside shows.
        const double steeringRad =
            osg::DegreesToRadians((isFront ? state.steeringDeg : 0.0) + (isLeft ? 0.0 : 180.0));
        const double rollingRad =
            osg::DegreesToRadians(isLeft ? state.wheelRotationDeg : -state.wheelRotationDeg);
        _wheels[i]->setMatrix(osg::Matrixd::rotate(rollingRad, osg::Vec3d(0.0, 1.0, 0.0)) *
                              osg::Matrixd::rotate(steeringRad, osg::Vec3d(0.0, 0.0, 1.0)) *
                              osg::Matrixd::translate(isFront ? kWheelbaseM : 0.0,
                                                      isLeft ? kHalfTrackM : -kHalfTrackM,
                                                      kWheelRadiusM + travelM));
    }
}

glm::dvec3 driverEyeInCar(double heightM)
{
    return {1.25, 0.36, heightM};
}

} // namespace scenery
