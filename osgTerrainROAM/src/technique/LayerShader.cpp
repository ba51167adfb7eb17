// SPDX-License-Identifier: Apache-2.0
#include "LayerShader.h"

#include "../material/TerrainShader.h"

namespace osgTerrainROAM
{

namespace
{

const char* const kHead = R"(
in vec3 fromEye;
in vec2 grid;
uniform mat3 terrainEyeFromLocal;
uniform vec2 terrainLastSample;
uniform sampler2D terrainSurface;
uniform vec4 terrainSurfaceFromGrid;
uniform vec2 terrainLayerHeights;
uniform vec4 terrainLayerS[8];
uniform vec4 terrainLayerT[8];
uniform int terrainLights; // a bit for each that is on; below 0: no lighting
uniform int terrainLightCount; // up to the last that is on, at least 1
uniform vec4 terrainFog;       // FixedFunction.h
)";

// OpenGL 2.1, 2.14.1, without local viewer and separate specular colour. A software renderer does all that a branch may
// need: so the loop has as many turns as there are lights, and no more.
const char* const kLight = R"(
vec4 lit(vec3 normal, vec3 place)
{
    vec3 colour = gl_FrontLightModelProduct.sceneColor.rgb;
    int i = 0;
    do
    {
        vec4 position = gl_LightSource[i].position;
        vec3 way = position.w == 0.0 ? position.xyz : position.xyz / position.w - place;
        float far = length(way);
        vec3 towards = way / max(far, 1e-20);
        float strength = (terrainLights & (1 << i)) != 0 ? 1.0 : 0.0;
        if (position.w != 0.0)
        {
            strength /= gl_LightSource[i].constantAttenuation
                + far * (gl_LightSource[i].linearAttenuation + far * gl_LightSource[i].quadraticAttenuation);
            float spot = dot(-towards, normalize(gl_LightSource[i].spotDirection));
            if (gl_LightSource[i].spotCosCutoff > -1.0)
                strength *= spot < gl_LightSource[i].spotCosCutoff ? 0.0 : pow(spot, gl_LightSource[i].spotExponent);
        }
        float facing = max(dot(normal, towards), 0.0);
        vec3 sum = gl_FrontLightProduct[i].ambient.rgb + facing * gl_FrontLightProduct[i].diffuse.rgb;
        float gloss = max(dot(normal, normalize(towards + vec3(0.0, 0.0, 1.0))), 0.0);
        if (facing > 0.0 && gloss > 0.0)
            sum += pow(gloss, gl_FrontMaterial.shininess) * gl_FrontLightProduct[i].specular.rgb;
        colour += strength * sum;
    } while (++i < terrainLightCount);
    vec4 all = clamp(vec4(colour, gl_FrontMaterial.diffuse.a), 0.0, 1.0);
    return terrainLights < 0 ? vec4(1.0) : all;
}

vec3 fogged(vec3 colour, float depth)
{
    float clear = clamp(terrainFog.x + terrainFog.y * depth, 0.0, 1.0)
        * exp2(-depth * (terrainFog.z + terrainFog.w * depth));
    return mix(gl_Fog.color.rgb, colour, clear);
}
)";

const char* const kHoles = R"(
uniform sampler2D terrainHoles;

// The code of a cell: SurfaceMap.h.
bool isHole()
{
    vec2 cells = vec2(textureSize(terrainHoles, 0));
    vec2 cell = clamp(floor(grid), vec2(0.0), cells - 1.0);
    int code = int(texelFetch(terrainHoles, ivec2(cell), 0).r * 255.0 + 0.5);
    vec2 at = grid - cell;
    if (code == 1) return at.x + at.y < 1.0;
    if (code == 2) return at.x > at.y;
    if (code == 3) return at.x < at.y;
    if (code == 4) return at.x + at.y > 1.0;
    return code == 0;
}
)";

const char* const kMainBegins = R"(
// A slope seen edge-on is much longer than wide in the map. A level chosen for the length gives it the mean normal of its
// surroundings, a bright dot in the shade: so the level is that of twice the width.
vec4 surfaceAt(vec2 at)
{
    vec2 alongX = dFdx(at);
    vec2 alongY = dFdy(at);
    float length2 = max(dot(alongX, alongX), dot(alongY, alongY));
    float area = abs(alongX.x * alongY.y - alongX.y * alongY.x);
    return texture(terrainSurface, at, -clamp(log2(length2 / max(area, 1e-20)) - 1.0, 0.0, 6.0));
}

void main()
{
    vec4 surface = surfaceAt(grid * terrainSurfaceFromGrid.xy + terrainSurfaceFromGrid.zw);
    vec3 place = terrainEyeFromLocal * fromEye;
    vec2 uv = grid / terrainLastSample;
    vec4 weights = vec4(1.0, uv, uv.x * uv.y);
    vec4 colour = lit(normalize(terrainEyeFromLocal * (surface.xyz * 2.0 - 1.0)), place);
)";

const char* const kMainEnds = R"(
    gl_FragColor = vec4(fogged(colour.rgb, -place.z), colour.a);
}
)";

std::string samplerOf(const ColourLayer& layer)
{
    return std::string("uniform ") + (layer.kind == LayerKind::contour ? "sampler1D" : "sampler2D") +
           " terrainLayer" + std::to_string(layer.unit) + ";\n";
}

std::string lookUpOf(const ColourLayer& layer)
{
    const std::string n = std::to_string(layer.unit);
    const std::string s = "terrainLayerS[" + n + "]", t = "terrainLayerT[" + n + "]";
    if (layer.kind == LayerKind::contour)
        return "    colour *= texture(terrainLayer" + n + ", " + s + ".x + " + s +
               ".y * (terrainLayerHeights.x + terrainLayerHeights.y * surface.a));\n";
    return std::string("    colour") + (layer.kind == LayerKind::alpha ? ".a" : "") +
           " *= texture(terrainLayer" + n + ", vec2(dot(" + s + ", weights), dot(" + t + ", weights)))" +
           (layer.kind == LayerKind::alpha ? ".a" : "") + ";\n";
}

std::string fragmentShader(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    std::string samplers, lookUps;
    for (const ColourLayer& layer : layers)
    {
        samplers += samplerOf(layer);
        lookUps += lookUpOf(layer);
    }
    std::string text = std::string("#version 330 compatibility\n") + kHead + samplers + kLight;
    if (hasHoles) text += kHoles;
    text += kMainBegins + lookUps;
    if (hasHoles) text += "    if (isHole()) discard;\n"; // last: mip levels come from neighbours
    return text + kMainEnds;
}

std::string keyOf(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    std::string key = hasHoles ? "h" : "";
    for (const ColourLayer& layer : layers)
        key += std::to_string(layer.unit) + static_cast<char>(layer.kind);
    return key;
}

} // namespace

osg::ref_ptr<osg::Program> LayerPrograms::program(const std::vector<ColourLayer>& layers, bool hasHoles)
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::Program>& program = _programs[keyOf(layers, hasHoles)];
    if (!program)
    {
        program = new osg::Program;
        program->setName("terrain layers " + keyOf(layers, hasHoles));
        program->addShader(terrainVertexShader());
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragmentShader(layers, hasHoles)));
    }
    return program;
}

} // namespace osgTerrainROAM
