// SPDX-License-Identifier: Apache-2.0
// A lit window before its pane, while its room is lit. Colour: its light, linear. Texture coordinates: over the pane, then seconds of the day from which
// on the room is lit, and for how long. GLSL 1.30.

out vec3 fromEye;
out vec3 light;
out vec2 across;
uniform mat4 osg_ViewMatrixInverse;
uniform float lightDayS;
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    float distanceM = max(length(inView.xyz), 0.1);
    inView.xyz *= 1.0 - min(0.3, (0.03 + 0.0015 * distanceM) / distanceM);
    fromEye = mat3(osg_ViewMatrixInverse) * inView.xyz;
    light = gl_Color.rgb;
    across = gl_MultiTexCoord0.xy;
    float since = fract((lightDayS - gl_MultiTexCoord0.z) / 86400.0) * 86400.0;
    gl_Position = since < gl_MultiTexCoord0.w ? gl_ProjectionMatrix * inView : vec4(0.0, 0.0, 2.0, 1.0);
}
