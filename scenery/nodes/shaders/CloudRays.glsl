// SPDX-License-Identifier: Apache-2.0
// Goes through the layers of clouds along a pixel's ray; gives display colour and share of what it hides, and distance. Empty space is passed in steps
// as long as the raster says that it is empty (Hart, Sphere tracing, 1996). Where a cloud begins is carved by finer noise (Schneider & Vos 2015).
// A thick cloud throws light back as a white surface nearly does: what faces the sun is brighter than what is turned away, which shows its form.

in vec3 direction;
in vec2 place;
uniform sampler3D cloudVolume; // edge at 128/255, sun and sky that arrive, gap
uniform sampler3D cloudDetail;
uniform int cloudLayers;
uniform vec4 cloudSlab[3];   // base, top in the world, extinction per metre, sharpness
uniform vec2 cloudDrift;     // metres
uniform vec3 cloudSun;       // irradiance above the clouds
uniform int cloudSteps;

const float kTileM = 20480.0, kSlices = 16.0, kGapM = 8.0 * 255.0;
const float kFarM = 45000.0; // clouds farther off are in the haze

const float kBodyM = 70.0; // over which the form of a cloud's surface is looked at

// A ray on its way: what is left of its light, what it has gathered, and that light's mean distance times what is gone; the shares of sun and sky
// that the surface which it met last gets by the way that it faces, 0: it has met none.
struct Ray
{
    vec3 colour;
    float left;
    float away;
    vec2 facing;
};

// A place in the raster of a layer, from 0 at the base to 1 at the top. Frame: the world.
vec3 placeInLayer(int layer, vec3 at, float height)
{
    return vec3((at.xy - cloudDrift) / kTileM, (float(layer) + clamp(height, 0.5 / kSlices, 1.0 - 0.5 / kSlices)) / float(cloudLayers));
}

float heightIn(vec4 slab, vec3 at) { return clamp((at.z - slab.x) / (slab.y - slab.x), 0.0, 1.0); }

// What finer noise takes of the cloud near its edge, at a place and a distance; coarse far off, where it would only be more noise.
float carvedAway(vec3 at, float within, float away, float sharpness)
{
    float carved = 0.22 * (textureLod(cloudDetail, vec3(at.xy - cloudDrift, at.z) / 640.0, 0.0).r - 0.45);
    return carved * clamp(1.0 - away / 25000.0, 0.0, 1.0) * min(sharpness / 8.0, 1.0) * (1.0 - clamp(within * 2.0, 0.0, 1.0));
}

// How far a place is within a cloud: 0 at its edge, negative outside.
float depthWithin(int layer, vec4 slab, vec3 at, float away)
{
    float within = (textureLod(cloudVolume, placeInLayer(layer, at, heightIn(slab, at)), 0.0).r * 255.0 - 128.0) / 127.0;
    return within - carvedAway(at, within, away, slab.w);
}

// The shares of sun and sky that the surface of a cloud gets by the way that it faces.
// Source: for thick clouds, Kokhanovsky, Cloud Optics (2006), section 3: what comes back grows with the sun's height over the surface as 3/7 (1 + 2 cosine).
vec2 facingLight(int layer, vec4 slab, vec3 at, float away)
{
    float here = depthWithin(layer, slab, at, away);
    vec3 inwards = vec3(depthWithin(layer, slab, at + vec3(kBodyM, 0.0, 0.0), away), depthWithin(layer, slab, at + vec3(0.0, kBodyM, 0.0), away),
                        depthWithin(layer, slab, at + vec3(0.0, 0.0, kBodyM), away)) - here;
    vec3 outwards = -inwards / max(length(inwards), 1e-4);
    float thick = min(slab.w / 8.0, 1.0);
    vec2 shares = vec2(0.43 * (1.0 + 2.0 * max(dot(outwards, sunDirection()), -0.1)), 0.75 + 0.25 * outwards.z);
    return mix(vec2(1.0), shares, thick);
}

// Sheets thin out upwards, so that who climbs out of one is not in the light at once; heaps have firm tops. `height`: 0 ... 1 in the layer.
float topOf(vec4 slab, float height)
{
    const float kThinning = 0.12; // of the height of the layer
    float sheet = clamp(2.0 - slab.w / 4.0, 0.0, 1.0);
    return mix(1.0, smoothstep(0.0, kThinning, 1.0 - height), sheet);
}

void throughLayer(int layer, vec3 eye, vec3 towards, float jitter, inout Ray ray)
{
    vec4 slab = cloudSlab[layer];
    float rise = abs(towards.z) < 1e-4 ? 1e-4 : towards.z;
    float atBase = (slab.x - eye.z) / rise, atTop = (slab.y - eye.z) / rise;
    float t = max(min(atBase, atTop), 0.0), end = min(max(atBase, atTop), kFarM);
    float sine = max(dot(towards, sunDirection()), 0.0);
    float s2 = sine * sine, s4 = s2 * s2, s16 = s4 * s4 * s4 * s4;
    // Light goes on forwards: thin edges before the sun shine.
    vec3 sun = cloudSun * (0.80 + 0.25 * s4 + 1.1 * s16);
    vec3 fromSky = ambientLight(vec3(0.0, 0.0, 1.0)), fromGround = ambientLight(vec3(0.0, 0.0, -1.0));
    t += jitter * max(30.0, 0.012 * t);
    for (int i = 0; i < cloudSteps; ++i)
    {
        if (t >= end || ray.left < 0.02) break;
        float stride = max(30.0, 0.016 * t);
        vec3 at = eye + t * towards;
        float height = heightIn(slab, at);
        vec4 found = textureLod(cloudVolume, placeInLayer(layer, at, height), 0.0);
        float gap = found.a * kGapM - 60.0;
        if (gap > stride)
        {
            t += gap;
            ray.facing = vec2(0.0); // the next cloud has a surface of its own
            continue;
        }
        float within = (found.r * 255.0 - 128.0) / 127.0;
        within -= carvedAway(at, within, t, slab.w);
        float density = clamp(within * slab.w, 0.0, 1.0) * smoothstep(0.0, 0.03, height) * topOf(slab, height);
        float hidden = 1.0 - exp(-slab.z * density * stride);
        if (ray.facing.x == 0.0 && hidden > 0.0) ray.facing = facingLight(layer, slab, at, t);
        vec3 lit = sun * (found.g * ray.facing.x) + mix(fromGround, fromSky, 0.35 + 0.65 * height) * ((0.30 + 0.70 * found.b) * ray.facing.y);
        ray.colour += ray.left * hidden * lit;
        ray.away += ray.left * hidden * t;
        ray.left *= 1.0 - hidden;
        t += stride;
    }
}

void main()
{
    vec3 towards = normalize(direction);
    vec3 eye = osg_ViewMatrixInverse[3].xyz;
    // A pattern that neighbours average away. Source: Jimenez, Next generation post processing in Call of Duty: Advanced Warfare (2014).
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    Ray ray = Ray(vec3(0.0), 1.0, 0.0, vec2(0.0));
    for (int i = 0; i < cloudLayers; ++i)
        throughLayer(towards.z > 0.0 ? i : cloudLayers - 1 - i, eye, towards, jitter, ray);
    float hidden = 1.0 - ray.left;
    float away = hidden > 1e-3 ? ray.away / hidden : kFarM;
    hidden *= 1.0 - smoothstep(0.55 * kFarM, 0.95 * kFarM, away);
    vec3 seen = applyHaze(ray.colour / max(1.0 - ray.left, 1e-3), towards, away);
    gl_FragData[0] = vec4(displayColour(seen) * hidden, hidden);
    gl_FragData[1] = vec4(away);
}
