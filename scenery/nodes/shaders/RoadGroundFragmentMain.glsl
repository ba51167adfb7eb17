// SPDX-License-Identifier: Apache-2.0
// Shades verges and lanes of grass as the ground beside them. Along the lanes the verge is gravel, with a ragged border. After the
// functions of osgRoads and of the terrain.

in vec3 roadNormalInTile;

vec2 lentTilt()
{
    return normalize(roadNormalInTile).xy;
}

vec3 lentAlbedo(vec3 ground, Grain g, inout GroundKinds kinds)
{
    if (roadKind == 7)
    {
        float raggedM = roadAt.y + 1.3 * g.metres2.w + 0.9 * g.metres28.w + 0.5 * g.metres2.z;
        float gravel = 0.85 * (1.0 - smoothstep(0.45, 1.05, raggedM));
        // Beyond the gravel grass is mown, and dry.
        float mown = 0.5 * (1.0 - smoothstep(1.6, 2.4, raggedM));
        ground = mix(ground, terrainDryGrass * (1.0 + 0.7 * g.metres2.z), mown);
        ground = mix(ground, vec3(0.235, 0.215, 0.18) * (1.0 + 0.7 * g.metres2.z), gravel);
        // Here and there wheels have left the road, and pressed a rut into the grass.
        float rut = max(1.0 - abs(raggedM - 0.9) * 3.0, 0.0) * smoothstep(0.05, 0.18, g.metres28.z + 0.6 * g.metres324.w);
        ground = mix(ground, vec3(0.105, 0.085, 0.06) * (1.0 + 0.8 * g.metres2.z), 0.7 * rut);
        kinds.open = mix(kinds.open, vec4(0.1, 0.1, 0.8, 0.0), 0.7 * rut);
        kinds.open = mix(kinds.open, vec4(0.0, 1.0, 0.0, 0.0), gravel);
        kinds.other *= 1.0 - gravel;
    }
    vec3 painted = roadPainted(ground, roadFilters());
    // A line lies on the ground's blades and stones: the farther it moves the colour, the less of their relief is left.
    float bare = 1.0 - min(4.0 * distance(painted, ground), 1.0);
    kinds.open *= bare;
    kinds.other *= bare;
    return painted;
}

void main()
{
    if (!isRoadThere()) discard;
#ifndef SUN_SHADOW_MAP // depth alone
    float distanceM = length(fromEye);
    vec3 directionWorld = roadWorldFromLocal * (fromEye / distanceM);
    vec3 colour = groundRadiance(directionWorld);
    gl_FragColor = vec4(displayColour(applyHaze(colour, directionWorld, distanceM)), roadShown());
#endif
}
