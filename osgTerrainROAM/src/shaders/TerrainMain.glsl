// SPDX-License-Identifier: Apache-2.0
// Shades a fragment of the terrain, with haze; leaves out those in openings.

void main()
{
#ifdef TERRAIN_OPENINGS
    if (isOpening(fromEye + terrainEyeWrapped)) discard;
#endif
#ifndef SUN_SHADOW_MAP // depth alone
    float distanceM = length(fromEye);
    vec3 directionWorld = terrainWorldFromLocal * (fromEye / distanceM);
    vec3 colour = groundRadiance(directionWorld);
    gl_FragColor = vec4(displayColour(applyHaze(colour, directionWorld, distanceM)), 1.0);
#endif
}
