// SPDX-License-Identifier: Apache-2.0
// The glow about a lamp: a square that looks at the eye. It is as large as its texture coordinates say, but at least as large as
// the eye makes any far light: so a lamp of some centimetres is seen over kilometres. Vertex colour: its light and, as alpha, the cosine of half the angle
// in which it shines. Normal: the middle of that angle. GLSL 1.30.

out vec3 fromEye;
out vec3 light;
out vec2 across;
uniform mat4 osg_ViewMatrixInverse;
uniform float lightLevels[12]; // of light points: they take the place of far glow where those of vehicles shine
const float kLeastRadiansWide = 0.0040; // half the width of the square
const float kNearer = 0.15; // metres towards the eye: before its own lens
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    float distanceM = max(length(inView.xyz), 0.1);
    vec3 toEye = -inView.xyz / distanceM;
    float cosine = dot(normalize(gl_NormalMatrix * gl_Normal), toEye);
    float edge = gl_Color.a;
    float seen = edge <= -1.0 ? 1.0 : smoothstep(edge - 0.08, edge + 0.12, cosine);
    seen *= 1.0 - lightLevels[11] * smoothstep(60.0, 200.0, distanceM);
    float wide = max(gl_MultiTexCoord0.z, kLeastRadiansWide * distanceM);
    // A far lamp is as bright in all as it would be in its own size, down to a least brightness: eyes and cameras spread light.
    float spread = max(gl_MultiTexCoord0.z / wide, 0.35);
    light = gl_Color.rgb * seen * spread;
    across = gl_MultiTexCoord0.xy;
    inView.xyz += toEye * min(kNearer, 0.3 * distanceM);
    inView.xy += across * wide;
    fromEye = mat3(osg_ViewMatrixInverse) * inView.xyz;
    gl_Position = gl_ProjectionMatrix * (seen > 0.0 ? inView : vec4(0.0, 0.0, 1.0, 1.0));
}
