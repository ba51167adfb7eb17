// SPDX-License-Identifier: Apache-2.0
// Draws land cover, a raster of classes (CoverTexture.h). Neighbouring texels are blended; the grain bends the borders of
// classes, so that the raster's steps do not show. Functions:
//   Cover terrainCover(vec2 grid, vec2 place, Grain)     the classes at a grid position, blended
//   vec4 coveredGround(vec4 ground, Cover, Grain, GroundKinds)   ground colour and share of wood; what it is made of
//   vec3 townLight(Cover, vec2 place, vec2 x, vec2 y)    radiance of a town's lamps at night; `place`: wrapped position

uniform sampler2D terrainCover2D; // class / 255; mip levels by majority
uniform vec4 coverFromGrid;
uniform int coverLevels;
uniform vec4 coverAlbedo[15];     // rgb, and the share of wood
uniform vec4 coverPatch[15];      // rgb of patches, and their share
uniform vec4 coverOpen[15];       // what the kind is made of near by: grass, stones, earth, rock (GroundMakeup.h)
uniform float coverLitter[15];    // and litter
uniform vec4 coverBend;           // by how many texels each layer of the grain bends borders

struct Cover
{
    vec3 albedo, patched;
    float wood, patches;
    float known; // share of texels whose class is known
    float snow, water, town;
    vec4 open; // GroundKinds
    float litter;
};

void addCover(inout Cover cover, int kind, float weight)
{
    if (kind == 0) return;
    cover.known += weight;
    cover.open += weight * coverOpen[kind];
    cover.litter += weight * coverLitter[kind];
    cover.albedo += weight * coverAlbedo[kind].rgb;
    cover.wood += weight * coverAlbedo[kind].a;
    cover.patched += weight * coverPatch[kind].rgb;
    cover.patches += weight * coverPatch[kind].a;
    cover.snow += kind == 8 ? weight : 0.0;
    cover.water += kind == 9 ? weight : 0.0;
    cover.town += kind == 11 ? weight : 0.0;
}

// How many texels borders are bent by at a place. Of the grain of 28 m what is coarser than a metre: its fine bumps would move places that are
// centimetres apart by metres, and strew each kind over the other.
vec2 bendOfCover(vec2 place, Grain g)
{
    const float kCoarse = 5.0; // mip level
    vec2 at = vec2(2.0 * place.x + place.y, 2.0 * place.y - place.x) * (1.0 / 64.0);
    vec2 x = dFdx(at), y = dFdy(at);
    float level = max(0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-12)) + kGrainLevels, kCoarse);
    vec2 broad = textureLod(terrainGrain, at, level).xy - 0.5;
    return g.metres2.xy * coverBend.x + broad * coverBend.y + g.metres324.xy * coverBend.z + g.metres4700.xy * coverBend.w;
}

Cover terrainCover(vec2 grid, vec2 place, Grain g)
{
    vec2 part = grid * coverFromGrid.xy + coverFromGrid.zw;
    vec2 texels = vec2(textureSize(terrainCover2D, 0));
    vec2 x = dFdx(part) * texels, y = dFdy(part) * texels;
    // The span is the geometric mean of the footprint's length and width.
    float span = sqrt(abs(x.x * y.y - x.y * y.x));
    int level = int(clamp(log2(max(span, 1e-3)) + 1.0, 0.0, float(coverLevels - 1)));
    ivec2 size = textureSize(terrainCover2D, level);
    vec2 bend = bendOfCover(place, g);
    vec2 at = part * vec2(size) - 0.5 + bend * exp2(-float(level));
    Cover cover = Cover(vec3(0.0), vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, vec4(0.0), 0.0);
#ifdef PICTURE_LOW
    float nearest = textureLod(terrainCover2D, (floor(at + 0.5) + 0.5) / vec2(size), float(level)).r;
    addCover(cover, min(int(nearest * 255.0 + 0.5), 14), 1.0);
#else
    ivec2 cell = ivec2(floor(at));
    vec2 f = smoothstep(0.25, 0.75, at - vec2(cell));
    for (int i = 0; i < 4; ++i)
    {
        ivec2 corner = ivec2(i & 1, i >> 1);
        float weight = (corner.x == 1 ? f.x : 1.0 - f.x) * (corner.y == 1 ? f.y : 1.0 - f.y);
        // Sampled, not fetched: where neighbouring pixels differ in level, the sample still comes from this position.
        float code = textureLod(terrainCover2D, (vec2(cell + corner) + 0.5) / vec2(size), float(level)).r;
        addCover(cover, min(int(code * 255.0 + 0.5), 14), weight);
    }
#endif
    return cover;
}

vec4 coveredGround(vec4 ground, Cover cover, Grain g, inout GroundKinds kinds)
{
    if (cover.known <= 0.0) return ground;
    float known = min(cover.known, 1.0);
    kinds.open = mix(kinds.open, cover.open / cover.known, known);
    kinds.other = mix(kinds.other, vec2(0.0, cover.litter / cover.known), known);
    float low = 0.5 + 0.5 * (0.5 - cover.patches / cover.known);
    float noise = 0.5 + 0.9 * g.metres28.w + 0.7 * g.metres324.w + 0.4 * g.metres2.w;
    vec3 colour = mix(cover.albedo, cover.patched, smoothstep(low - 0.12, low + 0.12, noise)) / cover.known;
    float speckle = 1.1 * g.metres2.z + 0.65 * g.metres28.z + 0.45 * g.metres324.z + 0.35 * g.metres4700.z;
    float wood = cover.wood / cover.known;
    colour *= max(1.0 + speckle * (0.8 + 0.7 * wood), 0.25);
    return mix(ground, vec4(colour, wood), min(cover.known, 1.0));
}

// Each square of 32 m has one lamp at a random position. A lamp is a point of the image; from afar its mean counts.
vec3 lampsOf(float share, vec2 place, vec2 x, vec2 y)
{
    vec2 cell = floor(place / 32.0);
    vec2 wrapped = mod(cell, 128.0);
    float h = fract(sin(dot(wrapped, vec2(12.9898, 78.233))) * 43758.5453);
    vec2 lamp = (cell + 0.2 + 0.6 * vec2(h, fract(h * 57.31))) * 32.0;
    vec2 from = place - lamp;
    float area = x.x * y.y - x.y * y.x;
    vec2 pixels = vec2(from.x * y.y - from.y * y.x, from.y * x.x - from.x * x.y) / (abs(area) > 1e-9 ? area : 1e-9);
    float spot = exp(-1.2 * dot(pixels, pixels)) + 0.05 * exp(-0.08 * dot(pixels, pixels));
    float fine = 1.0 - smoothstep(6.0, 16.0, max(length(x), length(y)));
    float glow = 0.004 + 0.06 * exp(-dot(from, from) / 60.0);
    return mix(vec3(3.0, 2.1, 1.1), vec3(2.6, 2.6, 2.4), step(0.75, fract(h * 11.7)))
         * (share * (mix(0.03, spot, fine) + glow));
}

vec3 townLight(Cover cover, vec2 place, vec2 x, vec2 y)
{
    float share = cover.town * smoothstep(0.02, -0.09, sunDirection().z);
    vec3 light = vec3(0.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = share > 0.0 ? 0 : 1; i < 1; ++i)
        light = lampsOf(share, place, x, y);
    return light;
}
