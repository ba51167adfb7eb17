// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/AircraftModel.h"

#include <array>
#include <cmath>

#include <osg/Geode>
#include <osg/Group>
#include <osg/Math>
#include <osg/MatrixTransform>

#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

const osg::Vec4f kWhite(0.93F, 0.93F, 0.91F, 1.0F);
const osg::Vec4f kCanopy(0.10F, 0.13F, 0.16F, 1.0F);
const osg::Vec4f kMetal(0.62F, 0.63F, 0.66F, 1.0F);
const osg::Vec4f kTyre(0.14F, 0.14F, 0.15F, 1.0F);
constexpr int kFuselagePoints = 32;
constexpr float kPropellerXM = 2.42F;
constexpr float kPropellerZM = 1.22F;

/// A cross section of the fuselage: between an ellipse and a rectangle.
struct FuselageSection
{
    float xM, zM, halfWidthM, halfHeightM;
};

Ring ringOf(const FuselageSection& s)
{
    Ring ring;
    for (int i = 0; i < kFuselagePoints; ++i)
    {
        const double angle = 2.0 * osg::PI * i / kFuselagePoints;
        const auto rounded = [](double c)
        { return static_cast<float>(std::copysign(std::pow(std::abs(c), 0.72), c)); };
        ring.emplace_back(s.xM, s.halfWidthM * rounded(std::cos(angle)),
                          s.zM + s.halfHeightM * rounded(std::sin(angle)));
    }
    return ring;
}

void addFuselage(ModelMesh& mesh, const osg::Vec4f& trim)
{
    const FuselageSection sections[] = {
        {2.34F, 1.22F, 0.22F, 0.20F},   {2.28F, 1.22F, 0.36F, 0.31F},  {2.05F, 1.21F, 0.45F, 0.41F},
        {1.60F, 1.20F, 0.51F, 0.47F},   {1.22F, 1.20F, 0.54F, 0.50F},  {0.98F, 1.28F, 0.555F, 0.58F},
        {0.66F, 1.40F, 0.56F, 0.69F},   {0.52F, 1.41F, 0.56F, 0.70F},  {-0.30F, 1.41F, 0.55F, 0.70F},
        {-0.40F, 1.41F, 0.545F, 0.70F}, {-1.15F, 1.42F, 0.49F, 0.63F}, {-1.60F, 1.43F, 0.43F, 0.52F},
        {-2.30F, 1.43F, 0.34F, 0.40F},  {-4.00F, 1.47F, 0.17F, 0.23F}, {-5.20F, 1.52F, 0.05F, 0.13F}};
    std::vector<Ring> rings;
    for (const FuselageSection& section : sections)
        rings.push_back(ringOf(section));
    mesh.addLoft(rings, kWhite, 60.0);
    // Ring points run from the left side (0) over the top (8) to the right side (16).
    mesh.addPatch(rings, {4, 6, 2, 14, 0.008F}, kCanopy); // windscreen
    for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{1, 5}, {11, 15}})
    {
        mesh.addPatch(rings, {7, 8, from, to, 0.008F}, kCanopy);  // doors
        mesh.addPatch(rings, {9, 10, from, to, 0.008F}, kCanopy); // rear windows
    }
    for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{31, 32}, {16, 17}})
        mesh.addPatch(rings, {1, 13, from, to, 0.006F}, trim);          // stripe along both sides
    mesh.addBox({2.25F, -0.24F, 1.02F}, {2.352F, 0.24F, 1.10F}, kTyre); // air intake
}

/// A symmetric aerofoil of 12 % thickness across the direction `thickness`, from a leading edge backwards.
/// Source: Jacobs, Ward & Pinkerton, NACA Report 460, 1933: the thickness distribution of four-digit aerofoils.
Ring aerofoil(const osg::Vec3f& leadingEdge, float chordM, const osg::Vec3f& thickness)
{
    constexpr int kHalf = 10;
    Ring ring;
    for (int i = 0; i < 2 * kHalf; ++i)
    {
        const double angle = osg::PI * i / kHalf;
        const double c = 0.5 * (1.0 - std::cos(angle));
        const double t = 0.6 * (0.2969 * std::sqrt(c) - 0.126 * c - 0.3516 * c * c + 0.2843 * c * c * c -
                                0.1036 * c * c * c * c);
        const auto side = static_cast<float>(i <= kHalf ? t : -t);
        ring.push_back(leadingEdge + osg::Vec3f(-chordM * static_cast<float>(c), 0.0F, 0.0F) +
                       thickness * (chordM * side));
    }
    return ring;
}

void addWings(ModelMesh& mesh, const osg::Vec4f& trim)
{
    const osg::Vec3f up(0.0F, 0.0F, 1.0F);
    const std::size_t since = mesh.triangles();
    const std::vector<Ring> wing = {aerofoil({0.95F, 0.0F, 2.06F}, 1.62F, up),
                                    aerofoil({0.95F, 2.6F, 2.13F}, 1.62F, up),
                                    aerofoil({0.84F, 4.9F, 2.20F}, 1.22F, up)};
    mesh.addLoft(wing, kWhite, 50.0);
    const std::vector<Ring> tip = {aerofoil({0.84F, 4.9F, 2.20F}, 1.22F, up),
                                   aerofoil({0.80F, 5.4F, 2.215F}, 1.10F, up),
                                   aerofoil({0.60F, 5.5F, 2.22F}, 0.70F, up)};
    mesh.addLoft(tip, trim, 50.0);
    const std::vector<Ring> tail = {aerofoil({-4.05F, 0.0F, 1.55F}, 1.05F, up),
                                    aerofoil({-4.25F, 1.65F, 1.55F}, 0.75F, up),
                                    aerofoil({-4.35F, 1.72F, 1.55F}, 0.50F, up)};
    mesh.addLoft(tail, kWhite, 50.0);
    mesh.addBar({0.42F, 0.50F, 0.92F}, {0.42F, 2.55F, 2.08F}, 0.035F, kWhite); // strut
    mesh.mirrorSince(since);

    const osg::Vec3f sideways(0.0F, 1.0F, 0.0F);
    const std::vector<Ring> fin = {aerofoil({-2.9F, 0.0F, 1.62F}, 2.30F, sideways * 0.5F),
                                   aerofoil({-3.85F, 0.0F, 1.80F}, 1.40F, sideways * 0.8F),
                                   aerofoil({-4.55F, 0.0F, 2.60F}, 0.90F, sideways),
                                   aerofoil({-4.72F, 0.0F, 2.75F}, 0.62F, sideways)};
    mesh.addLoft(fin, trim, 50.0);
}

void addWheel(ModelMesh& mesh, const osg::Vec3f& hub, float radiusM)
{
    mesh.addTurned({hub,
                    {0.0F, 1.0F, 0.0F},
                    {{-0.08F, 0.7F * radiusM}, {-0.06F, radiusM}, {0.06F, radiusM}, {0.08F, 0.7F * radiusM}}},
                   kTyre);
    mesh.addTurned({hub, {0.0F, 1.0F, 0.0F}, {{-0.09F, 0.09F}, {0.09F, 0.09F}}, 16}, kMetal);
}

/// Where a leg's wheel touches the ground in the model, and its name in the graph.
struct LegPlace
{
    const char* name;
    osg::Vec3d bottom;
};

const std::array<LegPlace, simulation::kGearLegs> kLegPlaces = {
    {{"nose gear", {1.70, 0.0, 0.0}}, {"left gear", {0.0, 1.26, 0.0}}, {"right gear", {0.0, -1.26, 0.0}}}};
const char* const kPropellerName = "propeller";

/// `side`: 1 left, -1 right.
void addMainLeg(ModelMesh& mesh, float side)
{
    mesh.addBar({0.05F, side * 0.40F, 0.80F}, {0.0F, side * 1.12F, 0.26F}, 0.04F, kWhite);
    mesh.addBar({0.0F, side * 1.10F, 0.22F}, {0.0F, side * 1.26F, 0.22F}, 0.03F, kMetal);
    addWheel(mesh, {0.0F, side * 1.26F, 0.22F}, 0.22F);
}

void addNoseLeg(ModelMesh& mesh)
{
    mesh.addBar({1.62F, 0.0F, 0.85F}, {1.68F, 0.0F, 0.42F}, 0.045F, kMetal);
    mesh.addBar({1.68F, 0.10F, 0.44F}, {1.70F, 0.10F, 0.19F}, 0.02F, kMetal);
    mesh.addBar({1.68F, -0.10F, 0.44F}, {1.70F, -0.10F, 0.19F}, 0.02F, kMetal);
    addWheel(mesh, {1.70F, 0.0F, 0.19F}, 0.19F);
}

osg::ref_ptr<osg::Node> legNode(int leg)
{
    ModelMesh mesh;
    if (leg == simulation::kNoseLeg)
        addNoseLeg(mesh);
    else
        addMainLeg(mesh, leg == simulation::kLeftLeg ? 1.0F : -1.0F);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(mesh.geometry());
    setObjectShading(*geode, Finish::lacquered);
    const osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform;
    placed->setName(kLegPlaces[static_cast<std::size_t>(leg)].name);
    placed->setDataVariance(osg::Object::DYNAMIC);
    placed->addChild(geode);
    return placed;
}

/// What the eye keeps of two blades at 40 turns a second: a thin disc, a little darker towards its rim.
osg::ref_ptr<osg::Geometry> propellerBlur()
{
    constexpr int kSides = 48;
    const std::array<std::pair<float, float>, 4> rims = {
        {{0.12F, 0.30F}, {0.60F, 0.16F}, {0.92F, 0.20F}, {0.97F, 0.0F}}};
    osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (std::size_t r = 0; r < rims.size(); ++r)
    {
        for (int i = 0; i <= kSides; ++i)
        {
            const double angle = 2.0 * osg::PI * i / kSides;
            positions->push_back({kPropellerXM, rims[r].first * static_cast<float>(std::cos(angle)),
                                  kPropellerZM + rims[r].first * static_cast<float>(std::sin(angle))});
            colours->push_back({0.25F, 0.25F, 0.26F, rims[r].second});
            if (r == 0 || i == 0) continue;
            const int corner = static_cast<int>(r) * (kSides + 1) + i;
            const int inner = corner - kSides - 1;
            for (const int index : {corner, inner, inner - 1, corner, inner - 1, corner - 1})
                faces->push_back(static_cast<GLushort>(index));
        }
    }
    osg::ref_ptr<osg::Vec3Array> forward = new osg::Vec3Array(1);
    forward->front().set(1.0F, 0.0F, 0.0F);
    osg::ref_ptr<osg::Geometry> disc = new osg::Geometry;
    disc->setVertexArray(positions);
    disc->setNormalArray(forward, osg::Array::BIND_OVERALL);
    disc->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    disc->addPrimitiveSet(faces);
    disc->setUseDisplayList(false);
    disc->setUseVertexBufferObjects(true);
    return disc;
}

} // namespace

osg::ref_ptr<osg::Group> makeLightAircraft(const osg::Vec4f& trim)
{
    ModelMesh mesh;
    addFuselage(mesh, trim);
    addWings(mesh, trim);
    mesh.addTurned({{2.34F, 0.0F, kPropellerZM},
                    {1.0F, 0.0F, 0.0F},
                    {{0.0F, 0.17F}, {0.12F, 0.15F}, {0.24F, 0.09F}, {0.31F, 0.01F}}},
                   trim); // spinner

    osg::ref_ptr<osg::Group> aircraft = new osg::Group;
    aircraft->setName("light aircraft");
    osg::ref_ptr<osg::Geode> body = new osg::Geode;
    body->addDrawable(mesh.geometry());
    setObjectShading(*body, Finish::lacquered);
    aircraft->addChild(body);
    for (int leg = 0; leg < simulation::kGearLegs; ++leg)
        aircraft->addChild(legNode(leg));
    osg::ref_ptr<osg::Geode> blur = new osg::Geode;
    blur->setName(kPropellerName);
    blur->addDrawable(propellerBlur());
    setObjectShading(*blur, Finish::seeThrough);
    aircraft->addChild(blur);
    return aircraft;
}

void showAircraftParts(osg::Group& aircraft, const simulation::AircraftParts& parts)
{
    constexpr double kBlurRadps = 20.0;
    for (unsigned i = 0; i < aircraft.getNumChildren(); ++i)
    {
        osg::Node* const child = aircraft.getChild(i);
        if (child->getName() == kPropellerName)
            child->setNodeMask(parts.propellerRadps > kBlurRadps ? ~0U : 0U);
        for (std::size_t leg = 0; leg < kLegPlaces.size(); ++leg)
        {
            auto* const placed = dynamic_cast<osg::MatrixTransform*>(child);
            if (!placed || placed->getName() != kLegPlaces[leg].name) continue;
            const glm::dvec3& bottom = parts.wheelBottom[leg];
            placed->setMatrix(osg::Matrixd::translate(
                osg::Vec3d(bottom.x, bottom.y, bottom.z + parts.strutM[leg]) - kLegPlaces[leg].bottom));
        }
    }
}

glm::dvec3 pilotEyeInAircraft()
{
    return {0.45, 0.27, 1.75};
}

} // namespace scenery
