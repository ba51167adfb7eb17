// SPDX-License-Identifier: Apache-2.0
// Every shader program of the tree is valid GLSL, whatever it is composed of.
#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "Compositions.h"
#include "Glslang.h"
#include "ShaderFiles.h"

namespace
{

using namespace shadercheck;

std::vector<NamedProgram> smallPrograms()
{
    std::vector<NamedProgram> programs = layerPrograms();
    std::ranges::copy(objectPrograms(), std::back_inserter(programs));
#ifdef OSGTRAINER_BENCHMARKS
    std::ranges::copy(benchPrograms(), std::back_inserter(programs));
#endif
    return programs;
}

const std::vector<Composition>& compositions()
{
    static const std::vector<Composition> all = []
    {
        std::vector<NamedProgram> programs = terrainPrograms();
        std::ranges::copy(smallPrograms(), std::back_inserter(programs));
        return compositionsOf(programs);
    }();
    return all;
}

TEST(ShaderSyntax, EveryCompositionCompiles)
{
    const auto pieces = shaderPieces(OSGTRAINER_SOURCE_DIR);
    std::set<std::string> reported; // a fault of a part shows in many compositions
    for (const Fault& fault : compileAll(compositions()))
    {
        ASSERT_TRUE(fault.composition) << fault.message;
        const std::string origin = originOf(fault.composition->text, fault.line, pieces);
        if (reported.insert(origin + fault.message).second)
            ADD_FAILURE() << origin << ": " << fault.message << " (" << fault.composition->name << ", "
                          << fault.composition->stage << ")";
    }
    EXPECT_GT(compositions().size(), 300u); // a check of nothing always passes
    RecordProperty("compositions", std::to_string(compositions().size()));
}

TEST(ShaderSyntax, StagesOfEveryProgramFitTogether)
{
    std::vector<NamedProgram> programs = terrainExtremes();
    std::ranges::copy(smallPrograms(), std::back_inserter(programs));
    for (const NamedProgram& named : programs)
        for (const auto& stages : variantsOf(named))
        {
            ASSERT_EQ(stages.size(), 2u) << named.name;
            for (const Fault& fault : linkProgram(stages))
                ADD_FAILURE() << stages.front().name << ": " << fault.message;
        }
}

TEST(ShaderSyntax, AVergeReadsNoMoreSamplersThanOpenGlGuarantees)
{
    // 16 in OpenGL 3.3 (table 6.51), two of which are for edits of the ground, which this terrain has none
    // of.
    int most = 0;
    for (const NamedProgram& named : objectPrograms())
        if (named.name.starts_with("verge"))
            for (const auto& stages : variantsOf(named))
                most = std::max(most, samplersOf(stages));
    EXPECT_LE(most, 14);
    EXPECT_GE(most, 10) << "some have to be found";
}

TEST(ShaderSyntax, EveryShaderFileStandsInAComposition)
{
    const auto pieces = shaderPieces(OSGTRAINER_SOURCE_DIR);
    EXPECT_FALSE(pieces.empty());
    for (const ShaderPiece& piece : pieces)
    {
#ifndef OSGTRAINER_BENCHMARKS
        if (piece.file.starts_with("bench/")) continue;
#endif
        EXPECT_TRUE(std::ranges::any_of(compositions(), [&](const Composition& composition)
                                        { return composition.text.find(piece.text) != std::string::npos; }))
            << piece.file << ":" << piece.firstLine
            << ": no program has this part, or the build is older than it";
    }
}

TEST(ShaderSyntax, EveryMarkerIsReplaced)
{
    for (const Composition& composition : compositions())
        EXPECT_EQ(composition.text.find("// <"), std::string::npos) << composition.name;
}

} // namespace
