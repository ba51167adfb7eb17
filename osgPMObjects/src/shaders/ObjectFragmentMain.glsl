// SPDX-License-Identifier: Apache-2.0
// Lights a fragment as the fixed functions do with one light and one texture, for objects without a program of their own.

in vec3 normalInView;
in vec3 inView;
in vec4 colour;
in vec2 textureAt;
uniform sampler2D pmTexture;
void main()
{
    float alpha = pmAlpha();
    vec3 normal = normalize(normalInView);
    vec4 light = gl_LightSource[0].position;
    vec3 towards = normalize(light.w == 0.0 ? light.xyz : light.xyz - inView);
    vec3 ambient = gl_LightModel.ambient.rgb + gl_LightSource[0].ambient.rgb;
    vec3 diffuse = max(dot(normal, towards), 0.0) * gl_LightSource[0].diffuse.rgb;
    vec4 paint = colour * texture(pmTexture, textureAt);
    gl_FragColor = vec4(min(paint.rgb * (ambient + diffuse), vec3(1.0)), paint.a * alpha);
}
