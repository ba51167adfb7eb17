// SPDX-License-Identifier: Apache-2.0
// The light of a PAPI unit: a square that looks at the eye, as the glow about a lamp. White where the eye stands above the unit's angle
// and red below, with three minutes of arc between. Normal: towards the approach. Vertex colour: alpha is the angle in degrees. GLSL 1.30.

out vec3 fromEye;
out vec3 light;
out vec2 across;
uniform mat4 osg_ViewMatrixInverse;
const float kLeastRadiansWide = 0.0030;
const float kHalfChangeDeg = 0.025;
const float kBright = 9.0; // seen by day, too
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    float distanceM = max(length(inView.xyz), 0.1);
    vec3 toEye = -inView.xyz / distanceM;
    vec3 towards = mat3(osg_ViewMatrixInverse) * toEye;
    float angleDeg = degrees(asin(clamp(towards.z, -1.0, 1.0)));
    float white = smoothstep(-kHalfChangeDeg, kHalfChangeDeg, angleDeg - gl_Color.a);
    float seen = smoothstep(0.85, 0.95, dot(normalize(gl_NormalMatrix * gl_Normal), toEye));
    light = mix(vec3(1.0, 0.03, 0.01), vec3(1.0, 0.95, 0.88), white) * seen * kBright;
    float wide = max(gl_MultiTexCoord0.z, kLeastRadiansWide * distanceM);
    across = gl_MultiTexCoord0.xy;
    inView.xyz += toEye * min(0.3, 0.3 * distanceM);
    inView.xy += across * wide;
    fromEye = mat3(osg_ViewMatrixInverse) * inView.xyz;
    gl_Position = gl_ProjectionMatrix * (seen > 0.0 ? inView : vec4(0.0, 0.0, 1.0, 1.0));
}
