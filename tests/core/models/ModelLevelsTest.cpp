// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "scenery/models/Catalogue.h"

namespace core = osgPMObjects::core;
using namespace scenery::models;

namespace
{

/// Returns why a sequence does not give valid levels of 25, 10 and 1 % of a mesh; empty if it does.
std::string defectOfLevels(const core::Mesh& mesh, const core::CollapseSequence& sequence)
{
    if (!core::isSequenceOf(sequence, mesh)) return "it is no sequence of the mesh";
    for (const int percent : {25, 10, 1})
    {
        const std::size_t wanted = mesh.faces.size() * static_cast<std::size_t>(percent) / 100;
        const core::Mesh level = core::meshAfter(mesh, sequence, core::stepsToFaces(sequence, wanted));
        const std::string name = std::to_string(percent) + " %";
        if (!core::isValid(level)) return name + ": " + core::defectOf(level);
        if (level.faces.size() > wanted) return name + ": too many faces";
        if (level.faces.size() < wanted / 2) return name + ": too few faces";
        if (core::diagonalOf(level) < 0.5 * core::diagonalOf(mesh)) return name + ": half of it is gone";
    }
    return {};
}

} // namespace

TEST(ModelLevels, EveryKindGoesDownToOnePercent)
{
    for (const KindFacts& facts : kinds())
    {
        const Model model = generate(facts.kind, 3);
        EXPECT_EQ(defectOfLevels(model.mesh, core::simplify(model.mesh)), "") << facts.name;
    }
}

TEST(ModelLevels, ASequenceThatEndsEarlyDoesNot)
{
    const Model model = generate(Kind::barn, 3);
    core::CollapseSequence sequence = core::simplify(model.mesh);
    sequence.steps.resize(sequence.steps.size() / 2);
    sequence.wedges.resize(sequence.steps.back().firstWedge);
    sequence.steps.pop_back();
    EXPECT_NE(defectOfLevels(model.mesh, sequence), "");
}
