// SPDX-License-Identifier: Apache-2.0
// Colours dry land by vegetation, steepness and height. The rules and their limits were chosen by eye.

// Returns the colour of dry land without snow, and in alpha the share of wood; `kinds`: what it is made of.
vec4 groundColour(float green, float steep, float heightM, Grain g, out GroundKinds kinds)
{
    green += 0.50 * g.metres324.w + 0.36 * g.metres28.w + 0.60 * g.metres4700.w + 0.20 * g.metres2.w;
    float grown = smoothstep(0.22, 0.42, green);
    vec3 colour = mix(terrainSoil, terrainDryGrass, grown);
    colour = mix(colour, terrainMeadow, smoothstep(0.45, 0.62, green));
    float wood = smoothstep(0.68, 0.80, green + 0.10 * g.metres28.z);
    colour = mix(colour, terrainForest, wood);

    float bare = steep + 0.30 * g.metres28.w + 0.24 * g.metres324.w + 0.16 * (0.35 - green);
    float rock = smoothstep(0.22, 0.34, bare) * (1.0 - 0.55 * wood);
    // Beds of rock are bands over the height, bent by the noise.
    float bed = heightM * 0.045 + 2.2 * g.metres324.w + 0.8 * g.metres28.w;
    vec3 rockColour = terrainRock * (1.0 + terrainStrata * (0.6 * sin(bed) + 0.4 * sin(bed * 2.7 + 1.3)));
    colour = mix(colour, rockColour, rock);

    float rockless = 1.0 - rock;
    kinds.open = vec4(grown * (1.0 - wood), 0.15 * (1.0 - grown), (1.0 - grown) * 0.85, 0.0) * rockless;
    kinds.open.w = rock;
    kinds.other = vec2(0.0, wood * rockless);

    float speckle = 1.1 * g.metres2.z + 0.65 * g.metres28.z + 0.45 * g.metres324.z + 0.35 * g.metres4700.z;
    return vec4(colour * max(1.0 + speckle * (1.0 + 0.7 * wood), 0.25), wood * (1.0 - rock));
}
