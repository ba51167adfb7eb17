// SPDX-License-Identifier: Apache-2.0
// Takes the vertices of RoamDrawable to the camera and clips them at the last sample of the data.
// Outputs: `fromEye`, the vector from the eye in the tile's frame, metres; `grid`, the grid position in samples.
// Vertices are whole numbers of steps: their difference to the eye is exact at any distance from the origin.

#version 330 compatibility
layout(location = 0) in ivec3 position; // steps
layout(location = 1) in vec2 gridBits; // the lower 16 bits of each grid coordinate
uniform ivec3 terrainEyeSteps; // the eye, in whole steps
uniform vec3 terrainEyeRest; // the rest of the eye's position, metres
uniform float terrainStep; // metres
uniform mat3 terrainEyeFromLocal;
uniform mat3x2 terrainGridFromLocal; // approximate; gridBits give the exact value
uniform vec2 terrainLastSample;
uniform float terrainLift; // added height per metre of distance: 0, except beyond the data (Surroundings.cpp)
out vec3 fromEye;
out vec2 grid;

void main()
{
    fromEye = vec3(position - terrainEyeSteps) * terrainStep - terrainEyeRest;
    fromEye.z += terrainLift * length(fromEye);
    vec2 near = terrainGridFromLocal * vec3(vec2(position.xy) * terrainStep, 1.0);
    grid = gridBits + 65536.0 * round((near - gridBits) * (1.0 / 65536.0));
    gl_Position = gl_ProjectionMatrix * vec4(terrainEyeFromLocal * fromEye, 1.0);
    gl_ClipDistance[0] = terrainLastSample.x - grid.x;
    gl_ClipDistance[1] = terrainLastSample.y - grid.y;
}
