// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/CoverModels.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

namespace
{

using models::Corner;
using models::Dice;
using models::ModelBuilder;

constexpr double kFull = 2.0 * std::numbers::pi;

/// A colour of the palette as objects have it: the shader squares it.
glm::vec3 shown(const osgTerrainROAM::TerrainMaterial& material, const char* uniform, float factor)
{
    osg::Vec3f albedo(0.1F, 0.1F, 0.1F);
    if (const osg::Uniform* const found = material.stateSet()->getUniform(uniform)) found->get(albedo);
    return {std::sqrt(factor * albedo.x()), std::sqrt(factor * albedo.y()), std::sqrt(factor * albedo.z())};
}

struct Blade
{
    double heading, lengthM, widthM, lean; ///< lean: 0 upright … 1 flat
};

/// A blade of two triangles and a tip that bends over. Normals look up, as the ground's do: from afar it is
/// as bright as the ground.
void addBlade(ModelBuilder& builder, const glm::dvec3& foot, const Blade& blade)
{
    const glm::dvec3 out(std::cos(blade.heading), std::sin(blade.heading), 0.0);
    const glm::dvec3 side = 0.5 * blade.widthM * glm::dvec3(-out.y, out.x, 0.0);
    const double up = std::sqrt(1.0 - blade.lean * blade.lean);
    const glm::dvec3 middle =
        foot + 0.55 * blade.lengthM * (0.6 * blade.lean * out + glm::dvec3(0.0, 0.0, up));
    const glm::dvec3 tip =
        middle + 0.45 * blade.lengthM * (blade.lean * 1.6 * out + glm::dvec3(0.0, 0.0, 0.6 * up));
    const glm::vec3 normal = glm::normalize(glm::vec3(0.35 * out) + glm::vec3(0.0F, 0.0F, 1.0F));
    const auto corner = [&](const glm::dvec3& at, float light) { return Corner{at, {}, normal, light}; };
    builder.quad(corner(foot - side, 0.62F), corner(foot + side, 0.62F), corner(middle + 0.7 * side, 0.95F),
                 corner(middle - 0.7 * side, 0.95F));
    builder.triangle(corner(middle - 0.7 * side, 0.95F), corner(middle + 0.7 * side, 0.95F),
                     corner(tip, 1.0F));
}

models::Model tuft(const glm::vec3& green, const glm::vec3& pale)
{
    ModelBuilder builder;
    Dice dice(11);
    builder.begin("grass", {}, green);
    for (int i = 0; i < 20; ++i)
    {
        builder.tint(dice.chance(0.25) ? pale : green);
        const double turn = dice.between(0.0, kFull), awayM = 0.15 * std::sqrt(dice.unit());
        addBlade(builder, {awayM * std::cos(turn), awayM * std::sin(turn), -0.01},
                 {turn + dice.between(-0.8, 0.8), dice.between(0.12, 0.24), dice.between(0.011, 0.020),
                  dice.between(0.1, 0.6)});
    }
    return builder.finish();
}

models::Model herb(const glm::vec3& green)
{
    ModelBuilder builder;
    Dice dice(12);
    builder.begin("herb", {}, green);
    for (int i = 0; i < 9; ++i)
        addBlade(builder, {0.0, 0.0, -0.01},
                 {i * kFull / 9.0 + dice.between(-0.2, 0.2), dice.between(0.10, 0.18),
                  dice.between(0.03, 0.045), dice.between(0.6, 0.9)});
    for (int i = 0; i < 3; ++i)
    {
        const double turn = dice.between(0.0, kFull);
        const glm::dvec3 foot(0.02 * std::cos(turn), 0.02 * std::sin(turn), 0.0);
        builder.tint(green);
        addBlade(builder, foot, {turn, 0.30, 0.006, 0.15});
        builder.tint({0.92F, 0.86F, 0.45F});
        for (int petal = 0; petal < 5; ++petal)
            addBlade(builder, foot + glm::dvec3(0.03 * std::cos(turn), 0.03 * std::sin(turn), 0.27),
                     {petal * kFull / 5.0, 0.018, 0.012, 0.85});
    }
    return builder.finish();
}

/// A ring of points round a dome, pushed in and out.
models::Model stone(const glm::vec3& colour)
{
    ModelBuilder builder;
    Dice dice(13);
    builder.begin("stone", {}, colour);
    constexpr int kSides = 7;
    std::vector<std::vector<Corner>> rows(3);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (int i = 0; i <= kSides; ++i)
        {
            if (i == kSides)
            {
                rows[row].push_back(rows[row].front());
                break;
            }
            const double radiusM = (row == 0 ? 0.065 : row == 1 ? 0.055 : 0.02) * dice.between(0.75, 1.2);
            const double turn = i * kFull / kSides;
            rows[row].push_back({{radiusM * std::cos(turn), 0.8 * radiusM * std::sin(turn),
                                  row == 0   ? -0.02
                                  : row == 1 ? 0.03 * dice.between(0.7, 1.2)
                                             : 0.05},
                                 {},
                                 {},
                                 row == 0 ? 0.6F : 1.0F});
        }
    builder.grid(rows);
    for (int i = 0; i + 2 < kSides; ++i)
        builder.triangle(rows[2][0], rows[2][static_cast<std::size_t>(i) + 1],
                         rows[2][static_cast<std::size_t>(i) + 2]);
    return builder.finish(25.0);
}

models::Model twigs(const glm::vec3& brown)
{
    ModelBuilder builder;
    Dice dice(14);
    builder.begin("litter", {}, brown);
    for (int i = 0; i < 12; ++i)
    {
        const bool isTwig = i < 3;
        builder.tint(brown * static_cast<float>(dice.between(0.7, 1.25)));
        const glm::dvec3 foot(dice.between(-0.15, 0.15), dice.between(-0.15, 0.15), 0.004);
        addBlade(builder, foot,
                 {dice.between(0.0, kFull), isTwig ? dice.between(0.15, 0.3) : dice.between(0.05, 0.08),
                  isTwig ? 0.008 : dice.between(0.03, 0.045), isTwig ? 0.985 : dice.between(0.85, 0.97)});
    }
    return builder.finish();
}

} // namespace

std::array<osg::ref_ptr<const osgPMObjects::ProgressiveShape>, kCoverShapes>
coverModels(const osgTerrainROAM::TerrainMaterial& material)
{
    const glm::vec3 green = shown(material, "terrainMeadow", 0.82F),
                    pale = shown(material, "terrainDryGrass", 0.42F);
    const std::array<models::Model, kCoverShapes> made{tuft(green, pale), herb(green * 0.9F),
                                                       stone(shown(material, "terrainRock", 1.1F)),
                                                       twigs({0.31F, 0.27F, 0.20F})};
    const osg::ref_ptr<osg::Group> carrier =
        new osg::Group; // a field has a program of its own, which these states replace
    setObjectShading(*carrier, Finish::blades);
    std::array<osg::ref_ptr<const osgPMObjects::ProgressiveShape>, kCoverShapes> shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        shapes[i] = new osgPMObjects::ProgressiveShape(
            progressiveOf(made[i].mesh), std::vector<osg::ref_ptr<osg::StateSet>>{carrier->getStateSet()});
    return shapes;
}

} // namespace scenery
