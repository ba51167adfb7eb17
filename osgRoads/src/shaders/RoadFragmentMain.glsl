// SPDX-License-Identifier: Apache-2.0
// Lights the road by light 0, as fixed function lights a diffuse surface.

in vec3 roadNormalInView;
void main()
{
    vec3 normal = normalize(roadNormalInView);
    vec3 towards = normalize(gl_LightSource[0].position.xyz);
    float light = 0.35 + 0.65 * max(dot(normal, towards), 0.0);
    gl_FragColor = vec4(sqrt(roadAlbedo() * light), roadShown());
}
