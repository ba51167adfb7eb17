// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "Compositions.h"

namespace shadercheck
{

/// A complaint of glslangValidator (Debian package glslang-tools), the Khronos reference compiler.
struct Fault
{
    const Composition* composition = nullptr; ///< null: the stages of a program do not fit together
    int line = 0;
    std::string message;
};

/// Compiles each composition by itself.
/// Throws std::runtime_error where the validator is missing or does not run to its end.
std::vector<Fault> compileAll(const std::vector<Composition>& compositions);

/// Compiles the stages of one program and links them. Throws as compileAll().
std::vector<Fault> linkProgram(const std::vector<Composition>& stages);

/// Counts the samplers that the linked stages of one program read. Throws as compileAll().
int samplersOf(const std::vector<Composition>& stages);

} // namespace shadercheck
