// SPDX-License-Identifier: Apache-2.0
// What blocks of terrain ask of simplify(): positions that stay, and faces that do not turn over in plan.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

constexpr std::uint32_t kSide = 24;

/// A rough height field, steep enough that faces can turn over in plan and not in space.
Mesh roughGround()
{
    Mesh mesh = testsupport::meshOf({}, {});
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    {
        const double x = i % kSide, y = i / kSide;
        mesh.positions.emplace_back(
            x, y, 6.0 * std::sin(1.3 * x) * std::cos(0.9 * y) + 4.0 * std::sin(2.9 * x + y));
        mesh.wedgePositions.push_back(i);
    }
    for (std::uint32_t row = 0; row + 1 < kSide; ++row)
        for (std::uint32_t column = 0; column + 1 < kSide; ++column)
        {
            const std::uint32_t sw = row * kSide + column;
            mesh.faces.push_back({{sw, sw + 1, sw + kSide + 1}, 0, 0});
            mesh.faces.push_back({{sw, sw + kSide + 1, sw + kSide}, 0, 0});
        }
    return mesh;
}

std::vector<bool> borderOf(const Mesh& mesh)
{
    std::vector<bool> border;
    for (const glm::dvec3& p : mesh.positions)
        border.push_back(p.x == 0.0 || p.y == 0.0 || p.x == kSide - 1.0 || p.y == kSide - 1.0);
    return border;
}

std::size_t turnedOverCount(const Mesh& mesh)
{
    return static_cast<std::size_t>(std::count_if(
        mesh.faces.begin(), mesh.faces.end(),
        [&](const Face& face)
        {
            const glm::dvec3 a = mesh.at(face, 1) - mesh.at(face, 0), b = mesh.at(face, 2) - mesh.at(face, 0);
            return a.x * b.y - a.y * b.x <= 0.0;
        }));
}

CollapseSequence simplified(const Mesh& mesh, bool locks, bool isHeightField)
{
    SimplifySettings settings;
    settings.keepSymmetry = settings.growLeaves = false;
    settings.isHeightField = isHeightField;
    if (locks) settings.locked = borderOf(mesh);
    return simplify(mesh, settings);
}

TEST(SimplifyHeightField, LockedPositionsStay)
{
    const Mesh mesh = roughGround();
    const std::vector<bool> border = borderOf(mesh);
    const auto removesBorder = [&](const CollapseSequence& sequence)
    {
        return std::any_of(sequence.steps.begin(), sequence.steps.end(),
                           [&](const CollapseStep& step) { return border[step.from]; });
    };
    const CollapseSequence locked = simplified(mesh, true, true);
    EXPECT_TRUE(isSequenceOf(locked, mesh));
    EXPECT_FALSE(removesBorder(locked));
    EXPECT_GT(locked.steps.size(), (kSide - 2) * (kSide - 2) * 3 / 4);
    EXPECT_TRUE(removesBorder(simplified(mesh, false, true))) << "the border is never simplified anyway";
}

TEST(SimplifyHeightField, FacesKeepTheirUpperSideUp)
{
    const Mesh mesh = roughGround();
    const std::size_t half = mesh.faces.size() / 2;
    const auto turned = [&](bool isHeightField)
    {
        const CollapseSequence sequence = simplified(mesh, true, isHeightField);
        return turnedOverCount(meshAfter(mesh, sequence, stepsToFaces(sequence, half)));
    };
    EXPECT_EQ(turned(true), 0u);
    EXPECT_GT(turned(false), 0u) << "no face turns over anyway";
}

/// By position: a bit for each side of the field.
std::vector<std::uint8_t> sidesOf(const Mesh& mesh)
{
    constexpr double kLast = kSide - 1.0;
    std::vector<std::uint8_t> sides;
    for (const glm::dvec3& p : mesh.positions)
        sides.push_back(static_cast<std::uint8_t>((p.y == 0.0) | (p.x == kLast) << 1 | (p.y == kLast) << 2 |
                                                  (p.x == 0.0) << 3));
    return sides;
}

/// Twice the area in plan; the whole field has 2 (kSide - 1)² of it, where no face lies over another.
double doubleAreaInPlan(const Mesh& mesh)
{
    double sum = 0.0;
    for (const Face& face : mesh.faces)
    {
        const glm::dvec3 a = mesh.at(face, 1) - mesh.at(face, 0), b = mesh.at(face, 2) - mesh.at(face, 0);
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

TEST(SimplifyHeightField, AnOutlineOfLinesKeepsItsShapeDownToTwoFaces)
{
    const Mesh mesh = roughGround();
    const double whole = 2.0 * (kSide - 1) * (kSide - 1);
    SimplifySettings settings;
    settings.keepSymmetry = settings.growLeaves = false;
    settings.isHeightField = true;
    const CollapseSequence free = simplify(mesh, settings);
    settings.lines = sidesOf(mesh);
    const CollapseSequence kept = simplify(mesh, settings);
    EXPECT_TRUE(isSequenceOf(kept, mesh));
    for (const std::size_t faces : {400, 100, 30, 8, 2})
    {
        const Mesh level = meshAfter(mesh, kept, stepsToFaces(kept, faces));
        EXPECT_EQ(turnedOverCount(level), 0u) << faces;
        EXPECT_NEAR(doubleAreaInPlan(level), whole, 1e-6) << faces;
    }
    EXPECT_LT(doubleAreaInPlan(meshAfter(mesh, free, stepsToFaces(free, 8))), 0.99 * whole)
        << "the outline is kept anyway";
}

} // namespace
