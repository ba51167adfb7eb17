// SPDX-License-Identifier: Apache-2.0
// The syntax check fails on faulty shaders, and names the file and the line.
#include <algorithm>

#include <gtest/gtest.h>

#include "Compositions.h"
#include "Glslang.h"
#include "ShaderFiles.h"

namespace
{

using namespace shadercheck;

/// A fault seeded in a shader file and, as after a build, in the compositions with it.
struct Seeded
{
    std::vector<ShaderPiece> pieces = shaderPieces(OSGTRAINER_SOURCE_DIR);
    std::vector<Composition> compositions;

    Seeded(const std::vector<NamedProgram>& programs, const std::string& file, const std::string& from,
           const std::string& to)
        : compositions(compositionsOf(programs))
    {
        bool isSeeded = false;
        for (ShaderPiece& piece : pieces)
        {
            const std::size_t at = piece.text.find(from);
            if (piece.file != file || at == std::string::npos) continue;
            const std::string before = piece.text;
            piece.text.replace(at, from.size(), to);
            for (Composition& composition : compositions)
                if (const std::size_t begin = composition.text.find(before); begin != std::string::npos)
                    composition.text.replace(begin, before.size(), piece.text);
            isSeeded = true;
        }
        EXPECT_TRUE(isSeeded) << file << " has no '" << from << "'";
    }

    /// Where the first fault is.
    std::string origin() const
    {
        const auto faults = compileAll(compositions);
        return faults.empty() ? "no fault"
                              : originOf(faults.front().composition->text, faults.front().line, pieces);
    }
};

/// "file:line" of the first line of a shader file with a text.
std::string lineOf(const std::string& file, const std::string& text)
{
    for (const ShaderPiece& piece : shaderPieces(OSGTRAINER_SOURCE_DIR))
        if (const std::size_t at = piece.text.find(text); piece.file == file && at != std::string::npos)
            return file + ":" +
                   std::to_string(piece.firstLine + std::count(piece.text.begin(),
                                                               piece.text.begin() + static_cast<long>(at),
                                                               '\n'));
    return "not found";
}

TEST(ShaderMutation, AnUnknownNameIsFound)
{
    const std::string file = "osgTerrainROAM/src/shaders/Grain.glsl", from = "return b * roughness";
    EXPECT_EQ(Seeded(terrainExtremes(), file, from, "return b * smoothness").origin(), lineOf(file, from));
}

TEST(ShaderMutation, AFaultBehindADefineIsFound)
{
    const std::string file = "osgPMObjects/src/shaders/ObjectVertexFunctions.glsl",
                      from = "mix(pmLeafScale.x, pmLeafScale.y, pmShown.z)";
    EXPECT_EQ(Seeded(objectPrograms(), file, from, "mix(pmLeafScale.x, pmLeafScale, pmShown.z)").origin(),
              lineOf(file, from));
}

TEST(ShaderMutation, AFaultBehindAGeneratedPartIsFound)
{
    const std::string file = "osgTerrainROAM/src/shaders/LayerMain.glsl",
                      from = "gl_FragColor = vec4(fogged(";
    EXPECT_EQ(Seeded(layerPrograms(), file, from, "gl_FragColor = vec3(fogged(").origin(),
              lineOf(file, from));
}

TEST(ShaderMutation, AFaultOfAGeneratedLineIsQuoted)
{
    const std::string file = "osgTerrainROAM/src/shaders/Imagery.glsl", from = "void addLayer(";
    EXPECT_EQ(Seeded(terrainExtremes(), file, from, "void addLayers(").origin().substr(0, 38),
              "generated line:     addLayer(imagery, ");
}

TEST(ShaderMutation, StagesThatDoNotFitAreFound)
{
    auto stages = variantsOf(terrainExtremes().front()).front();
    EXPECT_TRUE(linkProgram(stages).empty());
    std::string& fragment = stages.back().text;
    const std::string declaration = "in vec2 grid;";
    ASSERT_NE(fragment.find(declaration), std::string::npos);
    fragment.replace(fragment.find(declaration), declaration.size(),
                     "in vec3 grids; const vec2 grid = vec2(0.0);");
    EXPECT_TRUE(linkProgram(stages).empty()) << "an input that no code reads does no harm";
    fragment.replace(fragment.find("in vec3 fromEye;"), 16, "in vec4 from4; const vec3 fromEye = from4.xyz;");
    EXPECT_FALSE(linkProgram(stages).empty());
}

} // namespace
