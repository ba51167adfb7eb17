// SPDX-License-Identifier: Apache-2.0
#include "RepeatedLayers.h"

#include <cassert>

#include <shaders/osgTerrainROAM.h>

namespace osgTerrainROAM
{

std::string withLines(std::string text, const std::string& marker, const std::string& lines)
{
    const std::string line = "// <" + marker + ">\n";
    const std::size_t at = text.find(line);
    assert(at != std::string::npos && "the shader's text has no such marker");
    if (at == std::string::npos) return text;
    const std::size_t begin = text.rfind('\n', at) + 1; // 0 in the first line
    return text.replace(begin, at + line.size() - begin, lines);
}

std::string imageryText(int layers)
{
    std::string uniforms = "uniform vec4 imageryFromGrid[" + std::to_string(layers) + "];\n", calls;
    for (int i = 0; i < layers; ++i)
    {
        const std::string n = std::to_string(i);
        uniforms += "uniform sampler2D imageryLayer" + n + ";\n";
        calls += "    addLayer(imagery, imageryLayer" + n + ", grid * imageryFromGrid[" + n +
                 "].xy + imageryFromGrid[" + n + "].zw);\n";
    }
    return withLines(withLines(shaders::kImagery, "uniforms", uniforms), "layers", calls);
}

std::string sheetNormalsText(int maps)
{
    const std::string count = std::to_string(maps);
    std::string uniforms = "uniform vec4 sheetFromGrid[" + count + "];\nuniform vec4 sheetRect[" + count +
                           "];\nuniform vec4 sheetBumpiness[" + count + "];\nuniform float sheetCell;\n",
                calls;
    for (int i = 0; i < maps; ++i)
    {
        const std::string n = std::to_string(i);
        uniforms += "uniform sampler2D sheetNormals" + n + ";\n";
        calls += "    addSheet(tilt, bumpiness, sheetNormals" + n + ", sheetFromGrid[" + n + "], sheetRect[" +
                 n + "], sheetBumpiness[" + n + "]);\n";
    }
    return withLines(withLines(shaders::kSheetNormals, "uniforms", uniforms), "sheets", calls);
}

} // namespace osgTerrainROAM
