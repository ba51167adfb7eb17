// SPDX-License-Identifier: Apache-2.0
// Takes the vertices of MtDrawable to the camera.
// Outputs: `fromEye`, the vector from the eye in the terrain's frame, metres; `grid`, the place on the terrain's grid.
// Vertices are whole numbers of steps: their difference to the eye is exact at any distance from the origin.

layout(location = 0) in ivec3 position; // steps
uniform ivec3 terrainEyeSteps; // the eye, in whole steps
uniform vec3 terrainEyeRest; // the rest of the eye's position, metres
uniform float terrainStep; // metres
uniform mat3 terrainEyeFromLocal;
uniform mat3x2 terrainGridFromLocal;
out vec3 fromEye;
out vec2 grid;

void main()
{
    fromEye = vec3(position - terrainEyeSteps) * terrainStep - terrainEyeRest;
    grid = terrainGridFromLocal * vec3(vec2(position.xy) * terrainStep, 1.0);
    gl_Position = gl_ProjectionMatrix * vec4(terrainEyeFromLocal * fromEye, 1.0);
}
