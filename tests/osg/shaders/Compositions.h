// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osg/Program>

/// The shader programs that the libraries, the benchmarks and the tests draw with, without a graphics
/// context.
namespace shadercheck
{

/// A program under a name for messages.
struct NamedProgram
{
    std::string name;
    osg::ref_ptr<const osg::Program> program;
};

/// All combinations of what a terrain may have.
std::vector<NamedProgram> terrainPrograms();
/// The terrain's program with nothing, with one thing each, and with everything: enough to check how stages
/// fit together.
std::vector<NamedProgram> terrainExtremes();
/// The kinds and units of colour layers on tiles of osgTerrain, with and without holes.
std::vector<NamedProgram> layerPrograms();
/// Progressive and baked objects, objects and sky under the atmosphere, the tests' small scene.
std::vector<NamedProgram> objectPrograms();
/// The programs that only benchmarks draw with (built with OSGTRAINER_BENCHMARKS).
std::vector<NamedProgram> benchPrograms();

/// One shader as the driver gets it.
struct Composition
{
    std::string name;  ///< of the program, with the defines
    std::string stage; ///< the extension that glslangValidator wants: "vert" or "frag"
    std::string text;
};

/// The shaders of a program, one program for each combination of the defines that "#pragma import_defines" of
/// any of them names. osg::Shader puts such defines behind the #version line; so does this.
std::vector<std::vector<Composition>> variantsOf(const NamedProgram& named);

/// The variants of all programs, each text once.
std::vector<Composition> compositionsOf(const std::vector<NamedProgram>& programs);

} // namespace shadercheck
