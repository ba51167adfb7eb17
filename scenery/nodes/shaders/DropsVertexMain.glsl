// SPDX-License-Identifier: Apache-2.0
// Takes a corner of a drop's streak, or of a flake, to the camera. A drop is where it is nearest to the eye of all its places one box apart.
// What is narrower than a pixel or so is drawn wider and the fainter. After the functions of the atmosphere.

uniform vec4 dropsShift;  // the way that all drops have gone, modulo the box; side of the box
uniform vec4 dropsStreak; // of a drop relative to the eye while it is seen, world; radius
uniform vec4 dropsLook;   // 1: snow
out vec3 fromEye;
out float share;
out vec2 inFlake;

void main()
{
    const float kLeastAngle = 0.0008; // half of a pixel, some
    float side = dropsShift.w;
    vec3 eye = (gl_ModelViewMatrixInverse * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
    vec3 place = gl_Vertex.xyz * side + dropsShift.xyz;
    vec3 middle = mod(place - eye + 0.5 * side, side) - 0.5 * side;
    float distanceM = length(middle);
    vec2 corner = gl_MultiTexCoord0.xy;
    float radius = dropsStreak.w * (0.7 + 0.6 * gl_MultiTexCoord0.z);
    float drawn = max(radius, kLeastAngle * distanceM);
    // The speed of a flake differs a little from its neighbour's, so it is round and not a streak.
    vec3 along = mix(dropsStreak.xyz, vec3(0.0), dropsLook.x);
    vec3 up = dropsLook.x > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(along + vec3(1e-6));
    vec3 across = normalize(cross(middle, up) + vec3(1e-6));
    vec3 upright = dropsLook.x > 0.5 ? cross(across, middle / distanceM) : up;
    vec3 ends = along * (corner.y - 0.5) + upright * drawn * (2.0 * corner.y - 1.0);
    fromEye = middle + across * (drawn * corner.x) + ends;
    inFlake = vec2(corner.x, 2.0 * corner.y - 1.0);
    share = min(radius / drawn, 1.0) * smoothstep(0.3, 0.9, distanceM) *
            (1.0 - smoothstep(0.36 * side, 0.5 * side, distanceM));
    gl_Position = gl_ModelViewProjectionMatrix * vec4(eye + fromEye, 1.0);
}
