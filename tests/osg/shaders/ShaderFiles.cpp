// SPDX-License-Identifier: Apache-2.0
#include "ShaderFiles.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "TestFolder.h"

namespace shadercheck
{

namespace
{

bool isMarker(const std::string& line)
{
    const std::size_t begin = line.find_first_not_of(' ');
    return begin != std::string::npos && line.compare(begin, 4, "// <") == 0 && line.back() == '>';
}

void addPieces(const std::string& file, const std::string& text, std::vector<ShaderPiece>& pieces)
{
    std::istringstream lines(text);
    bool isHead = true, isNew = true;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
    {
        if (isHead)
            isHead = !line.empty();
        else if (isMarker(line))
            isNew = true;
        else
        {
            if (isNew) pieces.push_back({file, number, ""});
            isNew = false;
            pieces.back().text += line + "\n";
        }
    }
}

} // namespace

std::vector<ShaderPiece> shaderPieces(const std::filesystem::path& root)
{
    static const std::set<std::string> kExtensions = {".vert", ".frag", ".glsl"};
    std::vector<ShaderPiece> pieces;
    for (const char* folder : {"apps", "bench", "osgMultiTriangulation", "osgOffscreen", "osgPMObjects",
                               "osgTerrainROAM", "scenery"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
            if (kExtensions.contains(entry.path().extension().string()) &&
                entry.path().parent_path().filename() == "shaders")
                addPieces(std::filesystem::relative(entry.path(), root).string(),
                          testsupport::bytesOf(entry.path()), pieces);
    return pieces;
}

std::string originOf(const std::string& composition, int line, const std::vector<ShaderPiece>& pieces)
{
    std::size_t begin = 0;
    for (int i = 1; i < line && begin != std::string::npos; ++i)
        begin =
            composition.find('\n', begin) == std::string::npos ? begin : composition.find('\n', begin) + 1;
    const ShaderPiece* best = nullptr;
    std::size_t bestAt = 0;
    for (const ShaderPiece& piece : pieces)
    {
        const std::size_t at = composition.find(piece.text);
        if (at == std::string::npos || begin < at || begin >= at + piece.text.size()) continue;
        if (best && best->text.size() >= piece.text.size()) continue;
        best = &piece;
        bestAt = at;
    }
    if (!best) return "generated line: " + composition.substr(begin, composition.find('\n', begin) - begin);
    const auto passed = std::count(composition.begin() + static_cast<std::ptrdiff_t>(bestAt),
                                   composition.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    return best->file + ":" + std::to_string(best->firstLine + passed);
}

} // namespace shadercheck
