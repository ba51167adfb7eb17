// SPDX-License-Identifier: Apache-2.0
#include "TerrainShader.h"

#include <string>

#include <osgTerrainROAM/Atmosphere>

#include "CoverShader.h"
#include "FeatureShader.h"
#include "FineNormals.h"
#include "ImageryShader.h"
#include "SheetNormals.h"

namespace osgTerrainROAM
{

namespace
{

const char* kVertex = R"(#version 330 compatibility
layout(location = 0) in ivec3 position; // in steps
layout(location = 1) in vec2 gridBits; // the lower 16 of each coordinate
uniform ivec3 terrainEyeSteps;
uniform vec3 terrainEyeRest; // metres
uniform float terrainStep;
uniform mat3 terrainEyeFromLocal;
uniform mat3x2 terrainGridFromLocal; // about
uniform vec2 terrainLastSample;
out vec3 fromEye;
out vec2 grid;

void main()
{
    // A difference of whole numbers: it is exact at any distance from the origin.
    fromEye = vec3(position - terrainEyeSteps) * terrainStep - terrainEyeRest;
    vec2 near = terrainGridFromLocal * vec3(vec2(position.xy) * terrainStep, 1.0);
    grid = gridBits + 65536.0 * round((near - gridBits) * (1.0 / 65536.0));
    gl_Position = gl_ProjectionMatrix * vec4(terrainEyeFromLocal * fromEye, 1.0);
    gl_ClipDistance[0] = terrainLastSample.x - grid.x;
    gl_ClipDistance[1] = terrainLastSample.y - grid.y;
}
)";

const char* kFragmentHead = R"(
in vec3 fromEye;
in vec2 grid;
uniform sampler2D terrainNormals;
uniform sampler2D terrainLand;
uniform sampler2D terrainGrain;
uniform sampler2D terrainDrape;
uniform vec4 terrainMapFromGrid;
uniform vec4 terrainDrapeFromGrid;
uniform vec3 terrainEyeWrapped;
uniform mat3 terrainWorldFromLocal;
uniform vec4 terrainBumpiness;
uniform vec3 terrainRock;
uniform vec3 terrainSoil;
uniform vec3 terrainDryGrass;
uniform vec3 terrainMeadow;
uniform vec3 terrainForest;
uniform vec3 terrainSand;
uniform vec3 terrainSnow;
uniform vec3 terrainWater;
uniform float terrainStrata;
uniform float terrainShore; // where on the way from land (0) to water (1) the beach begins

struct Grain
{
    vec4 metres2; // period of about 2 m
    vec4 metres28;
    vec4 metres324;
    vec4 metres1831;
};

// On ground seen at a grazing angle a mip level chosen for the footprint's length blurs its width away. Four taps along
// the length, each at a level for the quarter of it: what an anisotropic filter does, where the renderer's own costs
// hundreds of times as much.
vec4 grazingGrain(vec2 at)
{
    vec2 alongX = dFdx(at);
    vec2 alongY = dFdy(at);
    float x2 = dot(alongX, alongX);
    float y2 = dot(alongY, alongY);
    vec2 length4 = (x2 > y2 ? alongX : alongY) * 0.25;
    float cross2 = abs(alongX.x * alongY.y - alongX.y * alongY.x);
    // log2 of length over width, by which the level may be finer.
    float finer = clamp(log2(max(x2, y2) / max(cross2, 1e-20)), 0.0, 2.0);
    vec4 sum = texture(terrainGrain, at - 1.5 * length4, -finer) + texture(terrainGrain, at - 0.5 * length4, -finer);
    sum += texture(terrainGrain, at + 0.5 * length4, -finer) + texture(terrainGrain, at + 1.5 * length4, -finer);
    return 0.25 * sum - 0.5;
}

// Periods divide the 4096 m that the eye's place is wrapped by; the layers are turned against each other by
// integer matrices, so that they wrap as well and their repetitions do not line up.
Grain grainAt(vec2 place)
{
    Grain g;
    g.metres2 = grazingGrain(place * (1.0 / 2.0));
    g.metres28 = grazingGrain(vec2(2.0 * place.x + place.y, 2.0 * place.y - place.x) * (1.0 / 64.0));
    g.metres324 = texture(terrainGrain, vec2(3.0 * place.x - place.y, 3.0 * place.y + place.x) * (1.0 / 1024.0)) - 0.5;
    g.metres1831 = texture(terrainGrain, vec2(place.x + 2.0 * place.y, place.y - 2.0 * place.x) * (1.0 / 4096.0)) - 0.5;
    return g;
}

// `bumpiness`: of each layer; `wood`: treetops, some metres across and as high.
vec2 bumps(Grain g, vec4 bumpiness, float roughness, float wood)
{
    vec2 b = g.metres2.xy * bumpiness.x + g.metres28.xy * (bumpiness.y + 0.5 * wood);
    b += g.metres324.xy * bumpiness.z + g.metres1831.xy * bumpiness.w;
    return b * roughness;
}
)";

const char* kFragmentLand = R"(
// Colour of dry land without snow, and in alpha the share of wood.
vec4 groundColour(float green, float steep, float heightM, Grain g)
{
    green += 0.50 * g.metres324.w + 0.36 * g.metres28.w + 0.60 * g.metres1831.w + 0.20 * g.metres2.w;
    vec3 colour = mix(terrainSoil, terrainDryGrass, smoothstep(0.22, 0.42, green));
    colour = mix(colour, terrainMeadow, smoothstep(0.45, 0.62, green));
    float wood = smoothstep(0.68, 0.80, green + 0.10 * g.metres28.z);
    colour = mix(colour, terrainForest, wood);

    float bare = steep + 0.30 * g.metres28.w + 0.24 * g.metres324.w + 0.16 * (0.35 - green);
    float rock = smoothstep(0.22, 0.34, bare) * (1.0 - 0.55 * wood);
    // Beds of rock: bands over the height, bent by the noise.
    float bed = heightM * 0.045 + 2.2 * g.metres324.w + 0.8 * g.metres28.w;
    vec3 rockColour = terrainRock * (1.0 + terrainStrata * (0.6 * sin(bed) + 0.4 * sin(bed * 2.7 + 1.3)));
    colour = mix(colour, rockColour, rock);

    float speckle = 1.1 * g.metres2.z + 0.65 * g.metres28.z + 0.45 * g.metres324.z + 0.35 * g.metres1831.z;
    return vec4(colour * max(1.0 + speckle * (1.0 + 0.7 * wood), 0.25), wood * (1.0 - rock));
}

vec3 waterColour(vec3 directionWorld, Grain g)
{
    // Ripples small enough to leave the sky's reflection in one piece; they fade with the grain's mip levels.
    vec3 normal = normalize(vec3(0.10 * g.metres2.xy + 0.05 * g.metres28.xy, 1.0));
    vec3 mirrored = reflect(directionWorld, normal);
    mirrored.z = abs(mirrored.z);
    float facing = clamp(-dot(directionWorld, normal), 0.0, 1.0);
    float away = 1.0 - facing;
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away;
    vec3 deep = terrainWater * (sunLight() * max(sunDirection().z, 0.0) + ambientLight(vec3(0.0, 0.0, 1.0)));
    return mix(deep, skyColour(normalize(mirrored)), fresnel * 0.85);
}
)";

const char* kFragmentMain = R"(
void main()
{
    float distanceM = length(fromEye);
    vec3 directionWorld = terrainWorldFromLocal * (fromEye / distanceM);
    vec2 mapPlace = grid * terrainMapFromGrid.xy + terrainMapFromGrid.zw;
    vec2 tilt = texture(terrainNormals, mapPlace).rg * 2.0 - 1.0;
    vec4 bumpiness = terrainBumpiness;
#ifdef TERRAIN_SHEETS
    sheetTilt(tilt, bumpiness);
#endif
#ifdef TERRAIN_FINE
    tilt = fineTilt(tilt);
#endif
    vec4 land = texture(terrainLand, mapPlace);
    vec3 place = fromEye + terrainEyeWrapped;
    Grain g = grainAt(place.xy);

    float steep = 1.0 - sqrt(max(1.0 - dot(tilt, tilt), 0.0));
#ifdef TERRAIN_SEASON
    land.g = seasonSnow(land.g, place, steep, g);
#endif
    float snow = smoothstep(0.38, 0.62, land.g + 0.30 * g.metres324.w + 0.22 * g.metres28.w + 0.25 * g.metres1831.w
                                            - 0.9 * max(steep - 0.25, 0.0));
    float roughness = mix(1.0 + 1.5 * smoothstep(0.12, 0.35, steep), 0.35, snow);
    vec4 ground = groundColour(land.r, steep, place.z, g);
#ifdef TERRAIN_COVER
    Cover cover = terrainCover(grid, g);
    ground = coveredGround(ground, cover, g);
    snow = max(snow, smoothstep(0.35, 0.65, cover.snow));
#endif
#ifdef TERRAIN_SEASON
    // It lies between the trees.
    snow *= 1.0 - ground.a * clamp(0.5 + 2.2 * g.metres28.z + 1.6 * g.metres2.z, 0.0, 1.0);
#endif
#ifdef TERRAIN_FEATURES
    Paint paint = terrainPaint(place.xy, dFdx(fromEye.xy), dFdy(fromEye.xy));
    ground = fieldAlbedo(ground, paint, g);
    ground.a *= openShare(paint);
    roughness *= 0.25 + 0.75 * openShare(paint);
#endif
    vec2 bent = tilt - bumps(g, bumpiness, roughness, ground.a * (1.0 - snow));
    vec3 normal = normalize(vec3(bent, sqrt(max(1.0 - dot(tilt, tilt), 0.02))));

    vec3 albedo = ground.rgb;
    float shore = smoothstep(terrainShore, terrainShore + 0.08, land.b + 0.12 * g.metres28.w + 0.12 * g.metres324.w)
                * (1.0 - smoothstep(0.01, 0.05, steep));
    albedo = mix(albedo, terrainSand * (1.0 + 0.5 * g.metres2.z + 0.3 * g.metres28.z), shore);
    albedo = mix(albedo, terrainSnow * (1.0 + 0.10 * g.metres2.z + 0.06 * g.metres28.z), snow);
#if defined(TERRAIN_LAYERS)
    vec4 imagery = layeredImagery(grid);
#elif defined(TERRAIN_DRAPE)
    vec4 imagery = texture(terrainDrape, grid * terrainDrapeFromGrid.xy + terrainDrapeFromGrid.zw);
#endif
#if defined(TERRAIN_LAYERS) || defined(TERRAIN_DRAPE)
    float fine = 1.0 + 0.5 * g.metres2.z + 0.2 * g.metres28.z;
    albedo = mix(albedo, imagery.rgb * imagery.rgb * fine, imagery.a);
    float water = (1.0 - imagery.a) * smoothstep(0.47, 0.53, land.b);
#else
    float water = smoothstep(0.47, 0.53, land.b);
#endif
#ifdef TERRAIN_COVER
    water = max(water, smoothstep(0.35, 0.65, cover.water));
#endif
#ifdef TERRAIN_FEATURES
    albedo = pavedAlbedo(albedo, paint, g);
    water = max(water, paint.beds.x) * (1.0 - max(max(paint.beds.y, paint.beds.z), paint.beds.w));
#endif

    vec3 normalWorld = terrainWorldFromLocal * normal;
    float sunlit = max(dot(normalWorld, sunDirection()), 0.0) * smoothstep(0.15, 0.6, land.a);
    vec3 colour = albedo * (sunLight() * sunlit + ambientLight(normalWorld) * land.a);
    if (water > 0.0) colour = mix(colour, waterColour(directionWorld, g), water);
#ifdef TERRAIN_COVER
    colour += townLight(cover, place.xy, dFdx(fromEye.xy), dFdy(fromEye.xy));
#endif
#ifdef TERRAIN_FEATURES
    colour += paintLight(paint);
#endif
    gl_FragColor = vec4(displayColour(applyHaze(colour, directionWorld, distanceM)), 1.0);
}
)";

} // namespace

osg::ref_ptr<osg::Shader> terrainVertexShader()
{
    return new osg::Shader(osg::Shader::VERTEX, kVertex);
}

osg::ref_ptr<osg::Program> terrainProgram(const TerrainLook& look)
{
    std::string fragment = "#version 330 compatibility\n";
    if (look.drape) fragment += "#define TERRAIN_DRAPE\n";
    if (look.layers > 0) fragment += "#define TERRAIN_LAYERS\n";
    if (look.features) fragment += "#define TERRAIN_FEATURES\n";
    if (look.cover) fragment += "#define TERRAIN_COVER\n";
    if (look.season) fragment += "#define TERRAIN_SEASON\n";
    if (look.sheets > 0) fragment += "#define TERRAIN_SHEETS\n";
    if (look.fine) fragment += "#define TERRAIN_FINE\n";
    if (look.features || look.season)
        fragment += "uniform ivec3 terrainEyeWraps; // whole 4096 m below the eye's wrapped place\n";
    fragment += Atmosphere::glslFunctions();
    fragment += kFragmentHead;
    if (look.sheets > 0) fragment += sheetNormalsGlsl(look.sheets);
    if (look.fine) fragment += fineNormalsGlsl();
    fragment += kFragmentLand;
    if (look.features) fragment += std::string(featureCellsGlsl()) + featureLinesGlsl() + featurePaintGlsl();
    if (look.layers > 0) fragment += imageryGlsl(look.layers);
    if (look.cover) fragment += coverGlsl();
    if (look.season) fragment += seasonGlsl();
    fragment += kFragmentMain;
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("terrain");
    program->addShader(terrainVertexShader());
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
    return program;
}

} // namespace osgTerrainROAM
