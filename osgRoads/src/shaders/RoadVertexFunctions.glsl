// SPDX-License-Identifier: Apache-2.0
// Takes a vertex of the road to the view. Positions are whole steps relative to the eye: exact at any distance from the origin.
// GLSL 1.30.

in ivec3 roadPosition;
in vec3 roadPlace;  // s, across, width
in vec4 roadNormal; // and how far the surface has worn off
in vec4 roadFlags;  // kind, presence, presence of right and left marks: 0 to 255
in vec3 roadRows;   // of the marks at the right and the left border, of the list of decals

uniform ivec3 roadEyeSteps;
uniform vec3 roadEyeRest;
uniform vec3 roadEyeWrapped;  // the eye, modulo the period of the grain
uniform vec4 roadLift;        // pixels as a tangent; from, full, farthest distance
uniform sampler2D roadDecals;
uniform mat3 roadEyeFromLocal;
uniform mat3 roadWorldFromLocal;

out vec3 roadFromEye;
out vec3 roadNormalWorld;
out vec3 roadAt;        // s, across, width
out vec3 roadPresence;  // of the surface, of its right and its left marks
out float roadWear;     // 1 where the road ends in the open
out vec2 roadGround;    // east and north for the grain
flat out int roadKind;
out vec2 roadPlan;      // east and north from the origin of the list of decals
flat out ivec3 roadMarkRows;

vec3 roadInView()
{
    vec3 fromEye = vec3(roadPosition - roadEyeSteps) * (1.0 / 1024.0) - roadEyeRest;
    roadGround = roadEyeWrapped.xy + fromEye.xy;
    // Far away the ground below may err by a pixel; the road stays above it.
    float distanceM = length(fromEye);
    fromEye.z += roadLift.x * distanceM * smoothstep(roadLift.y, roadLift.z, distanceM);
    roadFromEye = roadWorldFromLocal * fromEye;
    roadNormalWorld = roadWorldFromLocal * roadNormal.xyz;
    roadWear = max(roadNormal.w, 0.0);
    roadAt = roadPlace;
    roadPresence = roadFlags.yzw * (1.0 / 255.0);
    roadKind = int(roadFlags.x + 0.5);
    roadMarkRows = ivec3(roadRows + 0.5);
    roadPlan = vec2(0.0);
    if (roadMarkRows.z > 0)
    {
        // Origins lie on a grid of 64 m, which is 65536 steps.
        ivec2 cell = ivec2(texelFetch(roadDecals, ivec2((roadMarkRows.z & 255) * 4, roadMarkRows.z >> 8), 0).xy);
        roadPlan = vec2(roadPosition.xy - cell * 65536) * (1.0 / 1024.0);
    }
    return roadEyeFromLocal * fromEye;
}
