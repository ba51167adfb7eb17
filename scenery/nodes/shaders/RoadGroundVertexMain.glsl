// SPDX-License-Identifier: Apache-2.0
// Takes a vertex of a strip of grass to the camera, and tells where it lies on the terrain. After RoadVertexFunctions.glsl.

uniform vec2 roadGridOrigin;   // grid coordinates of the mesh's origin
uniform vec4 roadGridFromPlan; // of a metre east, of a metre north
out vec3 fromEye;
out vec2 grid;
out vec3 roadNormalInTile;

void main()
{
    vec3 inView = roadInView();
    vec2 plan = vec2(roadPosition.xy) * (1.0 / 1024.0);
    grid = roadGridOrigin + roadGridFromPlan.xy * plan.x + roadGridFromPlan.zw * plan.y;
    fromEye = vec3(roadPosition - roadEyeSteps) * (1.0 / 1024.0) - roadEyeRest;
    roadNormalInTile = roadNormal.xyz;
    gl_Position = gl_ProjectionMatrix * vec4(inView, 1.0);
}
