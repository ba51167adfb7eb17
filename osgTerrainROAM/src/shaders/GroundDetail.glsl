// SPDX-License-Identifier: Apache-2.0
// The ground within some tens of metres of the eye: blades, stones, clods, cracks, leaves, down to 5 mm, by slopes, heights and brightness
// (DetailImages.h). After Grain. Functions:
//   float coarseShare(float distanceM)   the share of the grain of 2 m beside it
//   vec4 groundDetail(GroundKinds, vec2 place, vec2 alongX, vec2 alongY, vec3 fromEye)   slopes, height, brightness; 0 in the mean
// PICTURE_LOW leaves it out; PICTURE_MEDIUM has one sample in place of up to six, and no parallax.

// What the ground is made of, each a share.
struct GroundKinds
{
    vec4 open;  // grass, stones, earth, rock
    vec2 other; // snow, litter
};

#if defined(PICTURE_LOW) || defined(TERRAIN_SURROUNDINGS)
float coarseShare(float distanceM) { return 1.0; }
vec4 groundDetail(GroundKinds kinds, vec2 place, vec2 alongX, vec2 alongY, vec3 fromEye) { return vec4(0.0); }
#else
uniform sampler2DArray terrainDetail;

const float kDetailPeriodM = 1.28;
const float kDetailTexels = 256.0;
const float kDetailGoneM = 80.0;
const float kDetailHeightM = 0.06;
const float kDetailSlope = 2.0;

// The share of the grain of 2 m that is left where the detail is seen in its place.
float coarseShare(float distanceM) { return mix(0.4, 1.0, smoothstep(0.1 * kDetailGoneM, 0.7 * kDetailGoneM, distanceM)); }

// Filters one surface along the footprint: `way`: its length in periods, over `samples`.
vec4 detailOf(float layer, vec2 at, vec2 way, float samples, float level)
{
    vec4 sum = vec4(0.0);
    vec2 stride = way / samples;
    at -= stride * (0.5 * samples - 0.5);
    for (float i = 0.0; i < samples; ++i)
    {
        sum += textureLod(terrainDetail, vec3(at, layer), level);
        at += stride;
    }
    return sum / samples - 0.5;
}

vec4 groundDetail(GroundKinds kinds, vec2 place, vec2 alongX, vec2 alongY, vec3 fromEye)
{
#ifdef PICTURE_MEDIUM
    const float kMostSamples = 1.0;
#else
    const float kMostSamples = 3.0;
#endif
    float share[6] = float[6](kinds.open.x, kinds.open.y, kinds.open.z, kinds.open.w, kinds.other.x, kinds.other.y);
    float distanceM = length(fromEye);
    float shown = 1.0 - smoothstep(0.4 * kDetailGoneM, kDetailGoneM, distanceM);
    bool isWide = dot(alongX, alongX) > dot(alongY, alongY);
    vec2 way = (isWide ? alongX : alongY) / kDetailPeriodM;
    float length1 = max(length(way), 1e-9);
    float across = abs(alongX.x * alongY.y - alongX.y * alongY.x) / (kDetailPeriodM * kDetailPeriodM * length1);
    float span = max(across, length1 / kMostSamples);
    float level = log2(span * kDetailTexels);
    float samples = clamp(ceil(length1 / span - 0.1), 1.0, kMostSamples);
    vec2 at = place / kDetailPeriodM;
    vec4 sum = vec4(0.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = shown > 0.0 ? 0 : 6; i < 6; ++i)
        for (int j = share[i] > 0.02 ? 0 : 1; j < 1; ++j)
        {
            float layer = float(i);
#ifdef PICTURE_MEDIUM
            sum += share[i] * detailOf(layer, at, way, samples, level);
#else
            // One step of parallax: the higher the surface, the nearer to the eye it is met.
            float high = textureLod(terrainDetail, vec3(at, layer), level).b - 0.5;
            vec2 lean = fromEye.xy / min(fromEye.z, -0.35 * distanceM);
            vec2 met = at + lean * (high * kDetailHeightM / kDetailPeriodM);
            // A second, turned and wider one over it: neither repeats visibly.
            mat2 turned = mat2(0.4, -0.2, 0.2, 0.4);
            sum += (0.75 * share[i]) * detailOf(layer, met, way, samples, level)
                 + (0.55 * share[i]) * detailOf(layer, turned * met, turned * way, samples, level - 1.16);
#endif
        }
    return sum * vec4(2.0 * kDetailSlope, 2.0 * kDetailSlope, kDetailHeightM, 3.0) * shown;
}
#endif
