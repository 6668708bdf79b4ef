#version 440

// A full line; dash.frag draws a dashed one. Apart, because a branch costs as much as both of its sides where there is
// no graphics card.
layout(location = 0) in vec4 place;
layout(location = 0) out vec4 fragColor;

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 shape;
    vec4 dash;
};

void main() {
    float along = clamp(place.x, 0.0, place.z);
    float away = length(vec2(place.x - along, place.y));
    fragColor = color * clamp((shape.y - away) * shape.z + 0.5, 0.0, 1.0);
}
