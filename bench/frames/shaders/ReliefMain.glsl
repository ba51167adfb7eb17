// SPDX-License-Identifier: Apache-2.0
// Shades the terrain with one grey albedo and the full normal map, so that levels of detail differ in triangles alone.

in vec3 fromEye;
in vec2 grid;
uniform sampler2D terrainNormals;
uniform vec4 terrainMapFromGrid;
uniform mat3 terrainWorldFromLocal;

void main()
{
    float distanceM = length(fromEye);
    vec3 directionWorld = terrainWorldFromLocal * (fromEye / distanceM);
    vec2 tilt = texture(terrainNormals, grid * terrainMapFromGrid.xy + terrainMapFromGrid.zw).rg * 2.0 - 1.0;
    vec3 normalWorld = terrainWorldFromLocal * normalize(vec3(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.02))));
    vec3 light = lightOn(normalWorld, max(dot(normalWorld, sunDirection()), 0.0), 1.0);
    gl_FragColor = vec4(displayColour(applyHaze(0.18 * light, directionWorld, distanceM)), 1.0);
}
