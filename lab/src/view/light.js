// How surfaces are lit: one light from above and the left of the first view, as in the films.
import { Matrix3, Vector2, Vector3 } from "three";

/** Towards the light, world. */
export const LIGHT = new Vector3(0.5, -0.42, 0.85).normalize();

/** What all materials share: the light, how normals turn from the data's world to the drawn one, the picture's size, px. */
export const sharedUniforms = () => ({
  uLight: { value: LIGHT }, uTurn: { value: new Matrix3() }, uViewport: { value: new Vector2(1, 1) },
  uEye: { value: new Vector3() },
});

/** GLSL: a colour, lit. Ambient, diffuse and a little shine, in the page's own colours. */
export const LIT = /* glsl */ `
  uniform vec3 uLight;
  uniform vec3 uEye;
  vec3 lit(vec3 colour, vec3 normal, vec3 at, float shine) {
    vec3 halfway = normalize(uLight + normalize(uEye - at));
    float matt = 0.56 + 0.06 * normal.z + 0.46 * max(dot(normal, uLight), 0.0);
    return colour * matt + shine * pow(max(dot(normal, halfway), 0.0), 36.0);
  }
`;
