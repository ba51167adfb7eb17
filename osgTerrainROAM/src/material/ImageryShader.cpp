// SPDX-License-Identifier: Apache-2.0
#include "ImageryShader.h"

namespace osgTerrainROAM
{

std::string imageryGlsl(int layers)
{
    const std::string count = std::to_string(layers);
    std::string text = "uniform vec4 imageryFromGrid[" + count + "];\n";
    for (int i = 0; i < layers; ++i)
        text += "uniform sampler2D imageryLayer" + std::to_string(i) + ";\n";
    text += R"(
// Colours are mixed with their shares, or a border would be dark.
void addLayer(inout vec4 below, sampler2D layer, vec2 at)
{
    vec4 here = texture(layer, at); // for all pixels: its mip level follows from neighbours
    vec2 inward = smoothstep(vec2(0.0), vec2(0.02), 0.5 - abs(at - 0.5));
    float share = here.a * inward.x * inward.y;
    float all = share + below.a * (1.0 - share);
    below = vec4(mix(below.rgb, here.rgb, share / max(all, 1e-4)), all);
}

vec4 layeredImagery(vec2 grid)
{
    vec4 imagery = vec4(0.0);
)";
    for (int i = 0; i < layers; ++i)
    {
        const std::string n = std::to_string(i);
        text += "    addLayer(imagery, imageryLayer" + n + ", grid * imageryFromGrid[" + n +
                "].xy + imageryFromGrid[" + n + "].zw);\n";
    }
    return text + "    return imagery;\n}\n";
}

} // namespace osgTerrainROAM
