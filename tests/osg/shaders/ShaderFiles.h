// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace shadercheck
{

/// A piece of a shader file that stands in compositions without a change: the text below the head, cut at the
/// lines "// <marker>", which programs replace.
struct ShaderPiece
{
    std::string file; ///< relative to the root of the tree
    int firstLine = 1;
    std::string text;
};

/// The pieces of the shader files in the folders `shaders` of the tree.
std::vector<ShaderPiece> shaderPieces(const std::filesystem::path& root);

/// Where a line (counted from 1) of a composition comes from: "file:line", or "generated line: text".
std::string originOf(const std::string& composition, int line, const std::vector<ShaderPiece>& pieces);

} // namespace shadercheck
