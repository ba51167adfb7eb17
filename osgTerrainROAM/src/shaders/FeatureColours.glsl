// SPDX-License-Identifier: Apache-2.0
// Turns the shares of vector features into colour and light. Functions:
//   float openShare(Paint)                          share of the ground without river, road or runway
//   vec4 fieldAlbedo(vec4 ground, Paint, Grain, GroundKinds)   ground colour and share of wood, with the fields on it; what it is made of
//   vec3 pavedAlbedo(vec3 albedo, Paint, Grain)     roads, runways and their markings over everything
//   vec3 paintLight(Paint)                          radiance of lamps

uniform vec3 featureCrops[4];
uniform vec3 featureSoil;
uniform float featureLampsElsewhere; // 1: the lamps of runways are drawn as points, not painted

float openShare(Paint paint) { return 1.0 - max(max(paint.beds.x, paint.beds.y), max(paint.beds.z, paint.beds.w)); }

vec4 fieldAlbedo(vec4 ground, Paint paint, Grain g, inout GroundKinds kinds)
{
    float share = dot(paint.crops, vec4(1.0));
    float other = 1.0 - min(share, 1.0), open = openShare(paint);
    float soil = share * paint.rows.x, plants = max(share - soil, 0.0);
    kinds.open = (kinds.open * other + vec4(0.8 * plants, 0.05 * soil, 0.95 * soil, 0.0)) * open;
    kinds.open.y += paint.beds.z;
    kinds.other *= other * open;
    vec3 colour = featureCrops[0] * paint.crops.x + featureCrops[1] * paint.crops.y + featureCrops[2] * paint.crops.z
                + featureCrops[3] * paint.crops.w;
    // A field that is brighter than others is riper, too.
    float ripe = paint.rows.y - 1.0;
    colour *= vec3(1.0 + 0.9 * ripe, 1.0, 1.0 - 0.6 * ripe);
    colour = colour * (paint.rows.y * (1.0 - paint.rows.x)) + featureSoil * (share * paint.rows.x);
    colour *= 1.0 + 0.5 * g.metres2.z + 0.25 * g.metres28.z + 0.2 * g.metres324.w;
    return vec4(ground.rgb * (1.0 - min(share, 1.0)) + colour, ground.a * (1.0 - min(share, 1.0)));
}

// Lamps are on from dusk to dawn.
vec3 paintLight(Paint paint)
{
    float night = smoothstep(0.02, -0.09, sunDirection().z);
    return vec3(3.2, 2.7, 1.9) * (min(paint.marks.w, 1.5) * night * (1.0 - featureLampsElsewhere));
}

vec3 pavedAlbedo(vec3 albedo, Paint paint, Grain g)
{
    float worn = smoothstep(0.25, 0.75, paint.marks.y + 0.9 * g.metres2.w + 0.5 * g.metres28.w);
    albedo = mix(albedo, featureSoil * 1.1, worn * min(2.0 * paint.marks.y, 0.75));
    vec3 gravel = vec3(0.27, 0.245, 0.205) * (1.0 + 0.7 * g.metres2.z + 0.3 * g.metres28.z);
    albedo = mix(albedo, gravel, paint.beds.z);
    float stone = 1.0 + 0.35 * g.metres2.z + 0.15 * g.metres28.z + 0.12 * g.metres324.w;
    albedo = mix(albedo, vec3(0.145, 0.143, 0.139) * stone * (1.0 - 0.14 * paint.marks.z), paint.beds.y);
    albedo = mix(albedo, vec3(0.105, 0.105, 0.105) * stone, paint.beds.w);
    float paved = max(paint.beds.y, paint.beds.w);
    float wear = 1.0 + 0.25 * g.metres2.z;
    albedo = mix(albedo, vec3(0.60, 0.60, 0.57) * wear, min(paint.marks.x, paved) * 0.92);
    albedo = mix(albedo, vec3(0.58, 0.40, 0.05) * wear, min(paint.more.x, paved) * 0.92);
    return albedo * (1.0 - 0.55 * paint.more.y * paint.beds.w);
}
